// A single equation in one of the scalars, asked as an implementation is.
#pragma once

#include <string_view>

#include "properties/implementation.hpp"

namespace tps::properties {

/// What `tps eval` computes in the scalar. Refused where a number or a result is outside its range, or the
/// equation has no answer; skipped for what is no equation to be judged: eq. (2) as printed.
Answer ask_equation(const Question& question, std::string_view scalar);

}  // namespace tps::properties

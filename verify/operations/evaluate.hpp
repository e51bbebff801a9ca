// One operation on given numbers in a chosen scalar.
#pragma once

#include <string_view>

#include "verify/operations/input.hpp"
#include "verify/operations/report.hpp"

namespace tps::operations {

/// Evaluates in `Scalar`; `name` is what messages call it. Throws NoAnswer where the scalar cannot hold a
/// number or a result, and where eq. (5) is asked of a pair without tangential motion.
/// Instantiated for the six scalars of the program, each in its own source.
template <typename Scalar>
Report evaluate_in(const Operation& operation, const Input& input, std::string_view name, Detail detail);

/// The same by the scalar's name. REQUIRES is_of_numbers() and one of scalar_names() (reference/run/run.hpp).
Report evaluate(const Operation& operation, const Input& input, std::string_view scalar,
                Detail detail = Detail::everything);

}  // namespace tps::operations

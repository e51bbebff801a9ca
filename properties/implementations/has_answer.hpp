// Whether somebody may refuse a question.
#pragma once

#include "properties/implementation.hpp"

namespace tps::properties {

/// Whether real arithmetic has an answer to the question, and the format holds it. By the certified answers;
/// a distance, which they do not have, is a number of the size of its case. A pair at rest asks no response
/// of a tether.
bool has_answer(const Question& question, const Format& format);

}  // namespace tps::properties

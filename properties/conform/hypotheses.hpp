// What known mistakes answer: a wrong answer that equals one of these says where to look.
#pragma once

#include <string>
#include <vector>

#include "properties/conform/known_question.hpp"

namespace tps::properties::conform {

/// Of an answer that is the one to the question before, from which this one differs in one number.
constexpr const char* kRemembered = "the answer to another question: remembered by too few of its numbers";

/// The mistakes whose answer this is, and the right one is not: "the larger root". Equal is within 10⁻⁹ of
/// the size, apart beyond 10⁻⁷ of it, so that no two of them are confused by rounding. REQUIRES an answer
/// that is not right.
std::vector<std::string> hypotheses_fitting(const KnownQuestion& known, const Json& out);

/// All names, for the page and its test.
std::vector<std::string> hypothesis_names();

}  // namespace tps::properties::conform

// Shrinking towards what a person can read: fewer dimensions, zeros, ones, small integers, few bits.
#pragma once

#include <vector>

#include "properties/case.hpp"
#include "properties/format.hpp"

namespace tps::properties {

/// Simpler cases next to this one, the boldest first. Law: every one has a smaller complexity(), so shrinking
/// ends; and its numbers are of the format and of their kinds.
std::vector<Case> simpler(const Case& c, const Format& format);

/// How much there is to read.
double complexity(const Case& c);

}  // namespace tps::properties

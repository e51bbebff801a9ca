// From an answer to its class (docs/conform.md).
#pragma once

#include <string>

#include "properties/conform/answer_class.hpp"
#include "properties/conform/expected.hpp"

namespace tps::properties::conform {

struct Grade {
  Class which = Class::right;
  std::string why;   ///< in words; empty where it is right
  double units = 0;  ///< the error of the worst result in units 2^-bits of its size
  double cond = 0;   ///< its condition number
};

/// The class of an answer. `stable` is the reference in the same numbers: where it misses a response as well,
/// the precision is at fault. REQUIRES not failed, not skipped.
Grade grade(const KnownQuestion& known, const Answer& answer, const Format& format, Implementation& stable);

/// Whether products of four of the question's numbers may leave the range of the format.
bool leaves_range(const Question& question, const Format& format);

}  // namespace tps::properties::conform

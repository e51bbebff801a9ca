// Stage 1 of the verdict and the fast path of the time, for four queries at once (docs/exact.md, "Many
// queries").
#pragma once

#include <array>

#include "verify/exact/timing_query.hpp"

namespace tps::exact {

/// Of the four queries, bit k is of the k-th. Signs as stage 1 knows them; neither bit where it does not.
struct FourAnswers {
  struct Signs {
    unsigned negative, positive;
  };
  Signs h, c, D;
  unsigned in_range;
  /// Whether `hit` or `turning` is the rounded time of a query with that verdict.
  unsigned hit_is_proven, turning_is_proven;
  double hit[4], turning[4];
};

/// Whether this program and the processor have registers of four doubles, with fma (AVX2).
bool has_registers_of_four();

/// What double_coefficients(), and refined_time() of approximate_time(), say of each, bit by bit.
/// REQUIRES has_registers_of_four(); valid queries of two particles, none of an image.
FourAnswers four_answers(const TimingQuery* queries);

}  // namespace tps::exact

// How many questions of certified timing reached which stage: the price of hard cases, not hidden.
#pragma once

#include <cstdint>

namespace tps {

/// Counts of one operation (verdict, time or order).
/// Laws: (1) exact ≤ uncertain ≤ calls; (2) uncertain − exact questions were settled by double words.
struct StageCounts {
  std::uint64_t calls = 0;  ///< questions asked
  std::uint64_t uncertain =
      0;                    ///< not settled by the first stage (a time: one Newton step), or out of its range
  std::uint64_t exact = 0;  ///< settled by integers
};

/// Counters of every filter.
struct TimingCounters {
  StageCounts verdict, time, order;
  std::uint64_t largest_bits = 0;  ///< bits of the largest integer that decided: the precision reached
};

}  // namespace tps

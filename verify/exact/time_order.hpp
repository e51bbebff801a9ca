// Which of two events comes first, exactly.
#pragma once

#include <string_view>

#include "verify/exact/counters.hpp"
#include "verify/exact/exact_verdict.hpp"
#include "verify/exact/timing_query.hpp"

namespace tps::exact {

enum class Order { before, after, equal, none };

constexpr std::string_view name(Order order) {
  constexpr std::string_view names[] = {"before", "after", "equal", "none"};
  return names[static_cast<int>(order)];
}

/// The order of the exact times of two timing queries of any kinds, at one instant.
///
/// An event that occurs is before one that does not; `none` where neither occurs; `equal` is an exact tie,
/// never a tolerance. REQUIRES valid(first), valid(second). Laws:
///   (1) time_order(second, first) is the reverse;
///   (2) time_order(q, q) is `equal`, or `none`;
///   (3) before(p, q) and before(q, r) imply before(p, r); so does equal;
///   (4) before implies that the correctly rounded times do not decrease.
Order time_order(const TimingQuery& first, const TimingQuery& second, Counters& counters);

/// The exact order of two moments of a run, whose queries are asked at instants of their own.
///
/// REQUIRES valid queries, finite hi and lo, multiples 1 or 2. Laws (1) to (3), and
///   (5) for equal starts and multiples of 1 it is time_order;
///   (6) multiplying lengths by 2^k, velocities by 2^m, hi and lo by 2^(k−m) changes nothing.
Order moment_order(const Moment& first, const Moment& second, Counters& counters);

/// A moment with the verdict on its query, for who compares it with many.
struct KnownMoment : Moment {
  VerdictWithCoefficients known{};  ///< of a query
};
KnownMoment known_moment(const Moment& moment, Counters& counters);

/// Law: as of the moments alone.
Order moment_order(const KnownMoment& first, const KnownMoment& second, Counters& counters);

}  // namespace tps::exact

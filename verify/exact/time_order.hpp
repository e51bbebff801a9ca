// Which of two events comes first, exactly.
#pragma once

#include <string_view>

#include "verify/exact/counters.hpp"
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

}  // namespace tps::exact

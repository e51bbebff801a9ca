// Other readings of the paper (docs/decisions.md) that a violation may come from: a program that follows one
// of them is told which, as it is no slip.
#pragma once

#include "verify/trace_check/context.hpp"
#include "verify/trace_check/responses.hpp"

namespace tps::check {
namespace readings {

inline constexpr const char* kLiteralRoot =
    "D1: the smaller root that is not negative, without regard to approach";
inline constexpr const char* kProduct = "D4: c_revolve θ/π taken as a product, where we take a power";
inline constexpr const char* kWallInTree =
    "D9: an infinite mass that joins the tree of the bodies loaded against it, where we ground each";
inline constexpr const char* kOwnExpiry =
    "D10: a load that expires by its own time, where a later one renews the whole tree";
inline constexpr const char* kRespondsAgain =
    "D11: a pair that is asked again at the limit where it has just responded";
inline constexpr const char* kWrongSign =
    "D12: an impulse although v_n has the wrong sign, where the event stands with Δp = 0";
inline constexpr const char* kOrder = "D13: another order of events at one time";

}  // namespace readings

/// The reading by which a recorded Δp is right; empty if none is known.
template <typename Number>
std::string reading_of_impulse(const Context<Number>& c, const EventLine<Number>& event,
                               const BodiesNow<Number>& b, const Expected<Work<Number>>& expected,
                               const Vec<Work<Number>>& dp) {
  using W = Work<Number>;
  const auto is = [&](const Response<W>& other) {
    const W bound = W(kRoundingsOfImpulse) * other.error * c.scale() + c.model.precision.smallest;
    return largest(dp - other.dp) <= bound && largest(expected.response.dp - other.dp) > bound;
  };
  PairRules<Number> rules = c.model.rules.of(b.i, b.j);
  if (event.kind == Kind::revolve) {
    rules.speed_ratio = W(rules.c_revolve) * W(rules.theta_deg) / W(180);
    if (is(by_eq5(b, rules, c.u()))) return readings::kProduct;
  }
  const bool outer = event.kind != Kind::rebound;
  if (event.kind != Kind::revolve &&
      is(by_eq4(b, outer ? rules.c_retract : rules.c_rebound, !outer, c.u()))) {
    return readings::kWrongSign;
  }
  return {};
}

}  // namespace tps::check

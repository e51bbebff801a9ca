// Other readings of the paper (docs/decisions.md) that a violation may come from: a program that follows one
// of them is told which, as it is no slip.
#pragma once

#include "verify/trace_check/context.hpp"
#include "verify/trace_check/pair_flight.hpp"
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
inline constexpr const char* kNoPull =
    "D16: no impulse where a taut pair's v_n has the wrong sign, where we revolve";

}  // namespace readings

constexpr int kRoundingsOfApproach = 8;

/// Eight of these are what rounding may make of v_n at a limit, where it should be 0.
template <typename Number>
Work<Number> unit_of_v_n(const Context<Number>& c, const BodiesNow<Number>& b) {
  using W = Work<Number>;
  const W reach = b.reach_i + b.reach_j;
  return b.speed() * (c.u() * (W(1) + reach / b.distance()) + b.blur / b.distance()) + b.drift() +
         c.model.precision.smallest;
}

/// The reading by which a recorded Δp is right; empty if none is known.
template <typename Number>
std::string reading_of_impulse(const Context<Number>& c, const EventLine<Number>& event,
                               const BodiesNow<Number>& b, const Expected<Work<Number>>& expected,
                               const Vec<Work<Number>>& dp, const Work<Number>& dp_error) {
  using W = Work<Number>;
  const auto is = [&](const Response<W>& other) {
    const W bound =
        (W(kRoundingsOfImpulse) * other.error + dp_error) * c.scale() + c.model.precision.smallest;
    return largest(dp - other.dp) <= bound && largest(expected.response.dp - other.dp) > bound;
  };
  PairRules<Number> rules = c.model.rules.of(b.i, b.j);
  if (event.kind == Kind::revolve) {
    rules.speed_ratio = W(rules.c_revolve) * W(rules.theta_deg) / W(180);
    if (is(by_eq5(b, rules, c.u()))) return readings::kProduct;
  }
  const bool may_approach = b.v_n() < W(kRoundingsOfApproach) * unit_of_v_n(c, b);
  if (event.kind == Kind::revolve && may_approach && length(dp) == W(0)) return readings::kNoPull;
  const bool outer = event.kind != Kind::rebound;
  if (event.kind != Kind::revolve &&
      is(by_eq4(b, outer ? rules.c_retract : rules.c_rebound, !outer, c.u()))) {
    return readings::kWrongSign;
  }
  return {};
}

/// The same where Δp is not recorded: by what the lighter body gains.
template <typename Number>
std::string reading_of_velocities(const Context<Number>& c, const EventLine<Number>& event,
                                  const BodiesNow<Number>& b, const Expected<Work<Number>>& expected) {
  using W = Work<Number>;
  const bool of_i = b.inverse_i >= b.inverse_j;
  const W mass = W(1) / (of_i ? b.inverse_i : b.inverse_j);
  const Vec<W> before = of_i ? b.v_i : b.v_j;
  const Vec<W> after = widened<W>(event.of(of_i ? b.i : b.j)->velocity_after);
  const W rounding = W(4) * c.u() * mass * (largest(before) + largest(after));
  return reading_of_impulse(c, event, b, expected, W(of_i ? mass : W(-mass)) * (after - before), rounding);
}

/// Of a pair that has rebounded and does so again. At once, and although it separates: the root 0 of its own
/// contact. While it approaches, if only by rounding, it has been asked again.
template <typename Number>
std::string reading_of_repeat(const Context<Number>& c, const EventLine<Number>& event) {
  using W = Work<Number>;
  const bool at_once = event.t == c.model.flight(event.i).since || event.t == c.model.flight(event.j).since;
  const RelativeFlight<W> pair = pair_flight(c.model, event.i, event.j).relative();
  const bool separates = dot(pair.r, pair.v) >= W(0);
  return at_once && separates ? readings::kLiteralRoot : readings::kRespondsAgain;
}

/// Of a body that parts at another time than its own: because all that is loaded against one wall waits for
/// the latest, or because nothing waits for a later load.
template <typename Number>
std::string reading_of_expiry(const Context<Number>& c, const Body<Number>& body, const Instant<Number>& t,
                              const Work<Number>& late) {
  using std::abs;
  using W = Work<Number>;
  const LoadNode<Number>& root = *body.root;
  if ((root.inverse_mass[0] == W(0) || root.inverse_mass[1] == W(0)) && late > W(0))
    return readings::kWallInTree;
  const W own = W(stored<Number>(c.model.scene.grouping->dt_restitute, c.model.precision));
  const bool by_first_load =
      body.loads > 1 && abs(elapsed(body.birth, t) - own) <= c.time_error(t) + c.u() * own;
  return by_first_load ? readings::kOwnExpiry : "";
}

}  // namespace tps::check

// Until when nothing can be wrong with a pair, whatever else happens.
#pragma once

#include <cmath>

#include "verify/trace_check/context.hpp"
#include "verify/trace_check/pair_flight.hpp"

namespace tps::check {

/// How long a pair stays within an outer limit at least, from the later of its two clocks on, where doubles
/// tell: well inside, moving, and its coordinates known. A hundredth of it is more than they err.
///
/// With S and the share of a first look (clear.hpp) c errs by less than share (S² + L²)/16, which is 2^-10 of
/// it here; h errs by 2^-42 S √a at most and D ≥ a|c| ≥ 2^-34 a S², so that D and the root do by 2^-20. Twice
/// the bound of h, over a, is 2^-46 S/√a, and the root is 2^-36 S/√a at least.
inline std::optional<double> time_within(const FlightInDoubles& a, const FlightInDoubles& b, double outer,
                                         double share) {
  const Instant<double>& start = std::max(a.since, b.since);
  const StraightLine i = a.until(start, 0), j = b.until(start, 0);
  double rr = 0, h = 0, vv = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double r =
        (j.position[k] + j.velocity[k] * j.duration) - (i.position[k] + i.velocity[k] * i.duration);
    const double v = j.velocity[k] - i.velocity[k];
    rr += r * r;
    h += r * v;
    vv += v * v;
  }
  const double size = i.size + i.speed * i.duration + j.size + j.speed * j.duration;
  const double left = outer * outer - rr;
  constexpr double kLargest = 0x1p200;
  // Written so that what is no number is out of range.
  const bool is_in_range = size < kLargest && size > 1 / kLargest && vv < kLargest && vv > 1 / kLargest;
  if (!is_in_range || !(left > 0x1p6 * share * (size * size + outer * outer))) return std::nullopt;
  const double root = std::sqrt(h * h + vv * left);
  return h > 0 ? left / (h + root) : (root - h) / vv;
}

/// A time at or before which judge_pair finds nothing, as long as neither begins another flight; −∞ where
/// that is not known. REQUIRES a full trace of an open scene whose particles are advanced lazily.
///
/// Before the earliest time at which a limit may be due, by the bounds of the trace's timing, nothing is
/// overdue there, and q has its sign or is no further beyond the limit than at the start: q is convex, and
/// outside of an inner limit q > 0 until then, inside of an outer one q < 0. A hundredth of the wait is left
/// for the rounding of times, 2^-20 of which have to fit in; that of exact moments, 1.1 u, is among them.
template <typename Number>
double quiet_until(const Context<Number>& c, int i, int j) {
  using W = Work<Number>;
  constexpr double kUnknown = -HUGE_VAL;
  const Model<Number>& model = c.model;
  const PairRules<Number>& rules = model.rules.of(i, j);
  if (model.groups.together(i, j)) return kUnknown;
  const PairFlight<Number> pair = pair_flight(model, i, j);
  double wait = HUGE_VAL;
  const auto look_at = [&](bool outer, const Number& limit) {
    const LimitAsked<W> asked{outer, W(limit), model.responded(i, j, outer)};
    const auto q = quadratic_of(pair.relative(), asked.L, c.u(), c.timing, c.scale());
    const Due<W> expected = due(q, asked);
    const bool begins_clear = outer ? !expected.can_be_none : q.c > q.q_error;
    if (!begins_clear) return false;
    if (!expected.must_be_none) wait = std::min(wait, as_double(expected.earliest));
    return true;
  };
  if (rules.blocks && !look_at(false, rules.inner)) return kUnknown;
  if (model.tethered(i, j) && !look_at(true, rules.outer)) return kUnknown;
  if (std::isinf(wait)) return wait;
  const double start = as_double(pair.start.hi);
  if (!(wait > 0x1p-13 * std::fabs(start))) return kUnknown;
  return start + 0.99 * wait;
}

/// The same, not later and in a few operations, where doubles tell.
template <typename Number>
std::optional<double> quiet_until_about(const Context<Number>& c, int i, int j) {
  const Model<Number>& model = c.model;
  const PairRules<Number>& rules = model.rules.of(i, j);
  if (rules.blocks || !model.tethered(i, j) || model.groups.together(i, j)) return std::nullopt;
  const FlightInDoubles &a = model.flight_in_doubles(i), &b = model.flight_in_doubles(j);
  const double share = std::max(0x1p13 * as_double(c.u()), 0x1p-40);
  const std::optional<double> within = time_within(a, b, static_cast<double>(rules.outer), share);
  const double start = std::max(a.since, b.since).hi;
  if (!within || !(0.99 * *within > 0x1p-13 * std::fabs(start))) return std::nullopt;
  return start + 0.98 * *within;
}

}  // namespace tps::check

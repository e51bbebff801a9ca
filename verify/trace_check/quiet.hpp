// Until when nothing can be wrong with a pair, whatever else happens.
#pragma once

#include <cmath>

#include "verify/trace_check/context.hpp"
#include "verify/trace_check/pair_flight.hpp"

namespace tps::check {

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

}  // namespace tps::check

// Rule conservation: momentum, energy and angular momentum balance at every event.
#pragma once

#include "verify/trace_check/bodies_now.hpp"
#include "verify/trace_check/context.hpp"
#include "verify/trace_check/rules/impulse.hpp"

namespace tps::check {

/// Two bodies before and after a step, and what the step took from them.
template <typename W>
struct Balance {
  Vec<W> before_i, before_j, after_i, after_j;  ///< velocities
  W inverse_i, inverse_j;
  Vec<W> r;
  W dp_error;        ///< of the impulse that was exchanged: one unit
  double roundings;  ///< of it
  W energy_taken;    ///< lost for good, or stored
  W energy_error;
  bool central;                  ///< the impulse is along r
  DirectedChange<W> directed{};  ///< of velocities, beside rounding to nearest
};

/// Infinite masses take any momentum and no energy in their own frame; then only the other body is counted.
template <typename Number>
void judge_balance(const Context<Number>& c, const Balance<Work<Number>>& x, const std::string& pair) {
  using W = Work<Number>;
  using std::abs;
  const W zero(0);
  const bool wall_i = x.inverse_i == zero;
  const bool wall_j = x.inverse_j == zero;
  const W m_i = wall_i ? zero : W(1) / x.inverse_i;
  const W m_j = wall_j ? zero : W(1) / x.inverse_j;
  const int dimension = c.model.scene.dimension;
  const W rounded = c.u() * (m_i * largest(x.after_i) + m_j * largest(x.after_j)) +
                    W(2 * x.roundings) * x.dp_error + (m_i * x.directed.i + m_j * x.directed.j) / W(2) +
                    c.model.precision.smallest;
  const Vec<W> gained_i = m_i * (x.after_i - x.before_i);
  const Vec<W> gained_j = m_j * (x.after_j - x.before_j);
  if (!wall_i && !wall_j) {
    const Vec<W> drift = gained_i + gained_j;
    c.tally.residual("momentum", as_double(W((drift[0] + drift[1] + drift[2]) / rounded)));
    c.tally.within(Rule::conservation, as_double(W(largest(drift) / rounded)), 2, [&](Finding& f) {
      f.message = fmt::format("{} gain the momentum {} together", pair, shown(drift, dimension));
      f.equation = "(3)";
    });
  }
  // Energies in the frame of the wall, where there is one: it does no work there.
  const Vec<W> frame = wall_i ? x.before_i : wall_j ? x.before_j : Vec<W>{};
  const auto energy = [&](const Vec<W>& v_i, const Vec<W>& v_j) {
    const Vec<W> a = v_i - frame;
    const Vec<W> b = v_j - frame;
    return W(m_i * dot(a, a) / W(2) + m_j * dot(b, b) / W(2));
  };
  const W gained = energy(x.after_i, x.after_j) - energy(x.before_i, x.before_j);
  const W fastest = length(x.after_i - frame) + length(x.after_j - frame) + length(x.before_i - frame) +
                    length(x.before_j - frame);
  const W unit = W(dimension) * rounded * fastest + x.energy_error + c.model.precision.smallest;
  const W off = gained + x.energy_taken;
  c.tally.residual("energy", as_double(W(off / unit)));
  c.tally.within(Rule::conservation, as_double(W(abs(off) / unit)), 2, [&](Finding& f) {
    f.message = fmt::format("the energy of {} changes by {}; the coefficients take {}", pair, shown(gained),
                            shown(W(-x.energy_taken)));
    f.equation = "(4)";
  });
  if (!x.central) return;
  const Vec<W> torque = wall_j ? cross(x.r, gained_i) : cross(x.r, gained_j);
  c.tally.within(
      Rule::conservation, as_double(W(largest(torque) / (length(x.r) * rounded))), 2 * 1.5, [&](Finding& f) {
        f.message =
            fmt::format("{} gain the angular momentum {}: the impulse is not along the line of the two", pair,
                        shown(torque, 3));
        f.equation = "(4)";
      });
}

/// A collision that is not grouped.
template <typename Number>
void judge_conservation(const Context<Number>& c, const EventLine<Number>& event, const BodiesNow<Number>& b,
                        const Expected<Work<Number>>& expected,
                        const DirectedChange<Work<Number>>& directed) {
  using W = Work<Number>;
  const auto after = [&](int n) { return widened<W>(event.of(n)->velocity_after); };
  const W energy_error = W(2) * W(expected.roundings) * expected.response.error * length(b.v);
  judge_balance(c,
                Balance<W>{b.v_i, b.v_j, after(b.i), after(b.j), b.inverse_i, b.inverse_j, b.r,
                           expected.response.error, expected.roundings, expected.response.lost, energy_error,
                           expected.equation == "(4)", directed},
                c.pair(b.i, b.j));
}

/// A load takes ½ μ |v_AB|² out of the motion, whatever of it is stored or lost.
template <typename Number>
void judge_load_conservation(const Context<Number>& c, const EventLine<Number>& event,
                             const BodiesNow<Number>& b) {
  using W = Work<Number>;
  const auto after = [&](int n) { return widened<W>(event.of(n)->velocity_after); };
  const W unit = c.u() * b.mu * length(b.v);
  const W taken = b.mu / W(2) * dot(b.v, b.v);
  const double roundings = 6 + 2 * b.loads;
  // v_load errs by the size of the velocities, not of their difference.
  const W masses =
      (b.inverse_i == W(0) ? W(0) : W(1) / b.inverse_i) + (b.inverse_j == W(0) ? W(0) : W(1) / b.inverse_j);
  const W error = unit + c.u() * masses * (largest(b.v_i) + largest(b.v_j));
  judge_balance(c,
                Balance<W>{b.v_i, b.v_j, after(b.i), after(b.j), b.inverse_i, b.inverse_j, b.r, error,
                           roundings, taken, W(roundings) * error * length(b.v), false},
                c.pair(b.i, b.j));
}

}  // namespace tps::check

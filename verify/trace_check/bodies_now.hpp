// A collision as eqs. (4)-(7) see it: two bodies, in the numbers of the trace, in working precision.
#pragma once

#include <optional>

#include "verify/trace_check/model.hpp"

namespace tps::check {

template <typename Number>
struct BodiesNow {
  using W = Work<Number>;
  int i, j;
  Vec<W> r;            ///< from i to j at the event
  Vec<W> v_i, v_j, v;  ///< before; v = v_j − v_i
  W inverse_i, inverse_j;
  W mu;           ///< reduced mass
  W blur{0};      ///< how far r may be off
  int loads = 0;  ///< of the two bodies: their masses were rounded so often

  W distance() const { return length(r); }
  Vec<W> axis() const { return W(W(1) / length(r)) * r; }
  W v_n() const { return dot(v, r) / length(r); }
  Vec<W> across() const { return v - W(dot(v, r) / dot(r, r)) * r; }
};

/// The bodies of i and j at an event: positions as recorded (where the trace has none, the model's),
/// velocities as recorded before.
template <typename Number>
BodiesNow<Number> bodies_now(const Model<Number>& model, const EventLine<Number>& event,
                             const Work<Number>& time_error) {
  using W = Work<Number>;
  BodiesNow<Number> b;
  b.i = event.i;
  b.j = event.j;
  const auto place = [&](int n) {
    const InvolvedParticle<Number>* p = event.of(n);
    if (p->position_before) return widened<W>(*p->position_before);
    b.blur += model.flight(n).blur + time_error * length(widened<W>(model.flight(n).velocity));
    return model.position(n, event.t);
  };
  const auto velocity = [&](int n) {
    const InvolvedParticle<Number>* p = event.of(n);
    return widened<W>(p->velocity_before ? *p->velocity_before : model.flight(n).velocity);
  };
  b.r = place(event.j) - place(event.i);
  b.v_i = velocity(event.i);
  b.v_j = velocity(event.j);
  b.v = b.v_j - b.v_i;
  b.inverse_i = model.inverse_mass(event.i);
  b.inverse_j = model.inverse_mass(event.j);
  b.mu = W(1) / (b.inverse_i + b.inverse_j);
  b.loads = model.loads(event.i) + model.loads(event.j);
  return b;
}

/// What eqs. (4) and (5) make of it, and how large the rounding of an evaluation may be.
template <typename W>
struct Response {
  Vec<W> dp;
  W error;  ///< of dp, one unit: u times the size of what it is made of
  W lost;   ///< energy
};

/// Eq. (4): Δp = (1 + c) μ v_n û; nothing where the sign of v_n is the wrong one.
template <typename Number>
Response<Work<Number>> by_eq4(const BodiesNow<Number>& b, const Number& c_stored, bool outer,
                              const Work<Number>& u) {
  using W = Work<Number>;
  const W c(c_stored);
  const W v_n = b.v_n();
  const bool acts = outer ? v_n > W(0) : v_n < W(0);
  const W speed = length(b.v);
  const W turned = b.blur / b.distance();  // of the axis
  Response<W> response{{}, (W(1) + c) * b.mu * speed * (u + W(2) * turned), W(0)};
  if (!acts) return response;
  response.dp = W((W(1) + c) * b.mu * v_n) * b.axis();
  response.lost = b.mu / W(2) * (W(1) - c * c) * v_n * v_n;
  return response;
}

/// Eq. (5): Δp = μ (v − v'), v' = c^(θ/π) |v| (cos θ ŵ − sin θ û).
template <typename Number>
Response<Work<Number>> by_eq5(const BodiesNow<Number>& b, const PairRules<Number>& rules,
                              const Work<Number>& u) {
  using std::sqrt;
  using W = Work<Number>;
  const Vec<W> w = b.across();
  const W across = length(w);
  const W speed = length(b.v);
  const W cosine = W(1) / sqrt(W(1) + rules.tan_theta * rules.tan_theta);
  const W sine = rules.tan_theta * cosine;
  const W after = rules.speed_ratio * speed;
  if (across == W(0)) {
    // Real arithmetic retracts such a pair; rounding may turn it in any direction across the axis.
    return Response<W>{b.mu * (b.v + W(after * sine) * b.axis()), b.mu * (speed * u + after * cosine / W(8)),
                       b.mu / W(2) * (speed * speed - after * after)};
  }
  const Vec<W> v_after = W(after * cosine / across) * w - W(after * sine) * b.axis();
  const W turned = b.blur / b.distance();
  return Response<W>{b.mu * (b.v - v_after), b.mu * speed * (speed / across) * (u + W(2) * turned),
                     b.mu / W(2) * (speed * speed - after * after)};
}

}  // namespace tps::check

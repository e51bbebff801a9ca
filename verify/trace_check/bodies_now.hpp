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
  W mu;                      ///< reduced mass
  W blur{0};                 ///< how far r may be off
  W drift_i{0}, drift_j{0};  ///< how far v_i and v_j may be off
  W speeds_at_load{0};       ///< of the two bodies when they were loaded, where a restitution parts them
  int loads = 0;             ///< of the two bodies: their masses were rounded so often

  W drift() const { return drift_i + drift_j; }
  W distance() const { return length(r); }
  Vec<W> axis() const { return W(W(1) / length(r)) * r; }
  W v_n() const { return dot(v, r) / length(r); }
  /// v_ŵ; what a difference of nearly equal vectors leaves along r is taken off once more.
  Vec<W> across() const {
    const W rr = dot(r, r);
    const Vec<W> rest = v - W(dot(v, r) / rr) * r;
    return rest - W(dot(rest, r) / rr) * r;
  }
};

/// How far the velocity of a particle before an event may be off.
template <typename Number>
Work<Number> drift_before(const Model<Number>& model, const EventLine<Number>& event, int particle) {
  const InvolvedParticle<Number>* p = event.of(particle);
  return p != nullptr && p->velocity_before ? Work<Number>(0) : model.flight(particle).drift;
}

/// Bit for bit, but where one of them is known to `drift` only.
template <typename Number>
bool is_same_velocity(const Vec<Number>& v, const Vec<Number>& w, const Work<Number>& drift) {
  using W = Work<Number>;
  return v == w || largest(widened<W>(v) - widened<W>(w)) <= drift;
}

/// The bodies of i and j at an event: positions as recorded (where the trace has none, the model's),
/// velocities as recorded before.
template <typename Number>
BodiesNow<Number> bodies_now(const Model<Number>& model, const EventLine<Number>& event,
                             const Work<Number>& time_error) {
  using W = Work<Number>;
  BodiesNow<Number> b;
  b.i = event.i;
  b.j = event.j;
  bool recorded = true;
  const auto place = [&](int n) {
    const InvolvedParticle<Number>* p = event.of(n);
    if (p->position_before) return widened<W>(*p->position_before);
    b.blur += model.blur_of_place(n, event.t);
    recorded = false;
    return model.position(n, event.t);
  };
  const auto velocity = [&](int n) {
    const InvolvedParticle<Number>* p = event.of(n);
    return widened<W>(p->velocity_before ? *p->velocity_before : model.flight(n).velocity);
  };
  const Vec<W> apart = place(event.j) - place(event.i);
  const Vec<W> shift = model.shift_of(model.nearest_image(event.i, event.j, event.t));
  b.r = apart + shift;
  // r to an image is a sum of what has been rounded; a difference alone errs in proportion to r.
  if (length(shift) > W(0)) b.blur += W(model.precision.u) * (length(apart) + length(shift));
  b.v_i = velocity(event.i);
  b.v_j = velocity(event.j);
  b.drift_i = drift_before(model, event, event.i);
  b.drift_j = drift_before(model, event, event.j);
  b.v = b.v_j - b.v_i;
  if (!recorded) b.blur += time_error * length(b.v);
  b.inverse_i = model.inverse_mass(event.i);
  b.inverse_j = model.inverse_mass(event.j);
  b.mu = W(1) / (b.inverse_i + b.inverse_j);
  b.loads = model.loads(event.i) + model.loads(event.j);
  return b;
}

}  // namespace tps::check

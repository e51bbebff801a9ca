// A collision as eqs. (4)-(7) see it: two bodies, in the numbers of the trace, in working precision.
#pragma once

#include <optional>

#include "verify/trace_check/model.hpp"

namespace tps::check {

/// What is computed when it is first asked for, and once.
template <typename T>
class Once {
 public:
  template <typename Compute>
  const T& operator()(Compute compute) const {
    if (!value_) value_.emplace(compute());
    return *value_;
  }

 private:
  mutable std::optional<T> value_;
};

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
  W reach_i{0}, reach_j{0};  ///< largest coordinates, where the model has the two

  W drift() const { return drift_i + drift_j; }

  // REQUIRES that r, v and blur are no longer changed.
  const W& distance() const {
    return distance_([this] { return length(r); });
  }
  const Vec<W>& axis() const {
    return axis_([this] { return W(W(1) / distance()) * r; });
  }
  const W& v_n() const {
    return v_n_([this] { return W(dot(v, r) / distance()); });
  }
  const W& speed() const {
    return speed_([this] { return length(v); });
  }
  /// v_ŵ; what a difference of nearly equal vectors leaves along r is taken off once more.
  const Vec<W>& across() const {
    return across_([this] {
      const W rr = dot(r, r);
      const Vec<W> rest = v - W(dot(v, r) / rr) * r;
      return rest - W(dot(rest, r) / rr) * r;
    });
  }
  const W& speed_across() const {
    return speed_across_([this] { return length(across()); });
  }
  /// How far the axis may be turned, in radians; a right angle says that nothing is known of it.
  const W& turn_of_axis() const {
    return turn_([this] {
      using std::asin;
      if (blur == W(0) && distance() > W(0)) return W(0);
      const W share = blur / distance();
      return share < W(1) ? W(asin(share)) : W(kRightAngle);
    });
  }

 private:
  Once<W> distance_, v_n_, speed_, speed_across_, turn_;
  Once<Vec<W>> axis_, across_;
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
  if (!recorded && model.edges && model.images_are_open(W(0), time_error * length(b.v)))
    b.blur += model.shortest_edge();
  b.inverse_i = model.inverse_mass(event.i);
  b.inverse_j = model.inverse_mass(event.j);
  b.mu = W(1) / (b.inverse_i + b.inverse_j);
  b.loads = model.loads(event.i) + model.loads(event.j);
  b.reach_i = largest(model.position(event.i, event.t));
  b.reach_j = largest(model.position(event.j, event.t));
  return b;
}

}  // namespace tps::check

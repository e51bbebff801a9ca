// Two particles at the later of their two clocks: the instant at which a pair's question is asked.
#pragma once

#include <array>
#include <type_traits>

#include "reference/engine/clock.hpp"
#include "reference/equations/timing_query.hpp"
#include "verify/exact/double_word.hpp"
#include "verify/trace_check/due.hpp"
#include "verify/trace_check/model.hpp"

namespace tps::check {

template <typename Number>
struct PairFlight {
  Instant<Number> start;
  Vec<Number> u_i, u_j, v_i, v_j;
  Work<Number> blur{0};      ///< how far the distance of the two may be off
  Work<Number> drift{0};     ///< how far their relative velocity may be off
  Vec<Number> image, edges;  ///< j is meant displaced by so many edges of a periodic box

  RelativeFlight<Work<Number>> relative() const {
    using W = Work<Number>;
    return {widened<W>(u_j) + shift() - widened<W>(u_i), widened<W>(v_j) - widened<W>(v_i), blur, drift};
  }
  Vec<Work<Number>> shift() const {
    using W = Work<Number>;
    return {{W(image[0]) * W(edges[0]), W(image[1]) * W(edges[1]), W(image[2]) * W(edges[2])}};
  }
};

/// u + v dt in a scalar of the hardware, stored in doubles: a rounding each. dt is a difference of times that
/// is rounded as the run's clock rounds it: of two sums of floats that is not always the nearest float.
template <typename Scalar>
Vec<double> carried_in(const Flight<double>& f, const Instant<Scalar>& since, const Instant<Scalar>& t) {
  const Scalar dt = elapsed(Time<Scalar>{since.hi, since.lo}, Time<Scalar>{t.hi, t.lo});
  Vec<double> x;
  for (std::size_t k = 0; k < 3; ++k) {
    const Scalar step = static_cast<Scalar>(f.velocity[k]) * dt;
    x[k] = static_cast<Scalar>(f.position[k]) + step;
  }
  return x;
}

/// u + v dt as the run's own scalar rounds it (docs/trace.md): for float and double the same bits; for wider
/// scalars to the working precision, with `blur` for the rounding.
template <typename Number>
Vec<Number> carried(const Flight<Number>& f, const Instant<Number>& t, const Precision<Number>& precision,
                    Work<Number>& blur) {
  if (f.since == t) return f.position;
  if constexpr (std::is_same_v<Number, double>) {
    if (precision.is_float) return carried_in<float>(f, in_floats(f.since), in_floats(t));
    return carried_in<double>(f, f.since, t);
  } else {
    const Number dt = elapsed(f.since, t);
    const Vec<Number> step = dt * f.velocity;
    const Vec<Number> x = f.position + step;
    blur += Number(2) * precision.u * (Number(2) * largest(step) + largest(x));
    return x;
  }
}

template <typename Number>
PairFlight<Number> pair_flight(const Model<Number>& model, int i, int j) {
  const Flight<Number>& a = model.flight(i);
  const Flight<Number>& b = model.flight(j);
  PairFlight<Number> pair;
  pair.start = a.since < b.since ? b.since : a.since;
  pair.blur = model.blur(i) + model.blur(j);
  pair.drift = a.drift + b.drift;
  pair.u_i = carried(a, pair.start, model.precision, pair.blur);
  pair.u_j = carried(b, pair.start, model.precision, pair.blur);
  pair.v_i = a.velocity;
  pair.v_j = b.velocity;
  return pair;
}

/// The same with an image of j. Where it is rounded to the scalar, the difference of the places, the shift
/// and their sum have a rounding each, of their own sizes.
template <typename Number>
PairFlight<Number> pair_flight(const Model<Number>& model, int i, int j, const Vec<Number>& image) {
  using W = Work<Number>;
  PairFlight<Number> pair = pair_flight(model, i, j);
  if (image == Vec<Number>{}) return pair;
  pair.image = image;
  pair.edges = *model.edges;
  const W size = length(widened<W>(pair.u_j) - widened<W>(pair.u_i)) + length(pair.shift());
  pair.blur += W(4) * model.precision.u * size;
  return pair;
}

/// The question in doubles, for exact answers.
inline TimingQuery timing_query(const PairFlight<double>& pair, bool outer, double L) {
  return {outer ? TimingKind::tether : TimingKind::block,
          pair.u_i.x,
          pair.u_j.x,
          pair.v_i.x,
          pair.v_j.x,
          L,
          {},
          pair.image.x,
          pair.edges.x};
}

}  // namespace tps::check

// What rebound and tethering have in common: the collision of two bodies seen as eqs. (4) and (5) see it, and
// the bookkeeping around its answer.
//
// The three functions that both call stay out of line: inlined where there is one caller and not where there
// are two, they would make either effect cost the scenes that call for the other alone
// (docs/performance.md, "Only what is called for").
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/engine/coupling.hpp"
#include "reference/engine/world.hpp"
#include "reference/equations/collision_frame.hpp"

namespace tps {

/// The unit in the last place of a pair's largest coordinate: what a distance can be off by through storage.
template <typename Scalar, int D>
Scalar coordinate_ulp(const Vector<Scalar, D>& u_i, const Vector<Scalar, D>& u_j) {
  using std::abs;
  using std::frexp;
  using std::ldexp;
  Scalar largest(0);
  for (int k = 0; k < D; ++k) largest = std::max({largest, Scalar(abs(u_i[k])), Scalar(abs(u_j[k]))});
  int exponent = 0;
  static_cast<void>(frexp(largest, &exponent));
  const Scalar ulp = ldexp(Scalar(1), exponent - std::numeric_limits<Scalar>::digits);
  return std::max(ulp, std::numeric_limits<Scalar>::denorm_min());
}

/// The collision of two particles that were brought to now, Δp still zero. Throws OutOfRange where they are
/// at one place, which has no axis.
template <typename Scalar, int D>
[[gnu::noinline]] Collision<Scalar, D> collision_now(const World<Scalar, D>& world, int i, int j,
                                                     Limit limit) {
  require_apart(world, i, j);
  const PairPlaces<Scalar, D> places = world.places(i, j);
  return {i,
          j,
          limit,
          collision_frame<Scalar, D>(places.from(), places.to(), world.velocity(i), world.velocity(j)),
          world.coupling->body_mass(world, i),
          world.coupling->body_mass(world, j),
          Vector<Scalar, D>::Zero(),
          Scalar(0)};
}

/// Whether rounding alone can have made v_n: each stored velocity was rounded to u of itself by its last
/// response, and v_AB once more; the axis turns by 2 √D u X/|r|, X the largest coordinate, where each
/// coordinate is off by an ulp, and by 2u in its own computation.
template <typename Scalar, int D>
bool below_rounding(const World<Scalar, D>& world, const Collision<Scalar, D>& c) {
  using std::abs;
  const Scalar u = std::numeric_limits<Scalar>::epsilon() / Scalar(2);
  const PairPlaces<Scalar, D> places = world.places(c.i, c.j);
  const Scalar reach = places.u_i.cwiseAbs().maxCoeff() + places.u_j.cwiseAbs().maxCoeff();
  const Scalar distance = norm<Scalar, D>(places.to() - places.from());
  const Scalar turn = Scalar(2) * u + Scalar(2 * D) * u * reach / distance;
  const Scalar speeds = norm<Scalar, D>(world.velocity(c.i)) + norm<Scalar, D>(world.velocity(c.j));
  return abs(c.frame.v_n) <= Scalar(2) * u * speeds + turn * norm<Scalar, D>(c.frame.v_AB);
}

/// Counts how far a collision is from what real arithmetic would have made of it.
template <typename Scalar, int D>
[[gnu::noinline]] void observe_collision(World<Scalar, D>& world, const Collision<Scalar, D>& c,
                                         const Scalar& distance_limit) {
  using std::abs;
  using std::sqrt;
  const PairPlaces<Scalar, D> places = world.places(c.i, c.j);
  const Scalar distance = norm<Scalar, D>(places.to() - places.from());
  const Scalar inside = (distance_limit - distance) / coordinate_ulp<Scalar, D>(places.u_i, places.u_j);
  Statistics<Scalar>& s = world.statistics;
  if (c.limit == Limit::inner) s.worst_inner_excess = std::max(s.worst_inner_excess, inside);
  if (c.limit == Limit::outer) s.worst_outer_excess = std::max(s.worst_outer_excess, Scalar(-inside));
  if (c.limit == Limit::inner && below_rounding(world, c)) {
    if (s.noise++ == 0) s.first_noise = world.events + 1;
  }
}

/// Throws OutOfRange where eq. (4) or (5) has an impulse, and the scalar has none: it underflowed to zero.
template <typename Scalar, int D>
void require_impulse(const World<Scalar, D>& world, const Collision<Scalar, D>& c) {
  if (c.dp != Vector<Scalar, D>::Zero()) return;
  const bool turns = c.limit == Limit::inner ? c.frame.v_n < Scalar(0) : c.frame.v_n > Scalar(0);
  const bool revolves = c.limit == Limit::outer && c.frame.v_w != Vector<Scalar, D>::Zero();
  if (turns || revolves)
    throw OutOfRange("the impulse between " + pair_name(world.scene, c.i, c.j) + ", which underflows,");
}

/// Passes the impulse of a collision on to the bodies and remembers that the pair has responded. With the
/// wrong sign of v_n the event stands with Δp = 0 (semantics §1) and loads nothing.
template <typename Scalar, int D>
[[gnu::noinline]] void answer(World<Scalar, D>& world, const Collision<Scalar, D>& collision,
                              bool has_impulse, Record<Scalar, D>& record) {
  record.dp = collision.dp;
  if (has_impulse) {
    require_impulse(world, collision);
    world.coupling->collide(world, collision, record);
  } else {
    ++world.statistics.zero_impulse;
  }
  if (!world.coupling->together(collision.i, collision.j)) {
    world.responded.add(collision.i, collision.j, collision.limit);
  }
}

}  // namespace tps

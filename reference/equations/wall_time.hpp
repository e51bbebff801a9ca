// When a particle reaches a plane wall: linear in time where eq. (2) is quadratic. An addition to the paper;
// docs/effects.md, "Walls". In- and outsides of spheres are eq. (2) itself.
#pragma once

#include <optional>
#include <type_traits>

#include "reference/equations/timing_verdict.hpp"
#include "reference/equations/vector.hpp"

namespace tps {

/// A particle B before a plane through A.
template <typename Scalar>
struct WallApproach {
  Scalar gap;  ///< n·(u_B − u_A) − L: how far it still has to go, negative behind the limit
  Scalar v_n;  ///< n·(v_B − v_A): negative while it approaches
};

/// @param normal  n, towards the side where particles are, of length 1; taken as it is given.
template <typename Scalar, int D>
WallApproach<Scalar> wall_approach(const Vector<Scalar, D>& u_A, const Vector<Scalar, D>& u_B,
                                   const Vector<Scalar, D>& v_A, const Vector<Scalar, D>& v_B,
                                   const std::type_identity_t<Scalar>& L, const Vector<Scalar, D>& normal) {
  return {normal.dot(u_B - u_A) - L, normal.dot(v_B - v_A)};
}

/// Time until a particle is at the distance L of a plane while it approaches: t = (n·r − L)/(−n·v).
///
/// @param u_A,v_A  a point of the plane and its velocity; @param u_B,v_B of the particle
/// @param L        > 0, the distance at which it touches: its radius
/// @param normal   n, of length 1; distances are in units of it
/// @return verdict, and t in units of time: 0 for `overlap` (beyond the limit) and `contact`, positive for
/// `hit`, absent for `static` (v = 0) and `receding` (n·v ≥ 0).
/// REQUIRES finite inputs with finite differences. That of a `hit` beyond the scalar's range is ∞ or 0.
/// Laws: (1) t (−n·v) is n·r − L, to rounding; (2) a plane of the same normal through any other of its points
/// gives the same; (3) lengths and velocities times 2^k leave the verdict and t unchanged bitwise, where no
/// product underflows; (4) what is common to both velocities or both positions changes nothing where adding
/// it is exact.
/// Accuracy: gap and n·v err by 6u of the sum of their terms' sizes; near 0 their signs are those of rounded
/// sums, and the certified answer is that of docs/exact.md, "Planes".
template <typename Scalar, int D>
CollisionTime<Scalar> wall_time(const Vector<Scalar, D>& u_A, const Vector<Scalar, D>& u_B,
                                const Vector<Scalar, D>& v_A, const Vector<Scalar, D>& v_B,
                                const std::type_identity_t<Scalar>& L, const Vector<Scalar, D>& normal) {
  const Vector<Scalar, D> v = v_B - v_A;
  if ((v.array() == Scalar(0)).all()) return {TimingVerdict::static_pair, std::nullopt};
  const WallApproach<Scalar> q = wall_approach<Scalar, D>(u_A, u_B, v_A, v_B, L, normal);
  if (q.v_n >= Scalar(0)) return {TimingVerdict::receding, std::nullopt};
  if (q.gap < Scalar(0)) return {TimingVerdict::overlap, Scalar(0)};
  if (q.gap == Scalar(0)) return {TimingVerdict::contact, Scalar(0)};
  return {TimingVerdict::hit, q.gap / -q.v_n};
}

}  // namespace tps

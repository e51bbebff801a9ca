// Eq. (2) with the paper's prose made a rule: a blocking collision is reached while approaching, a tethering
// collision while separating. Two queries, each with a verdict that names the case (docs/eq2.md).
#pragma once

#include <cmath>
#include <optional>
#include <type_traits>

#include "reference/equations/eq2_approach.hpp"
#include "reference/equations/square_root.hpp"
#include "reference/equations/timing_verdict.hpp"
#include "reference/equations/vector.hpp"

namespace tps {

/// When a pair at relative position r with relative velocity v next is at distance L *and approaching*.
///
/// Eq. (2), smaller root, written c / (−h + √D): with h < 0 nothing cancels.
/// REQUIRES v ≠ 0; squares of the inputs neither overflow nor underflow.
template <typename Scalar, int D>
CollisionTime<Scalar> block_time_of_moving(const Vector<Scalar, D>& r, const Vector<Scalar, D>& v,
                                           const Scalar& L) {
  const Approach<Scalar> q = approach<Scalar, D>(r, v, L);
  const Scalar zero(0);
  if (q.h >= zero) return {TimingVerdict::receding, std::nullopt};
  if (q.c < zero) return {TimingVerdict::overlap, zero};
  if (q.c == zero) return {TimingVerdict::contact, zero};
  if (q.D < zero) return {TimingVerdict::miss, std::nullopt};
  if (q.D == zero) return {TimingVerdict::tangent, std::nullopt};
  return {TimingVerdict::hit, q.c / (-q.h + square_root(q.D))};
}

/// When a tethered pair at relative position r with relative velocity v next is at distance L *and
/// separating*. Eq. (2), larger root, in whichever of its two forms adds instead of cancelling.
/// REQUIRES v ≠ 0; squares of the inputs neither overflow nor underflow.
template <typename Scalar, int D>
CollisionTime<Scalar> tether_time_of_moving(const Vector<Scalar, D>& r, const Vector<Scalar, D>& v,
                                            const Scalar& L) {
  const Approach<Scalar> q = approach<Scalar, D>(r, v, L);
  const Scalar zero(0);
  if (q.c < zero) {
    const Scalar root = square_root(q.D);  // D = h² + a |c| > 0
    if (q.h <= zero) return {TimingVerdict::hit, (-q.h + root) / q.a};
    return {TimingVerdict::hit, -q.c / (q.h + root)};
  }
  if (q.h >= zero) return {q.c == zero ? TimingVerdict::taut : TimingVerdict::overstretched, zero};
  if (q.c == zero) return {TimingVerdict::hit, Scalar(-2) * q.h / q.a};
  if (q.D > zero) return {TimingVerdict::hit, (-q.h + square_root(q.D)) / q.a};
  return {TimingVerdict::turning, -q.h / q.a};
}

namespace detail {

template <typename Scalar, int D, typename Query>
CollisionTime<Scalar> timed(const Vector<Scalar, D>& u_A, const Vector<Scalar, D>& u_B,
                            const Vector<Scalar, D>& v_A, const Vector<Scalar, D>& v_B, const Scalar& L,
                            Query query) {
  using std::ldexp;
  const Vector<Scalar, D> r = u_B - u_A;
  const Vector<Scalar, D> v = v_B - v_A;
  if ((v.array() == Scalar(0)).all()) return {TimingVerdict::static_pair, std::nullopt};
  const ScaledQuery<Scalar, D> scaled = scaled_query<Scalar, D>(r, v, L);
  CollisionTime<Scalar> answer = query(scaled.r, scaled.v, scaled.L);
  if (answer.t && scaled.time_exponent != 0) answer.t = ldexp(*answer.t, scaled.time_exponent);
  return answer;
}

}  // namespace detail

/// Time to the next blocking collision, eq. (2) by approach (semantics §1): smallest t ≥ 0 at which the
/// distance is L = Δu_blocking while the pair approaches.
///
/// @param u_A,u_B positions; @param v_A,v_B velocities; @param L > 0 the inner limiting distance.
/// @return verdict, and t in units of time: 0 for `overlap` and `contact`, the smaller root for `hit`,
/// absent for `static`, `receding`, `miss`, `tangent`.
/// REQUIRES finite inputs with finite differences. A time beyond the scalar's range is ∞ or 0.
/// Laws: (1) block_time(A, B) == block_time(B, A) bitwise; (2) lengths and velocities times 2^k leave the
/// verdict and t unchanged bitwise, velocities alone times 2^k divide t by 2^k; (3) a larger L is never
/// reached later; (4) for `hit` the distance at t is L to a few u (|r| + L); (5) t is 0, absent or positive
/// as the verdict says; (6) away from the boundaries of verdicts it is the exact one; (7) axes may be
/// reflected, bitwise; (8) and exchanged, bitwise in 2-D; (9) offsets common to both positions, or to both
/// velocities, change nothing where adding them is exact. (3), (4), (6) and (8) to rounding, see
/// docs/eq2.md.
/// Accuracy: verdicts near their boundaries are those of rounded coefficients; see docs/eq2.md.
template <typename Scalar, int D>
CollisionTime<Scalar> block_time(const Vector<Scalar, D>& u_A, const Vector<Scalar, D>& u_B,
                                 const Vector<Scalar, D>& v_A, const Vector<Scalar, D>& v_B,
                                 const std::type_identity_t<Scalar>& L) {
  return detail::timed<Scalar, D>(u_A, u_B, v_A, v_B, L, block_time_of_moving<Scalar, D>);
}

/// Time to the next tethering collision, eq. (2) by separation (semantics §1): smallest t ≥ 0 at which the
/// distance is L = Δu_tethering while the pair separates.
///
/// @return verdict, and t: 0 for `taut` and `overstretched`, the larger root for `hit`, the moment of
/// closest approach for `turning`, absent for `static` only: a moving tethered pair always has an event.
/// Parameters, requirements and laws but (3) as for block_time.
template <typename Scalar, int D>
CollisionTime<Scalar> tether_time(const Vector<Scalar, D>& u_A, const Vector<Scalar, D>& u_B,
                                  const Vector<Scalar, D>& v_A, const Vector<Scalar, D>& v_B,
                                  const std::type_identity_t<Scalar>& L) {
  return detail::timed<Scalar, D>(u_A, u_B, v_A, v_B, L, tether_time_of_moving<Scalar, D>);
}

}  // namespace tps

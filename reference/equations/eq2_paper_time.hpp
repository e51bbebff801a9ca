// Eq. (2), literally: the roots and the selection rule as the paper prints them, and the same roots selected
// by approach (`--timing paper`). Kept for comparison; what this project computes with is in
// eq2_collision_time.hpp, which also says what it mends (docs/eq2.md).
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

#include "reference/equations/square_root.hpp"
#include "reference/equations/timing_verdict.hpp"
#include "reference/equations/vector.hpp"

namespace tps {

/// Everything that eq. (2) names: coefficients, discriminant and the two quotients.
template <typename Scalar>
struct PaperRoots {
  Scalar a;                           ///< Σ(v_B − v_A)²
  Scalar b;                           ///< 2 Σ(u_B − u_A)(v_B − v_A)
  Scalar c;                           ///< Σ(u_B − u_A)² − Δu²
  Scalar discriminant;                ///< b² − 4ac
  std::optional<Scalar> minus, plus;  ///< (−b ∓ √(b² − 4ac)) / 2a, where they are finite and real
};

/// Roots of eq. (1) set to Δu = L, by eq. (2) as printed: Δt = (−b ± √(b² − 4ac)) / 2a.
///
/// @param L the limiting distance Δu. @return coefficients and the real, finite roots; both absent for
/// a = 0 (no relative motion) and for a negative discriminant; a root that overflows is not finite.
/// Accuracy: none is promised. b² − 4ac and −b + √… cancel; that is what eq2_collision_time.hpp avoids.
template <typename Scalar, int D>
PaperRoots<Scalar> paper_roots(const Vector<Scalar, D>& u_A, const Vector<Scalar, D>& u_B,
                               const Vector<Scalar, D>& v_A, const Vector<Scalar, D>& v_B,
                               const std::type_identity_t<Scalar>& L) {
  using std::abs;
  const Vector<Scalar, D> r = u_B - u_A;
  const Vector<Scalar, D> v = v_B - v_A;
  const Scalar a = v.squaredNorm();
  const Scalar b = Scalar(2) * r.dot(v);
  const Scalar c = r.squaredNorm() - L * L;
  const Scalar discriminant = b * b - Scalar(4) * a * c;
  PaperRoots<Scalar> roots{a, b, c, discriminant, std::nullopt, std::nullopt};
  if (a > Scalar(0) && discriminant >= Scalar(0)) {
    const Scalar minus = (-b - square_root(discriminant)) / (Scalar(2) * a);
    const Scalar plus = (-b + square_root(discriminant)) / (Scalar(2) * a);
    if (abs(minus) <= (std::numeric_limits<Scalar>::max)()) roots.minus = minus;
    if (abs(plus) <= (std::numeric_limits<Scalar>::max)()) roots.plus = plus;
  }
  return roots;
}

/// The paper's rule for eq. (2): the smaller finite, real, non-negative root, for either kind of limit.
///
/// Departs from eq2_collision_time.hpp where the rule alone misleads: r = (1,0), v = (1,0), L = 1 has the
/// roots −2 and 0, so the rule answers 0 for a pair that has just rebounded; r = (2,0), v = (−1,0), L = 2
/// has 0 and 4, and the rule answers 0 for a tether that has just been pulled.
template <typename Scalar, int D>
std::optional<Scalar> paper_time(const Vector<Scalar, D>& u_A, const Vector<Scalar, D>& u_B,
                                 const Vector<Scalar, D>& v_A, const Vector<Scalar, D>& v_B,
                                 const std::type_identity_t<Scalar>& L) {
  const PaperRoots<Scalar> roots = paper_roots<Scalar, D>(u_A, u_B, v_A, v_B, L);
  if (roots.minus && *roots.minus >= Scalar(0)) return roots.minus;
  if (roots.plus && *roots.plus >= Scalar(0)) return roots.plus;
  return std::nullopt;
}

/// Whether eq. (2) as printed stays within the range of the scalar, so that its answer means something: no
/// square is infinite, |v|² and |r|² + L² have not lost their digits to underflow, and b² and 4ac, of which
/// one decides beside the other, have not both. Where b ≥ 0 outside the limit no root is asked for.
template <typename Scalar, int D>
bool paper_roots_in_range(const Vector<Scalar, D>& u_A, const Vector<Scalar, D>& u_B,
                          const Vector<Scalar, D>& v_A, const Vector<Scalar, D>& v_B,
                          const std::type_identity_t<Scalar>& L) {
  using std::abs;
  const PaperRoots<Scalar> q = paper_roots<Scalar, D>(u_A, u_B, v_A, v_B, L);
  if (v_A == v_B) return true;
  const Scalar least = (std::numeric_limits<Scalar>::min)();
  const Scalar lengths = Vector<Scalar, D>(u_B - u_A).squaredNorm() + L * L;
  if (!is_finite(q.a) || !is_finite(q.b) || !is_finite(lengths)) return false;
  if (q.a < least || lengths < least) return false;
  if (q.b >= Scalar(0) && q.c >= Scalar(0)) return true;
  const Scalar b_squared = q.b * q.b;
  const Scalar product = Scalar(4) * q.a * q.c;
  if (!is_finite(b_squared) || !is_finite(product) || !is_finite(Scalar(2) * q.a)) return false;
  return b_squared >= least || abs(product) >= least || q.c == Scalar(0);
}

namespace detail {

template <typename Scalar>
std::optional<Scalar> at_least_zero(const std::optional<Scalar>& t) {
  return t && *t < Scalar(0) ? std::optional<Scalar>(Scalar(0)) : t;
}

}  // namespace detail

/// Eq. (2) as printed, selected by approach: the decision table of semantics §1 for blocking, read off the
/// printed b, c and b² − 4ac, and the printed quotient with the minus sign.
///
/// @return verdict and t as block_time() has them; t is also absent where the quotient is not finite.
/// Accuracy: none is promised. Near a graze b² − 4ac has any sign, and the quotient cancels near the limit;
/// no scaling: squares may over- or underflow, which paper_roots_in_range() tells.
template <typename Scalar, int D>
CollisionTime<Scalar> paper_block_time(const Vector<Scalar, D>& u_A, const Vector<Scalar, D>& u_B,
                                       const Vector<Scalar, D>& v_A, const Vector<Scalar, D>& v_B,
                                       const std::type_identity_t<Scalar>& L) {
  const PaperRoots<Scalar> q = paper_roots<Scalar, D>(u_A, u_B, v_A, v_B, L);
  const Scalar zero(0);
  if (v_A == v_B) return {TimingVerdict::static_pair, std::nullopt};
  if (!(q.b < zero)) return {TimingVerdict::receding, std::nullopt};
  if (q.c < zero) return {TimingVerdict::overlap, zero};
  if (q.c == zero) return {TimingVerdict::contact, zero};
  if (q.discriminant == zero) return {TimingVerdict::tangent, std::nullopt};
  if (!(q.discriminant > zero)) return {TimingVerdict::miss, std::nullopt};
  return {TimingVerdict::hit, detail::at_least_zero(q.minus)};
}

/// The same for tethering, with the plus sign; `turning` is at −b/2a.
template <typename Scalar, int D>
CollisionTime<Scalar> paper_tether_time(const Vector<Scalar, D>& u_A, const Vector<Scalar, D>& u_B,
                                        const Vector<Scalar, D>& v_A, const Vector<Scalar, D>& v_B,
                                        const std::type_identity_t<Scalar>& L) {
  const PaperRoots<Scalar> q = paper_roots<Scalar, D>(u_A, u_B, v_A, v_B, L);
  const Scalar zero(0);
  if (v_A == v_B) return {TimingVerdict::static_pair, std::nullopt};
  if (q.c < zero) return {TimingVerdict::hit, detail::at_least_zero(q.plus)};
  if (!(q.b < zero)) return {q.c == zero ? TimingVerdict::taut : TimingVerdict::overstretched, zero};
  if (q.c == zero || q.discriminant > zero) return {TimingVerdict::hit, detail::at_least_zero(q.plus)};
  return {TimingVerdict::turning, -q.b / (Scalar(2) * q.a)};
}

}  // namespace tps

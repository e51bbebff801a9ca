// The last rounding of a response, directed: the stored velocities of a pair that has rebounded never
// approach, those of one that was pulled never part (docs/engine.md, "Directed rounding").
#pragma once

#include <cmath>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "reference/equations/dyadic.hpp"
#include "reference/equations/eq3_apply_impulse.hpp"
#include "reference/equations/periodic_image.hpp"
#include "reference/equations/vector.hpp"

namespace tps {

namespace detail {

/// Component k of u_B − u_A, of the image of B where one is meant.
template <typename Scalar, int D>
Dyadic exact_component(const Vector<Scalar, D>& u_A, const Vector<Scalar, D>& u_B, int k,
                       const PeriodicImage<Scalar, D>* image) {
  if (image != nullptr) return image->exact_difference(u_A, u_B, k);
  const Scalar &a = u_A[k], &b = u_B[k];
  return dyadic(b) - dyadic(a);
}

/// (u_B − u_A)·(v_B − v_A) without component `without`.
template <typename Scalar, int D>
Dyadic exact_dot(const Vector<Scalar, D>& u_A, const Vector<Scalar, D>& u_B, const Vector<Scalar, D>& v_A,
                 const Vector<Scalar, D>& v_B, int without, const PeriodicImage<Scalar, D>* image = nullptr) {
  Dyadic sum;
  for (int k = 0; k < D; ++k) {
    if (k == without) continue;
    const Scalar &x = v_A[k], &y = v_B[k];
    sum = sum + exact_component<Scalar, D>(u_A, u_B, k, image) * (dyadic(y) - dyadic(x));
  }
  return sum;
}

}  // namespace detail

/// The sign of (u_B − u_A)·(v_B − v_A), that of v_n, as real arithmetic has it on the stored numbers: −1
/// approaching, 0, 1 parting.
///
/// A rounded sum decides where its error cannot: two differences, a product and at most two additions a term
/// are at most 5 · 2u of Σ|r_k w_k| even where subtraction errs by 0.75 ulp, 16 · 2u with its own rounding;
/// an underflow adds less than the smallest normal number. Else integers decide. With an image u_B − u_A
/// and the shift nearly cancel: the size is that of both.
/// 0 where an input is not finite. Laws: (1) exchanging A and B keeps it; (2) exchanging velocities flips it;
/// (3) lengths or velocities times 2^k keep it.
template <typename Scalar, int D>
int normal_sign(const Vector<Scalar, D>& u_A, const Vector<Scalar, D>& u_B, const Vector<Scalar, D>& v_A,
                const Vector<Scalar, D>& v_B, const PeriodicImage<Scalar, D>* image = nullptr) {
  using std::abs;
  using Limits = std::numeric_limits<Scalar>;
  Scalar sum(0);
  Scalar size(0);
  for (int k = 0; k < D; ++k) {
    const Scalar term = (u_B[k] - u_A[k]) * (v_B[k] - v_A[k]);
    sum += term;
    size += abs(term);
    if (image == nullptr) continue;
    const Scalar of_image = image->shift(k) * (v_B[k] - v_A[k]);
    sum += of_image;
    size += abs(of_image);
  }
  if (abs(sum) > Scalar(16) * Limits::epsilon() * size + (Limits::min)() && size <= (Limits::max)()) {
    return sum > Scalar(0) ? 1 : -1;
  }
  const auto finite = [](const Vector<Scalar, D>& x) { return is_finite<Scalar, D>(x); };
  if (!finite(u_A) || !finite(u_B) || !finite(v_A) || !finite(v_B)) return 0;
  return detail::exact_dot<Scalar, D>(u_A, u_B, v_A, v_B, -1, image).sign();
}

/// Which way a pair may move along û after its response.
enum class Leaving {
  apart,     ///< after a rebound: v_n' ≥ 0
  together,  ///< after a retraction or revolution: v_n' < 0, or at rest with each other
};

namespace detail {

template <typename Scalar, int D>
bool leaves(Leaving leaving, const Vector<Scalar, D>& u_A, const Vector<Scalar, D>& u_B,
            const PairVelocities<Scalar, D>& v, const PeriodicImage<Scalar, D>* image = nullptr) {
  const int sign = normal_sign<Scalar, D>(u_A, u_B, v.v_A, v.v_B, image);
  if (leaving == Leaving::apart) return sign >= 0;
  return sign < 0 || v.v_A == v.v_B;
}

/// The components along which û is largest; of several, those in which the two are fastest. More than one are
/// left where an exchange of axes may turn the pair into itself: then all of them have to change alike.
template <typename Scalar, int D>
std::vector<int> components_along(const Vector<Scalar, D>& r, const PairVelocities<Scalar, D>& v) {
  using std::abs;
  const auto rank = [&](int k) {
    const Scalar x = abs(v.v_A[k]), y = abs(v.v_B[k]);
    return std::tuple(Scalar(abs(r[k])), x > y ? x : y, x > y ? y : x, v.v_A[k] == -v.v_B[k]);
  };
  std::vector<int> all = {0};
  for (int k = 1; k < D; ++k) {
    if (rank(k) > rank(all.front())) all.clear();
    if (all.empty() || rank(k) == rank(all.front())) all.push_back(k);
  }
  return all;
}

/// Whose component x of A, y of B is set anew, where the two are not opposite: the choice depends on no name
/// and on no axis.
template <typename Scalar>
bool changes_A(const Scalar& m_A, const Scalar& m_B, const Scalar& x, const Scalar& y, bool B_goes_up) {
  using std::abs;
  if (m_A != m_B) return m_A < m_B;
  if (abs(x) != abs(y)) return abs(x) > abs(y);
  return (x > Scalar(0)) == B_goes_up;  // x = y: A, which goes the other way than B, is slowed by that
}

/// next_number; from 0, in a scalar whose exponents have 32 bits, the smallest normal number of quad: of
/// 2^(−2^31) exact sums would have gigabytes, and no reader takes such exponents.
template <typename Scalar>
Scalar next_velocity(const Scalar& x, Rounding outwards) {
  using std::ldexp;
  constexpr int kLeastExponent = -16382;
  if (x != Scalar(0) || std::numeric_limits<Scalar>::min_exponent > kLeastExponent)
    return next_number(x, outwards);
  const Scalar least = ldexp(Scalar(1), kLeastExponent);
  return outwards == Rounding::up ? least : Scalar(-least);
}

}  // namespace detail

/// Velocities of a pair after its response, with v_n' of the right sign in real arithmetic.
///
/// Where rounding (or an impulse too small for a mass) has left the wrong sign, one component of one
/// velocity is set anew: of the lighter body, since its change carries the least momentum; of equal masses of
/// the one that is faster along that component, or as fast and slowed by it; the component is that of the
/// largest |u_B − u_A|, of several that in which the two are fastest, of several again all of them alike.
/// Equal masses that move oppositely along it are set anew both, and stay opposite: so names, mirrors and
/// exchanged axes change nothing. The value that makes v_n' = 0 is a quotient of exact sums, rounded once,
/// outwards. Where one component changes, no number nearer to it has the right sign.
///
/// After a pull v_n' = 0 will do only for a pair at rest: across the axis it would leave at once, so that
/// there one number further is taken.
///
/// @param u_A,u_B positions at the event, m_A,m_B masses in (0, ∞] (of bodies), v the rounded velocities,
/// leaving the sign wanted, image of B or null. @return v, mended. REQUIRES not both m = ∞, u_A ≠ u_B.
/// Laws: (1) afterwards the exact v_n' is ≥ 0 (`apart`), < 0 or the pair at rest (`together`);
/// (2) velocities that have the right sign are kept bitwise; (3) an infinite mass, and the heavier one,
/// keeps its velocity; (4) at most one component changes, and those that tie with it, of both bodies only
/// where they are equally heavy and opposite in it, by at most √D |v_n| of before, and one rounding; (5)
/// applied twice it is as applied once; (6) lengths times 2^k change nothing, velocities times 2^k multiply
/// by 2^k, bitwise, but where a 0 becomes the smallest number. Not finite numbers are handed back as they
/// are.
template <typename Scalar, int D>
PairVelocities<Scalar, D> directed(const Vector<Scalar, D>& u_A, const Vector<Scalar, D>& u_B,
                                   const std::type_identity_t<Scalar>& m_A,
                                   const std::type_identity_t<Scalar>& m_B, PairVelocities<Scalar, D> v,
                                   Leaving leaving, const PeriodicImage<Scalar, D>* image = nullptr) {
  using std::abs;
  const auto finite = [](const Vector<Scalar, D>& x) { return is_finite<Scalar, D>(x); };
  if (!finite(u_A) || !finite(u_B) || !finite(v.v_A) || !finite(v.v_B)) return v;
  if (detail::leaves<Scalar, D>(leaving, u_A, u_B, v, image)) return v;
  const std::vector<int> components = detail::components_along<Scalar, D>(
      image == nullptr ? Vector<Scalar, D>(u_B - u_A) : image->difference(u_A, u_B), v);
  const Dyadic r_w = detail::exact_dot<Scalar, D>(u_A, u_B, v.v_A, v.v_B, -1, image);
  const auto move = [&](Scalar& changed, const Dyadic& share, const Dyadic& toward_zero, Rounding outwards) {
    // changed + toward_zero / share, where the other changes make up the rest of r·w.
    changed = rounded_quotient<Scalar>(share * dyadic(changed) + toward_zero, share, outwards);
  };
  std::vector<std::pair<Scalar*, Rounding>> moved;
  for (const int k : components) {
    Scalar &x = v.v_A[k], &y = v.v_B[k];
    const Dyadic r_k = detail::exact_component<Scalar, D>(u_A, u_B, k, image);
    const Dyadic share = dyadic(Scalar(static_cast<int>(components.size()))) * r_k;
    const bool B_goes_up = (r_k.sign() > 0) == (leaving == Leaving::apart);
    const Rounding out_B = B_goes_up ? Rounding::up : Rounding::down;
    const Rounding out_A = B_goes_up ? Rounding::down : Rounding::up;
    const bool both = m_A == m_B && x == -y;
    const bool A = both || detail::changes_A<Scalar>(m_A, m_B, x, y, B_goes_up);
    const Dyadic part = both ? share + share : share;
    if (!A || both) {
      move(y, part, -r_w, out_B);
      moved.emplace_back(&y, out_B);
    }
    if (A) {
      move(x, part, r_w, out_A);
      moved.emplace_back(&x, out_A);
    }
  }
  if (detail::leaves<Scalar, D>(leaving, u_A, u_B, v, image)) return v;
  for (const auto& [changed, outwards] : moved) *changed = detail::next_velocity(*changed, outwards);
  return v;
}

}  // namespace tps

// Ways to write eq. (2) in rounded arithmetic, one change at a time from the textbook's formula, so that each
// can be charged for what it costs and credited with what it saves. The reference's own is
// eq2_collision_time.hpp.
#pragma once

#include <boost/math/tools/roots.hpp>
#include <cmath>

#include "reference/equations/timing_verdict.hpp"
#include "verify/exact/timing_query.hpp"

namespace tps::cost {

using exact::Kind;
using exact::TimingQuery;

/// The pair in relative coordinates, each difference rounded once.
template <typename Scalar>
struct Relative {
  Scalar r[3], v[3], L;
};

template <typename Scalar>
Relative<Scalar> relative(const TimingQuery& query) {
  Relative<Scalar> pair;
  for (std::size_t k = 0; k < 3; ++k) {
    pair.r[k] = Scalar(query.u_B[k]) - Scalar(query.u_A[k]);
    pair.v[k] = Scalar(query.v_B[k]) - Scalar(query.v_A[k]);
  }
  pair.L = Scalar(query.L);
  return pair;
}

template <typename Scalar>
Scalar dot(const Scalar (&x)[3], const Scalar (&y)[3]) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

/// The rule of semantics §1 on a t² + 2 h t + c with D = h² − a c: the root without cancellation.
template <typename Scalar>
CollisionTime<Scalar> by_the_rule(Kind kind, const Scalar& a, const Scalar& h, const Scalar& c,
                                  const Scalar& D) {
  using std::sqrt;
  const Scalar zero(0);
  if (a == zero) return {TimingVerdict::static_pair, std::nullopt};
  if (kind == Kind::block) {
    if (!(h < zero)) return {TimingVerdict::receding, std::nullopt};
    if (c < zero) return {TimingVerdict::overlap, zero};
    if (c == zero) return {TimingVerdict::contact, zero};
    if (D == zero) return {TimingVerdict::tangent, std::nullopt};
    if (!(D > zero)) return {TimingVerdict::miss, std::nullopt};
    return {TimingVerdict::hit, c / (-h + sqrt(D))};
  }
  if (c < zero) {
    const Scalar root = sqrt(D);
    return {TimingVerdict::hit, h > zero ? Scalar(-c / (h + root)) : Scalar((-h + root) / a)};
  }
  if (!(h < zero)) return {c == zero ? TimingVerdict::taut : TimingVerdict::overstretched, zero};
  if (c == zero) return {TimingVerdict::hit, Scalar(-2) * h / a};
  if (D > zero) return {TimingVerdict::hit, (-h + sqrt(D)) / a};
  return {TimingVerdict::turning, -h / a};
}

/// The stable root with the literal discriminant h² − a c.
template <typename Scalar>
CollisionTime<Scalar> root_time(const TimingQuery& query) {
  const Relative<Scalar> p = relative<Scalar>(query);
  const Scalar a = dot(p.v, p.v);
  const Scalar h = dot(p.r, p.v);
  const Scalar c = dot(p.r, p.r) - p.L * p.L;
  return by_the_rule<Scalar>(query.kind, a, h, c, h * h - a * c);
}

/// The same with D = a L² − |r × v|², which Lagrange's identity makes of it.
template <typename Scalar>
CollisionTime<Scalar> cross_time(const TimingQuery& query) {
  const Relative<Scalar> p = relative<Scalar>(query);
  const Scalar a = dot(p.v, p.v);
  const Scalar h = dot(p.r, p.v);
  const Scalar L_squared = p.L * p.L;
  const Scalar moment[3] = {p.r[1] * p.v[2] - p.r[2] * p.v[1], p.r[2] * p.v[0] - p.r[0] * p.v[2],
                            p.r[0] * p.v[1] - p.r[1] * p.v[0]};
  return by_the_rule<Scalar>(query.kind, a, h, dot(p.r, p.r) - L_squared,
                             a * L_squared - dot(moment, moment));
}

/// x y − z w with an error of at most 1.5 units in the last place (Kahan; Jeannerod, Louvet and Muller,
/// Math. Comp. 82, 2013).
template <typename Scalar>
Scalar difference_of_products(Scalar x, Scalar y, Scalar z, Scalar w) {
  const Scalar product = z * w;
  const Scalar error = std::fma(-z, w, product);
  return std::fma(x, y, -product) + error;
}

/// The same with h² − a c by Kahan's algorithm: exact to 1.5 ulp for the *rounded* a, h and c.
template <typename Scalar>
CollisionTime<Scalar> kahan_time(const TimingQuery& query) {
  const Relative<Scalar> p = relative<Scalar>(query);
  const Scalar a = dot(p.v, p.v);
  const Scalar h = dot(p.r, p.v);
  const Scalar c = dot(p.r, p.r) - p.L * p.L;
  return by_the_rule<Scalar>(query.kind, a, h, c, difference_of_products(h, h, a, c));
}

/// Boost.Math's quadratic_roots on a, 2h, c, and the rule on its roots. It gives NaN where there are none.
template <typename Scalar>
CollisionTime<Scalar> boost_time(const TimingQuery& query) {
  const Relative<Scalar> p = relative<Scalar>(query);
  const Scalar a = dot(p.v, p.v);
  const Scalar h = dot(p.r, p.v);
  const Scalar c = dot(p.r, p.r) - p.L * p.L;
  const Scalar zero(0);
  if (a == zero) return {TimingVerdict::static_pair, std::nullopt};
  if (query.kind == Kind::block) {
    if (!(h < zero)) return {TimingVerdict::receding, std::nullopt};
    if (!(c > zero)) return {TimingVerdict::overlap, zero};
  } else if (c >= zero && h >= zero) {
    return {TimingVerdict::overstretched, zero};
  }
  const auto [smaller, larger] = boost::math::tools::quadratic_roots(a, Scalar(2) * h, c);
  const bool apart = smaller < larger;
  if (query.kind == Kind::block) {
    if (!apart) return {TimingVerdict::miss, std::nullopt};
    return {TimingVerdict::hit, smaller};
  }
  if (!apart) return {TimingVerdict::turning, -h / a};
  return {TimingVerdict::hit, larger};
}

/// root_time of lengths and velocities divided by powers of two that bring the largest of each near 1. The
/// scaling is exact but for numbers that it makes subnormal, which vanish beside the largest.
template <typename Scalar>
CollisionTime<Scalar> scaled_time(const TimingQuery& query) {
  using std::fabs;
  Relative<Scalar> p = relative<Scalar>(query);
  Scalar length = p.L;
  Scalar speed(0);
  for (std::size_t k = 0; k < 3; ++k) {
    length = std::fmax(length, fabs(p.r[k]));
    speed = std::fmax(speed, fabs(p.v[k]));
  }
  int length_exponent = 0;
  int speed_exponent = 0;
  static_cast<void>(std::frexp(length, &length_exponent));
  static_cast<void>(std::frexp(speed, &speed_exponent));
  for (std::size_t k = 0; k < 3; ++k) {
    p.r[k] = std::ldexp(p.r[k], -length_exponent);
    p.v[k] = std::ldexp(p.v[k], -speed_exponent);
  }
  p.L = std::ldexp(p.L, -length_exponent);
  const Scalar a = dot(p.v, p.v);
  const Scalar h = dot(p.r, p.v);
  const Scalar c = dot(p.r, p.r) - p.L * p.L;
  CollisionTime<Scalar> answer = by_the_rule<Scalar>(query.kind, a, h, c, h * h - a * c);
  if (answer.t) answer.t = std::ldexp(*answer.t, length_exponent - speed_exponent);
  return answer;
}

}  // namespace tps::cost

// root_time in double words, about 106 bits: what twice the digits cost without leaving the hardware.
#pragma once

#include <cmath>

#include "reference/equations/timing_verdict.hpp"
#include "verify/exact/double_word.hpp"
#include "verify/exact/timing_query.hpp"

namespace tps::cost {

using exact::DoubleWord;

inline bool is_negative(DoubleWord x) {
  return x.hi < 0;
}
inline bool is_zero(DoubleWord x) {
  return x.hi == 0;
}

/// One long-division step behind the quotient of the high words: relative error a few u².
inline DoubleWord quotient(DoubleWord x, DoubleWord y) {
  const double first = x.hi / y.hi;
  const DoubleWord rest = x - y * first;
  return exact::fast_two_sum(first, rest.hi / y.hi);
}

/// One Newton step behind the root of the high word: relative error a few u². REQUIRES x ≥ 0.
inline DoubleWord square_root(DoubleWord x) {
  const double first = std::sqrt(x.hi);
  if (first == 0) return {0, 0};
  const DoubleWord rest = x - exact::two_product(first, first);
  return exact::fast_two_sum(first, rest.hi / (2 * first));
}

inline CollisionTime<DoubleWord> double_word_time(const exact::TimingQuery& query) {
  DoubleWord a{0, 0}, h{0, 0}, c = -exact::two_product(query.L, query.L);
  for (std::size_t k = 0; k < 3; ++k) {
    const DoubleWord r = exact::two_sum(query.u_B[k], -query.u_A[k]);
    const DoubleWord v = exact::two_sum(query.v_B[k], -query.v_A[k]);
    a = a + v * v;
    h = h + r * v;
    c = c + r * r;
  }
  const DoubleWord zero{0, 0};
  if (is_static(query)) return {TimingVerdict::static_pair, std::nullopt};
  const bool approaching = is_negative(h);
  if (query.kind == exact::Kind::block) {
    if (!approaching) return {TimingVerdict::receding, std::nullopt};
    if (is_negative(c)) return {TimingVerdict::overlap, zero};
    if (is_zero(c)) return {TimingVerdict::contact, zero};
  } else if (!is_negative(c) && !approaching) {
    return {is_zero(c) ? TimingVerdict::taut : TimingVerdict::overstretched, zero};
  }
  const DoubleWord D = h * h - a * c;
  const bool real = D.hi > 0;
  if (query.kind == exact::Kind::block) {
    if (is_zero(D)) return {TimingVerdict::tangent, std::nullopt};
    if (!real) return {TimingVerdict::miss, std::nullopt};
    return {TimingVerdict::hit, quotient(c, square_root(D) - h)};
  }
  if (is_negative(c) && !approaching) return {TimingVerdict::hit, quotient(-c, square_root(D) + h)};
  if (!real) return {TimingVerdict::turning, quotient(-h, a)};
  return {TimingVerdict::hit, quotient(square_root(D) - h, a)};
}

}  // namespace tps::cost

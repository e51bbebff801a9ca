// Stage 2: the coefficients in double words from the exact r and v (docs/exact.md, "Stage 2").
#pragma once

#include <array>

#include "verify/exact/double_filter.hpp"
#include "verify/exact/double_word.hpp"

namespace tps::exact {

/// y − x of each component, exactly. REQUIRES no overflow.
template <typename T>
TPS_IN_EVERY_COPY std::array<Words<T>, 3> exact_difference(const std::array<T, 3>& y,
                                                           const std::array<T, 3>& x) {
  return {two_sum(y[0], -x[0]), two_sum(y[1], -x[1]), two_sum(y[2], -x[2])};
}

/// x y, its low part in double and not normalised.
template <typename T>
TPS_IN_EVERY_COPY Words<T> rough_product(Words<T> x, Words<T> y) {
  const Words<T> product = two_product(x.hi, y.hi);
  return {product.hi, product.lo + multiply_add(x.hi, y.lo, x.lo * y.hi)};
}

/// x·y to 20u² Σ|x_k y_k| (docs/exact.md, "Stage 2"): the compensated dot product of Ogita, Rump and Oishi,
/// "Accurate sum and dot product", SIAM J. Sci. Comput. 26(6), 2005, of double words. Its parts are not
/// normalised: |lo| ≤ 5u Σ|x_k y_k|.
template <typename T>
TPS_IN_EVERY_COPY Words<T> dot(const std::array<Words<T>, 3>& x, const std::array<Words<T>, 3>& y) {
  const Words<T> p = rough_product(x[0], y[0]), q = rough_product(x[1], y[1]), r = rough_product(x[2], y[2]);
  const Words<T> two = two_sum(p.hi, q.hi);
  const Words<T> three = two_sum(two.hi, r.hi);
  return {three.hi, ((p.lo + q.lo) + r.lo) + (two.lo + three.lo)};
}

/// r of a query: exact, or of an image within 3u² of itself, as the sum of two double words is.
TPS_IN_EVERY_COPY std::array<DoubleWord, 3> relative_position(const TimingQuery& query) {
  std::array<DoubleWord, 3> r = exact_difference(query.u_B, query.u_A);
  if (is_at_home(query)) return r;
  for (std::size_t k = 0; k < 3; ++k) r[k] = r[k] + two_product(query.image[k], query.edges[k]);
  return r;
}

/// By how much the bounds are wider that count r as exact (docs/exact.md, "Images").
inline double widening(const TimingQuery& query) {
  return is_at_home(query) ? 1 : 2;
}

/// a, h, c, D with errors of order u², rounded to double at the end. The bounds include that last rounding
/// only as far as signs go: rounding to double cannot change a sign.
/// Law: where `in_range`, a sign certified here is the exact one.
Coefficients double_word_coefficients(const TimingQuery& query);

}  // namespace tps::exact

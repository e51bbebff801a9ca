// Stage 2: the coefficients in double words from the exact r and v (docs/exact.md, "Stage 2").
#pragma once

#include <array>

#include "verify/exact/double_filter.hpp"
#include "verify/exact/double_word.hpp"

namespace tps::exact {

/// y − x of each component, exactly. REQUIRES no overflow.
TPS_IN_EVERY_COPY std::array<DoubleWord, 3> exact_difference(const Vec3& y, const Vec3& x) {
  return {two_sum(y[0], -x[0]), two_sum(y[1], -x[1]), two_sum(y[2], -x[2])};
}

/// x·y to 20u² Σ|x_k y_k| (docs/exact.md, "Stage 2"): the compensated dot product of Ogita, Rump and Oishi,
/// "Accurate sum and dot product", SIAM J. Sci. Comput. 26(6), 2005, of double words. Its parts are not
/// normalised: |lo| ≤ 5u Σ|x_k y_k|.
TPS_IN_EVERY_COPY DoubleWord dot(const std::array<DoubleWord, 3>& x, const std::array<DoubleWord, 3>& y) {
  std::array<double, 3> high, low;
  for (std::size_t k = 0; k < 3; ++k) {
    const DoubleWord product = two_product(x[k].hi, y[k].hi);
    high[k] = product.hi;
    low[k] = product.lo + __builtin_fma(x[k].hi, y[k].lo, x[k].lo * y[k].hi);
  }
  const DoubleWord two = two_sum(high[0], high[1]);
  const DoubleWord three = two_sum(two.hi, high[2]);
  return {three.hi, ((low[0] + low[1]) + low[2]) + (two.lo + three.lo)};
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

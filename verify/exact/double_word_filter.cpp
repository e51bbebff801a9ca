#include "verify/exact/double_word_filter.hpp"

#include "verify/exact/double_word_values.hpp"

namespace tps::exact {

namespace {

/// With the sizes H of the terms of h, and M of those of c.
struct Sized {
  DoubleWordValues values;
  double H, M;
};

TPS_IN_EVERY_COPY Sized sized(const TimingQuery& query) {
  const std::array<DoubleWord, 3> r = relative_position(query);
  const std::array<DoubleWord, 3> v = exact_difference(query.v_B, query.v_A);

  const DoubleWord a_parts = dot(v, v), r_parts = dot(r, r), h_parts = dot(r, v);
  const DoubleWord a = fast_two_sum(a_parts.hi, a_parts.lo);
  const DoubleWord r_squared = fast_two_sum(r_parts.hi, r_parts.lo);
  const DoubleWord h = two_sum(h_parts.hi, h_parts.lo);
  const DoubleWord L_squared = two_product(query.L, query.L);
  const DoubleWord c_high = two_sum(r_squared.hi, -L_squared.hi);
  const DoubleWord c = two_sum(c_high.hi, c_high.lo + (r_squared.lo - L_squared.lo));

  const DoubleWord h_squared = two_product(h.hi, h.hi);
  const DoubleWord a_c = two_product(a.hi, c.hi);
  const DoubleWord D_high = two_sum(h_squared.hi, -a_c.hi);
  const double crossed = 2 * (h.hi * h.lo) - __builtin_fma(a.hi, c.lo, a.lo * c.hi);
  const DoubleWord D = two_sum(D_high.hi, (D_high.lo + (h_squared.lo - a_c.lo)) + crossed);

  const double M = r_squared.hi + L_squared.hi;
  const double H = std::fabs(r[0].hi * v[0].hi) + std::fabs(r[1].hi * v[1].hi) + std::fabs(r[2].hi * v[2].hi);
  return {{a, h, c, D}, H, M};
}

}  // namespace

TPS_WITH_FMA Coefficients double_word_coefficients(const TimingQuery& query) {
  constexpr double u2 = unit_roundoff * unit_roundoff;
  const auto [values, H, M] = sized(query);
  const double a = values.a.hi;
  const double wide = widening(query);
  return {a,
          values.h.hi,
          values.c.hi,
          values.D.hi,
          wide * 21 * u2 * H + underflow_allowance,
          wide * 24 * u2 * M,
          wide * 60 * u2 * (H * H + a * M),
          comfortable(a) && comfortable(M)};
}

TPS_WITH_FMA DoubleWordValues double_word_values(const TimingQuery& query) {
  return sized(query).values;
}

}  // namespace tps::exact

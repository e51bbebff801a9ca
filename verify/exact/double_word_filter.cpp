#include "verify/exact/double_word_filter.hpp"

namespace tps::exact {

TPS_WITH_FMA Coefficients double_word_coefficients(const TimingQuery& query) {
  constexpr double u2 = unit_roundoff * unit_roundoff;
  const std::array<DoubleWord, 3> r = relative_position(query);
  const std::array<DoubleWord, 3> v = exact_difference(query.v_B, query.v_A);

  const DoubleWord a = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  const DoubleWord r_squared = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
  const DoubleWord L_squared = two_product(query.L, query.L);
  const DoubleWord h_x = r[0] * v[0];
  const DoubleWord h_y = r[1] * v[1];
  const DoubleWord h_z = r[2] * v[2];
  const DoubleWord h = h_x + h_y + h_z;
  const DoubleWord c = r_squared - L_squared;
  const DoubleWord D = h * h - a * c;

  const double wide = widening(query);
  const double M = r_squared.hi + L_squared.hi;
  const double H = std::fabs(h_x.hi) + std::fabs(h_y.hi) + std::fabs(h_z.hi);
  return {a.hi,
          h.hi,
          c.hi,
          D.hi,
          wide * 12 * u2 * H + underflow_allowance,
          wide * 15 * u2 * M,
          wide * 36 * u2 * (H * H + a.hi * M),
          comfortable(a.hi) && comfortable(M)};
}

}  // namespace tps::exact

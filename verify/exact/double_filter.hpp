// Stage 1: the coefficients in double, each with a proven bound on its error (docs/exact.md, "Stage 1").
#pragma once

#include <cmath>
#include <optional>

#include "verify/exact/timing_query.hpp"
#include "verify/exact/verdict.hpp"

namespace tps::exact {

constexpr double unit_roundoff = 0x1p-53;
/// Pays for products that underflow; see "Range" in docs/exact.md.
constexpr double underflow_allowance = 0x1p-1000;

/// Coefficients known to double or double-word precision, rounded to double, with bounds:
/// |h − h_true| ≤ h_error and so on; |a − a_true| ≤ 6u a.
struct Coefficients {
  double a, h, c, D;
  double h_error, c_error, D_error;
  bool in_range;  ///< the bounds hold; false says nothing but "ask the next stage"

  constexpr std::optional<Verdict> verdict(Kind kind) const {
    if (!in_range) return std::nullopt;
    return decide(kind, sign_within(h, h_error), sign_within(c, c_error), sign_within(D, D_error));
  }
};

/// Whether squares of lengths (or speeds) leave room for every product of the filters: false for NaN.
constexpr bool comfortable(double square) {
  return square > 0x1p-400 && square < 0x1p400;
}

/// The same of an image: r is rounded three times, from terms that cancel. Bounds are those of the sizes S of
/// the terms (docs/exact.md, "Images").
inline Coefficients coefficients_of_image(const TimingQuery& query) {
  constexpr double u = unit_roundoff;
  double a = 0, h = 0, H = 0, r_squared = 0, S_squared = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double apart = query.u_B[k] - query.u_A[k];
    const double shift = query.image[k] * query.edges[k];
    const double r = apart + shift;
    const double S = std::fabs(apart) + std::fabs(shift);
    const double v = query.v_B[k] - query.v_A[k];
    a += v * v;
    h += r * v;
    H += S * std::fabs(v);
    r_squared += r * r;
    S_squared += S * S;
  }
  const double L_squared = query.L * query.L;
  const double c = r_squared - L_squared;
  const double M = S_squared + L_squared;
  const double D = h * h - a * c;
  return {a,
          h,
          c,
          D,
          16 * u * H + underflow_allowance,
          16 * u * M,
          48 * u * (H * H + a * M),
          comfortable(a) && comfortable(M)};
}

/// a, h, c, D from rounded r and v, in the obvious order.
/// REQUIRES a valid query. Compiled without contraction to fma: the count of roundings assumes none.
inline Coefficients double_coefficients(const TimingQuery& query) {
  if (!is_at_home(query)) return coefficients_of_image(query);
  constexpr double u = unit_roundoff;
  const double r_x = query.u_B[0] - query.u_A[0];
  const double r_y = query.u_B[1] - query.u_A[1];
  const double r_z = query.u_B[2] - query.u_A[2];
  const double v_x = query.v_B[0] - query.v_A[0];
  const double v_y = query.v_B[1] - query.v_A[1];
  const double v_z = query.v_B[2] - query.v_A[2];

  const double a = v_x * v_x + v_y * v_y + v_z * v_z;
  const double r_squared = r_x * r_x + r_y * r_y + r_z * r_z;
  const double L_squared = query.L * query.L;
  const double c = r_squared - L_squared;
  const double M = r_squared + L_squared;
  const double h_x = r_x * v_x;
  const double h_y = r_y * v_y;
  const double h_z = r_z * v_z;
  const double h = h_x + h_y + h_z;
  const double H = std::fabs(h_x) + std::fabs(h_y) + std::fabs(h_z);
  const double D = h * h - a * c;

  return {a,
          h,
          c,
          D,
          6 * u * H + underflow_allowance,
          7 * u * M,
          14 * u * (H * H + a * M),
          comfortable(a) && comfortable(M)};
}

}  // namespace tps::exact

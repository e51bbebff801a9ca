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

/// a, h, c, D from rounded r and v, in the obvious order.
/// REQUIRES a valid query. Compiled without contraction to fma: the count of roundings assumes none.
/// Of an image r is a double word first: this stage leaves it to the next one.
inline Coefficients double_coefficients(const TimingQuery& query) {
  if (!is_at_home(query)) return {};
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

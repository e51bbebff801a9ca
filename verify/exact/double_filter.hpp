// Stage 1: the coefficients in double, each with a proven bound on its error (docs/exact.md, "Stage 1").
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "verify/exact/in_every_copy.hpp"
#include "verify/exact/timing_query.hpp"
#include "verify/exact/verdict.hpp"

namespace tps::exact {

constexpr double unit_roundoff = 0x1p-53;
TPS_IN_EVERY_COPY double absolute(double x) {
  return std::fabs(x);
}

TPS_IN_EVERY_COPY bool both(bool x, bool y) {
  return x && y;
}

/// Pays for products that underflow; see "Range" in docs/exact.md.
constexpr double underflow_allowance = 0x1p-1000;

/// What a comparison of T gives: bool, or a mask where T is several doubles (four_doubles.hpp).
template <typename T>
using Truth = decltype(T() < T());

/// Coefficients known to double or double-word precision, rounded to double, with bounds:
/// |h − h_true| ≤ h_error and so on; |a − a_true| ≤ 6u a.
template <typename T>
struct CoefficientsIn {
  T a, h, c, D;
  T h_error, c_error, D_error;
  Truth<T> in_range;  ///< the bounds hold; false says nothing but "ask the next stage"

  constexpr std::optional<Verdict> verdict(Kind kind) const {
    if (!in_range) return std::nullopt;
    return decide(kind, sign_within(h, h_error), sign_within(c, c_error), sign_within(D, D_error));
  }
};
using Coefficients = CoefficientsIn<double>;

/// Whether squares of lengths (or speeds) leave room for every product of the filters: false for NaN.
template <typename T>
constexpr Truth<T> comfortable(T square) {
  return (square > T(0x1p-400)) & (square < T(0x1p400));
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

/// a, h, c, D from rounded r and v, in the obvious order, of one query or (T = Four) of four at once.
/// Compiled without contraction to fma: the count of roundings assumes none.
template <typename T>
TPS_IN_EVERY_COPY CoefficientsIn<T> coefficients_at_home(const std::array<T, 3>& u_A,
                                                         const std::array<T, 3>& u_B,
                                                         const std::array<T, 3>& v_A,
                                                         const std::array<T, 3>& v_B, T L) {
  constexpr double u = unit_roundoff;
  const T r_x = u_B[0] - u_A[0];
  const T r_y = u_B[1] - u_A[1];
  const T r_z = u_B[2] - u_A[2];
  const T v_x = v_B[0] - v_A[0];
  const T v_y = v_B[1] - v_A[1];
  const T v_z = v_B[2] - v_A[2];

  const T a = v_x * v_x + v_y * v_y + v_z * v_z;
  const T r_squared = r_x * r_x + r_y * r_y + r_z * r_z;
  const T L_squared = L * L;
  const T c = r_squared - L_squared;
  const T M = r_squared + L_squared;
  const T h_x = r_x * v_x;
  const T h_y = r_y * v_y;
  const T h_z = r_z * v_z;
  const T h = h_x + h_y + h_z;
  const T H = absolute(h_x) + absolute(h_y) + absolute(h_z);
  const T D = h * h - a * c;

  const Truth<T> in_range = both(comfortable(a), comfortable(M));
  return {a, h, c, D, 6 * u * H + T(underflow_allowance), 7 * u * M, 14 * u * (H * H + a * M), in_range};
}

/// Those of one query. REQUIRES a valid query.
inline Coefficients double_coefficients(const TimingQuery& query) {
  if (!is_at_home(query)) return coefficients_of_image(query);
  return coefficients_at_home(query.u_A, query.u_B, query.v_A, query.v_B, query.L);
}

}  // namespace tps::exact

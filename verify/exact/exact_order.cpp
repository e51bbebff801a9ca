#include "verify/exact/exact_order.hpp"

namespace tps::exact {
namespace {

/// The sign of x + y from the signs of x and y and of |x| − |y|.
Sign sign_of_two(Sign x, Sign y, const Integer& x_squared_minus_y_squared) {
  if (x == y || y == Sign::zero) return x;
  if (x == Sign::zero) return y;
  const Sign larger = sign_of(x_squared_minus_y_squared);
  if (larger == Sign::zero) return Sign::zero;
  return larger == Sign::positive ? x : y;
}

Sign sign_of_root(const Integer& Y, const Integer& A) {
  return A == 0 ? Sign::zero : sign_of(Y);
}

}  // namespace

Sign sign_of_sum(const Integer& X, const Integer& Y, const Integer& A) {
  return sign_of_two(sign_of(X), sign_of_root(Y, A), X * X - Y * Y * A);
}

Sign sign_of_sum(const Integer& X, const Integer& Y, const Integer& A, const Integer& Z, const Integer& B) {
  const Integer Y2A = Y * Y * A;
  const Integer Z2B = Z * Z * B;
  // S = Y√A + Z√B, then X + S; S² − X² is itself a number of the form M + N√R.
  const Sign S = sign_of_two(sign_of_root(Y, A), sign_of_root(Z, B), Y2A - Z2B);
  const Sign X_sign = sign_of(X);
  if (X_sign == S || S == Sign::zero) return X_sign;
  if (X_sign == Sign::zero) return S;
  const Sign smaller = sign_of_sum(Y2A + Z2B - X * X, 2 * Y * Z, A * B);
  if (smaller == Sign::zero) return Sign::zero;
  return smaller == Sign::positive ? S : X_sign;
}

AlgebraicTime stretched(const AlgebraicTime& time, const Integer& factor) {
  return {time.a, time.h * factor, time.D * factor * factor, time.side, time.time_exponent};
}

Sign sign_of_difference(const AlgebraicTime& first, const AlgebraicTime& second, const Integer& offset) {
  // offset + (−h₁ + s₁√D₁)/a₁ − (−h₂ + s₂√D₂)/a₂, times a₁ a₂ > 0.
  return sign_of_sum(offset * first.a * second.a + second.h * first.a - first.h * second.a,
                     first.side * second.a, first.D, -second.side * first.a, second.D);
}

}  // namespace tps::exact

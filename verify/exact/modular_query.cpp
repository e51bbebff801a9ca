#include "verify/exact/modular_query.hpp"

#include <array>
#include <cmath>

#include "verify/exact/lifted_query.hpp"
#include "verify/exact/refined_root.hpp"

namespace tps::exact {
namespace {

using Vector = std::array<ModularInteger, 3>;

Vector difference(const Vec3& y, const Vec3& x, int unit) {
  Vector all;
  for (std::size_t k = 0; k < 3; ++k) all[k] = ModularInteger::difference(y[k], x[k], unit);
  return all;
}

ModularInteger dot(const Vector& x, const Vector& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

/// Whether a number that is `x` up to `error` leaves room for its sign, in units of 2^unit.
bool fits(double x, double error, int unit) {
  return std::fabs(x) + error < std::ldexp(1.0, unit + ModularInteger::kMostBits - 1);
}

Sign sign_of(const ModularInteger& x) {
  const int sign = x.sign();
  return sign < 0 ? Sign::negative : sign > 0 ? Sign::positive : Sign::zero;
}

DoubleWord in_double_words(const ModularInteger& x) {
  if (x.sign() == 0) return {0, 0};
  return x.sign() < 0 ? -x.magnitude() : x.magnitude();
}

/// √x to 5u²: one Newton step from the root of the high part (docs/exact.md, "Integers of 256 bits").
/// REQUIRES x > 0.
TPS_IN_EVERY_COPY DoubleWord square_root(DoubleWord x) {
  const double root = std::sqrt(x.hi);
  const DoubleWord rest = x - two_product(root, root);
  return fast_two_sum(root, rest.hi / (2 * root));
}

/// x/y to 8u², as a first quotient and that of the rest.
TPS_IN_EVERY_COPY RefinedTime quotient(DoubleWord x, DoubleWord y) {
  const double first = x.hi / y.hi;
  const DoubleWord rest = x - y * first;
  return {first, rest.hi / y.hi, 0};
}

}  // namespace

std::optional<ModularQuadratic> modular_quadratic(const TimingQuery& query, const Coefficients& bounds) {
  if (!bounds.in_range) return std::nullopt;
  const LiftUnits units = units_of(query);
  const int of_h = units.length + units.speed;
  if (!fits(2 * bounds.a, 0, 2 * units.speed) || !fits(bounds.h, bounds.h_error, of_h) ||
      !fits(bounds.c, bounds.c_error, 2 * units.length) || !fits(bounds.D, bounds.D_error, 2 * of_h)) {
    return std::nullopt;
  }
  Vector r = difference(query.u_B, query.u_A, units.length);
  for (std::size_t k = 0; k < 3; ++k) {
    if (query.image[k] == 0) continue;
    r[k] = r[k] +
           ModularInteger::lifted(query.image[k], 0) * ModularInteger::lifted(query.edges[k], units.length);
  }
  const Vector v = difference(query.v_B, query.v_A, units.speed);
  const ModularInteger L = ModularInteger::lifted(query.L, units.length);
  ModularQuadratic q{dot(v, v), dot(r, v), dot(r, r) - L * L, {}, units.length - units.speed};
  q.D = q.h * q.h - q.a * q.c;
  return q;
}

Verdict verdict_of(Kind kind, const ModularQuadratic& q) {
  return *decide(kind, sign_of(q.h), sign_of(q.c), sign_of(q.D));
}

TPS_WITH_FMA std::optional<double> rounded_time(Kind kind, Verdict verdict, const ModularQuadratic& q) {
  const DoubleWord a = in_double_words(q.a), h = in_double_words(q.h), c = in_double_words(q.c);
  RefinedTime time{};
  if (verdict == Verdict::turning) {
    time = quotient(-h, a);
  } else {
    const DoubleWord root = q.D.sign() > 0 ? square_root(in_double_words(q.D)) : DoubleWord{0, 0};
    const bool adds = kind != Kind::block && h.hi <= 0;
    const DoubleWord sum = (h.hi > 0 ? h : -h) + root;  // of one sign: nothing cancels
    time = adds ? quotient(sum, a) : quotient(c.hi > 0 ? c : -c, sum);
  }
  constexpr double kError = 32 * unit_roundoff * unit_roundoff;
  time.error = kError * time.t;
  // So far from the ends of the range nothing is lost by the power of two.
  if (!(std::ldexp(time.t, q.time_exponent) > 0x1p-800 && std::ldexp(time.t, q.time_exponent) < 0x1p800))
    return std::nullopt;
  const std::optional<double> rounded = time.rounded();
  if (!rounded) return std::nullopt;
  return std::ldexp(*rounded, q.time_exponent);
}

}  // namespace tps::exact

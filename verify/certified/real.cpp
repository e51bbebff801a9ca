#include "verify/certified/real.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <optional>

namespace tps::certified {
namespace {

constexpr std::size_t kMaxBits = std::size_t{1} << 14;

bool too_large(const Rational& x) {
  const Integer n = abs(numerator(x));
  return (n != 0 && msb(n) > kMaxBits) || msb(denominator(x)) > kMaxBits;
}

Interval widened(const Wide& lo, const Wide& hi) {
  static const Wide margin = ldexp(Wide(1), -400);
  return {lo - abs(lo) * margin, hi + abs(hi) * margin};
}

/// A value computed by the library to a few units in the last place.
Interval around(const Wide& x) {
  return widened(x, x);
}

Interval enclosed(const Rational& x) {
  return around(Wide(numerator(x)) / Wide(denominator(x)));
}

Interval hull(const Wide& a, const Wide& b, const Wide& c, const Wide& d) {
  return widened(std::min({a, b, c, d}), std::max({a, b, c, d}));
}

template <typename RationalOperation, typename IntervalOperation>
Real combined(const Real& x, const Real& y, RationalOperation exactly, IntervalOperation outward) {
  if (x.rational() != nullptr && y.rational() != nullptr) return exactly(*x.rational(), *y.rational());
  return outward(x.interval(), y.interval());
}

bool is_zero(const Real& x) {
  return x.rational() != nullptr && *x.rational() == 0;
}

std::optional<Integer> integer_root(const Integer& x) {
  const Integer root = sqrt(x);
  if (root * root != x) return std::nullopt;
  return root;
}

std::optional<Rational> rational_root(const Rational& x) {
  const std::optional<Integer> n = integer_root(numerator(x));
  if (!n) return std::nullopt;
  const std::optional<Integer> d = integer_root(denominator(x));
  if (!d) return std::nullopt;
  return Rational(*n, *d);
}

}  // namespace

Real::Real(Rational x) : value_(std::move(x)) {
  const Rational& kept = std::get<Rational>(value_);
  if (too_large(kept)) value_ = enclosed(kept);
}

Real Real::of(double x) {
  int exponent = 0;
  const Integer mantissa(static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53)));
  exponent -= 53;
  const Integer power = Integer(1) << static_cast<unsigned>(std::abs(exponent));
  return exponent >= 0 ? Rational(mantissa * power) : Rational(mantissa, power);
}

Interval Real::interval() const {
  const Rational* x = rational();
  return x != nullptr ? enclosed(*x) : std::get<Interval>(value_);
}

Real operator+(const Real& x, const Real& y) {
  if (is_zero(x)) return y;
  if (is_zero(y)) return x;
  return combined(
      x, y, [](const Rational& a, const Rational& b) { return Real(Rational(a + b)); },
      [](const Interval& a, const Interval& b) { return Real(widened(a.lo + b.lo, a.hi + b.hi)); });
}

Real operator-(const Real& x, const Real& y) {
  return x + Real(-1) * y;
}

Real operator*(const Real& x, const Real& y) {
  if (is_zero(x) || is_zero(y)) return Real(0);
  return combined(
      x, y, [](const Rational& a, const Rational& b) { return Real(Rational(a * b)); },
      [](const Interval& a, const Interval& b) {
        return Real(hull(a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi));
      });
}

Real operator/(const Real& x, const Real& y) {
  if (is_zero(x)) return Real(0);
  return combined(
      x, y, [](const Rational& a, const Rational& b) { return Real(Rational(a / b)); },
      [](const Interval& a, const Interval& b) {
        return Real(hull(a.lo / b.lo, a.lo / b.hi, a.hi / b.lo, a.hi / b.hi));
      });
}

Real sqrt(const Real& x) {
  if (x.rational() != nullptr) {
    if (const std::optional<Rational> root = rational_root(*x.rational())) return *root;
  }
  const Interval inside = x.interval();
  const auto root = [](const Wide& end) { return end > 0 ? Wide(sqrt(end)) : Wide(0); };
  return widened(root(inside.lo), root(inside.hi));
}

Sign sign(const Real& x) {
  if (const Rational* exactly = x.rational()) {
    return *exactly == 0 ? Sign::zero : *exactly > 0 ? Sign::positive : Sign::negative;
  }
  const Interval inside = x.interval();
  if (inside.lo > 0) return Sign::positive;
  if (inside.hi < 0) return Sign::negative;
  return Sign::uncertain;
}

Real cos_squared_degrees(double theta_deg) {
  if (theta_deg == 30) return Rational(3, 4);
  if (theta_deg == 45) return Rational(1, 2);
  if (theta_deg == 60) return Rational(1, 4);
  const Wide half_turn = boost::math::constants::pi<Wide>();
  // Near 90° the cosine is the sine of the small complement, which is exact in degrees.
  const Wide cosine = theta_deg > 45 ? Wide(sin((Wide(90) - Wide(theta_deg)) * half_turn / 180))
                                     : Wide(cos(Wide(theta_deg) * half_turn / 180));
  return around(cosine * cosine);
}

Real squared_speed_ratio(double c, double theta_deg) {
  if (c == 0 || c == 1) return Real(static_cast<int>(c));
  if (theta_deg == 45) return sqrt(Real::of(c));
  return around(pow(Wide(c), Wide(theta_deg) / 90));
}

RealVector lifted(const std::vector<double>& x) {
  RealVector result;
  for (const double component : x) result.push_back(Real::of(component));
  return result;
}

RealVector operator+(const RealVector& x, const RealVector& y) {
  RealVector sum;
  for (std::size_t k = 0; k < x.size(); ++k) sum.push_back(x[k] + y[k]);
  return sum;
}

RealVector operator-(const RealVector& x, const RealVector& y) {
  return x + Real(-1) * y;
}

RealVector operator*(const Real& factor, const RealVector& x) {
  RealVector product;
  for (const Real& component : x) product.push_back(factor * component);
  return product;
}

Real dot(const RealVector& x, const RealVector& y) {
  Real sum;
  for (std::size_t k = 0; k < x.size(); ++k) sum = sum + x[k] * y[k];
  return sum;
}

}  // namespace tps::certified

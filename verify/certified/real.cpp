#include "verify/certified/real.hpp"

#include <array>
#include <cmath>
#include <optional>

namespace tps::certified {
namespace {

constexpr std::size_t kMaxBits = std::size_t{1} << 14;

bool too_large(const Rational& x) {
  const Integer n = abs(numerator(x));
  return (n != 0 && msb(n) > kMaxBits) || msb(denominator(x)) > kMaxBits;
}

Ball ball_of(const Surd& x) {
  return Ball(x.a) + Ball(x.b) * sqrt(Ball(x.D));
}

bool is_zero(const Real& x) {
  return x.rational() != nullptr && *x.rational() == 0;
}

/// Both over one root, where they have it in common.
std::optional<std::pair<Surd, Surd>> over_one_root(const Real& x, const Real& y) {
  if (x.surd() == nullptr || y.surd() == nullptr) return std::nullopt;
  const std::optional<Surd> second = over_root(*y.surd(), x.surd()->D);
  if (!second) return std::nullopt;
  return std::pair(*x.surd(), *second);
}

Real scaled(const Surd& x, const Rational& factor) {
  return Surd{x.a * factor, x.b * factor, x.D};
}

/// The q-th root of a positive integer, where it is one.
std::optional<Integer> integer_root(const Integer& x, unsigned q) {
  Integer lo = 1, hi = (Integer(1) << (static_cast<unsigned>(msb(x)) / q + 1));
  while (lo < hi) {  // the largest whose power is not above x
    const Integer middle = (lo + hi + 1) / 2;
    if (pow(middle, q) <= x) {
      lo = middle;
    } else {
      hi = middle - 1;
    }
  }
  if (pow(lo, q) != x) return std::nullopt;
  return lo;
}

/// The q-th root of a double in (0, 1], where it is rational.
std::optional<Rational> double_root(double c, unsigned q) {
  int exponent = 0;
  Integer odd(static_cast<std::int64_t>(std::ldexp(std::frexp(c, &exponent), 53)));
  exponent -= 53;
  const auto twos = static_cast<unsigned>(lsb(odd));
  odd >>= twos;
  exponent += static_cast<int>(twos);
  if (exponent % static_cast<int>(q) != 0) return std::nullopt;
  const std::optional<Integer> root = integer_root(odd, q);
  if (!root) return std::nullopt;
  const int power = exponent / static_cast<int>(q);
  const Integer two_power = Integer(1) << static_cast<unsigned>(std::abs(power));
  return power >= 0 ? Rational(*root * two_power) : Rational(*root, two_power);
}

Rational whole_power(const Rational& x, unsigned n) {
  return Rational(pow(numerator(x), n), pow(denominator(x), n));
}

}  // namespace

Real::Real(Rational x) : value_(std::move(x)) {
  const Rational& kept = std::get<Rational>(value_);
  if (too_large(kept)) value_ = Ball(kept);
}

Real::Real(Surd x) : value_(std::move(x)) {
  const Surd& kept = std::get<Surd>(value_);
  if (too_large(kept.a) || too_large(kept.b) || too_large(kept.D)) value_ = ball_of(kept);
}

Real::Real(SurdOrRational x) : Real(std::visit([](auto& exactly) { return Real(std::move(exactly)); }, x)) {}

Real Real::of(double x) {
  int exponent = 0;
  const Integer mantissa(static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53)));
  exponent -= 53;
  const Integer power = Integer(1) << static_cast<unsigned>(std::abs(exponent));
  return exponent >= 0 ? Rational(mantissa * power) : Rational(mantissa, power);
}

Ball Real::ball() const {
  if (const Rational* x = rational()) return Ball(*x);
  if (const Surd* x = surd()) return ball_of(*x);
  return std::get<Ball>(value_);
}

Real operator+(const Real& x, const Real& y) {
  if (is_zero(x)) return y;
  if (is_zero(y)) return x;
  if (x.rational() != nullptr && y.rational() != nullptr) return Rational(*x.rational() + *y.rational());
  if (x.surd() != nullptr && y.rational() != nullptr)
    return Surd{x.surd()->a + *y.rational(), x.surd()->b, x.surd()->D};
  if (x.rational() != nullptr && y.surd() != nullptr) return y + x;
  if (const auto both = over_one_root(x, y)) return sum(both->first, both->second);
  return x.ball() + y.ball();
}

Real operator-(const Real& x, const Real& y) {
  return x + Real(-1) * y;
}

Real operator*(const Real& x, const Real& y) {
  if (is_zero(x) || is_zero(y)) return Real(0);
  if (x.rational() != nullptr && y.rational() != nullptr) return Rational(*x.rational() * *y.rational());
  if (x.surd() != nullptr && y.rational() != nullptr) return scaled(*x.surd(), *y.rational());
  if (x.rational() != nullptr && y.surd() != nullptr) return scaled(*y.surd(), *x.rational());
  if (const auto both = over_one_root(x, y)) return product(both->first, both->second);
  return x.ball() * y.ball();
}

Real operator/(const Real& x, const Real& y) {
  if (is_zero(x)) return Real(0);
  if (y.rational() != nullptr) return x * Real(Rational(1 / *y.rational()));
  if (y.surd() != nullptr) return x * Real(inverse(*y.surd()));
  return x.ball() / y.ball();
}

Real sqrt(const Real& x) {
  if (const Rational* exactly = x.rational()) {
    if (const std::optional<Rational> root = rational_root(*exactly)) return *root;
    return Surd{0, 1, *exactly};
  }
  if (x.surd() != nullptr && sign(*x.surd()) == Sign::positive) {
    if (const std::optional<SurdOrRational> root = root_within(*x.surd())) return *root;
  }
  return sqrt(x.ball());
}

Sign sign(const Real& x) {
  if (const Rational* exactly = x.rational())
    return *exactly == 0 ? Sign::zero : *exactly > 0 ? Sign::positive : Sign::negative;
  if (const Surd* exactly = x.surd()) return sign(*exactly);
  return x.ball().sign();
}

Real cos_squared_degrees(double theta_deg) {
  // cos²θ = (1 + cos 2θ)/2 = a + b√D.
  struct Exact {
    double theta;
    Rational a, b;
    int D;
  };
  static const std::array<Exact, 11> table{{{15, {1, 2}, {1, 4}, 3},
                                            {18, {5, 8}, {1, 8}, 5},
                                            {22.5, {1, 2}, {1, 4}, 2},
                                            {30, {3, 4}, 0, 2},
                                            {36, {3, 8}, {1, 8}, 5},
                                            {45, {1, 2}, 0, 2},
                                            {54, {5, 8}, {-1, 8}, 5},
                                            {60, {1, 4}, 0, 2},
                                            {67.5, {1, 2}, {-1, 4}, 2},
                                            {72, {3, 8}, {-1, 8}, 5},
                                            {75, {1, 2}, {-1, 4}, 3}}};
  for (const Exact& known : table) {
    if (known.theta == theta_deg) return simplified(known.a, known.b, known.D);
  }
  return cos_squared_pi((Real::of(theta_deg) / Real(180)).ball());
}

Real squared_speed_ratio(double c, double theta_deg) {
  if (c == 0 || c == 1) return Real(static_cast<int>(c));
  // c^(p/q) of a double in (0, 1) is a rational, or the root of one, where its q-th or (q/2)-th root is
  // rational. A double's exponent is below 1100, and so is each q that can divide it.
  const Real exponent = Real::of(theta_deg) / Real(90);
  if (exponent.rational() != nullptr && denominator(*exponent.rational()) < 2200) {
    const auto p = static_cast<unsigned>(numerator(*exponent.rational()));
    const auto q = static_cast<unsigned>(denominator(*exponent.rational()));
    if (const auto root = double_root(c, q)) return whole_power(*root, p);
    if (q % 2 == 0) {
      if (const auto root = double_root(c, q / 2)) return sqrt(Real(whole_power(*root, p)));
    }
  }
  return pow(Real::of(c).ball(), exponent.ball());
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

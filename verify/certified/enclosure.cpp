#include "verify/certified/enclosure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace tps::certified {
namespace {

/// Proven by integers: the number lies between n and n + 1 units of the last place of a double there.
Enclosure enclosed_magnitude(const Rational& magnitude) {
  const Integer& n = numerator(magnitude);
  const Integer& d = denominator(magnitude);
  if (n == 0) return {0, 0, 0};
  // 2^(exponent − 1) < n/d < 2^(exponent + 1)
  const int exponent = static_cast<int>(msb(n)) - static_cast<int>(msb(d));
  const auto scaled = [&](int unit) {  // n/d in units of 2^unit, as a fraction
    const auto shift = static_cast<unsigned>(std::abs(unit));
    return unit > 0 ? std::pair<Integer, Integer>(n, d << shift) : std::pair<Integer, Integer>(n << shift, d);
  };
  constexpr int smallest_unit = -1074;
  int unit = std::max(exponent - 53, smallest_unit);
  if (unit > 972) {
    return {std::numeric_limits<double>::max(), HUGE_VAL, HUGE_VAL};
  }
  auto [over, under] = scaled(unit);
  Integer quotient = over / under;
  if (msb(quotient | 1) > 52) {
    std::tie(over, under) = scaled(++unit);
    quotient = over / under;
  }
  const Integer remainder = over - quotient * under;
  const auto units = static_cast<double>(static_cast<std::int64_t>(quotient));
  const auto bounded = [](double x) { return std::min(x, std::numeric_limits<double>::max()); };
  const double lo = bounded(std::ldexp(units, unit));
  if (remainder == 0 && std::isfinite(std::ldexp(units, unit))) return {lo, lo, lo};
  const double hi = std::ldexp(units + 1, unit);
  const int half = (remainder * 2).compare(under);
  const bool up = half > 0 || (half == 0 && quotient % 2 != 0) || std::isinf(std::ldexp(units, unit));
  return {lo, hi, up ? hi : lo};
}

Enclosure between_doubles(const Rational& x) {
  if (x >= 0) return enclosed_magnitude(x);
  const Enclosure magnitude = enclosed_magnitude(-x);
  return {-magnitude.hi, -magnitude.lo, -magnitude.nearest};
}

/// The double that everything in the interval rounds to. Where its ends round apart it holds zero, or the
/// midpoint of two doubles; a number that the working precision cannot tell from these is taken to be it.
double nearest(const Enclosure& lo, const Enclosure& hi) {
  if (lo.nearest == hi.nearest) return lo.nearest;
  if (lo.lo < 0 && hi.hi > 0) return 0;
  int exponent = 0;
  const double mantissa = std::ldexp(std::frexp(lo.nearest, &exponent), 53);
  return std::fmod(mantissa, 2) == 0 ? lo.nearest : hi.nearest;
}

}  // namespace

Enclosure enclosure(const Real& x) {
  if (x.rational() != nullptr) return between_doubles(*x.rational());
  const Ball::Ends ends = x.ball().ends();
  const Enclosure lo = between_doubles(ends.lo);
  const Enclosure hi = between_doubles(ends.hi);
  const bool settled = lo.nearest == hi.nearest;
  if (!settled) WorkingPrecision::doubt();
  return {lo.lo, hi.hi, nearest(lo, hi), settled};
}

EnclosedVector enclosure(const RealVector& x) {
  EnclosedVector result;
  for (const Real& component : x) result.push_back(enclosure(component));
  return result;
}

}  // namespace tps::certified

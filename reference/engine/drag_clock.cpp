#include "reference/engine/drag_clock.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <optional>

namespace tps {
namespace {

namespace mp = boost::multiprecision;
using Wide = mp::number<mp::cpp_bin_float<1100, mp::digit_base_2>, mp::et_off>;

const Dyadic kOne{1, 0};
/// e^{−2000} is less than a Wide tells from nothing beside 1.
constexpr int kEverything = 2000;

/// The power of two below |a|, REQUIRES a ≠ 0.
long magnitude(const Dyadic& a) {
  return static_cast<long>(msb(abs(a.digits))) + a.exponent;
}

Wide wide(const Dyadic& a) {
  return ldexp(Wide(a.digits), static_cast<int>(a.exponent));
}

/// The double nearest to every number strictly between two, if it is one; nothing where it is not.
std::optional<double> nearest_between(const Dyadic& least, const Dyadic& most) {
  const double down = rounded_quotient<double>(least, kOne, Rounding::down);
  const double up = next_number(down, Rounding::up);
  if (!std::isfinite(up)) return std::nullopt;
  const Dyadic half{1, -1};
  const Dyadic middle = (dyadic(down) + dyadic(up)) * half;
  if ((middle - most).sign() >= 0) return down;
  if ((least - middle).sign() >= 0 && (dyadic(up) - most).sign() >= 0) return up;
  return std::nullopt;
}

/// t = s (1 + z/2 + z²/3 + …), z = γs: for z < 2^−60 it lies between s (1 + z/2) and s (1 + z/2 + z²/2).
std::optional<double> by_series(const Dyadic& s, const Dyadic& z, double start) {
  const Dyadic half{1, -1};
  const Dyadic least = s * (kOne + z * half);
  const Dyadic most = least + s * z * z * half;
  return nearest_between(dyadic(start) + least, dyadic(start) + most);
}

/// For z ≤ 1/2 by −ln(1 − z), above by the logarithm of the exact 1 − z, each in long double: at most 8 of
/// its units 2^−64 off, which docs/effects.md counts. Decides all but one in 2^7 or so. Where long double has
/// another size the logarithm may be a double's (musl's of 113 bits is), so that it decides nothing.
std::optional<double> by_long_double(double gamma, const Dyadic& z, const Dyadic& rest) {
  if (std::numeric_limits<long double>::digits != 64) return std::nullopt;
  const long double log =
      magnitude(z) < -1 ? std::log1p(-nearest<long double>(z)) : std::log(nearest<long double>(rest));
  const long double t = -log / static_cast<long double>(gamma);
  const double least = static_cast<double>(t * (1 - 0x1p-60L));
  const double most = static_cast<double>(t * (1 + 0x1p-60L));
  if (least != most || !std::isnormal(least)) return std::nullopt;
  return least;
}

double by_wide_number(double gamma, const Dyadic& rest, double start) {
  return nearest<double>(dyadic(Wide(Wide(start) - log(wide(rest)) / Wide(gamma))));
}

}  // namespace

double drag_clock_until(double gamma, double T) {
  const Wide z = Wide(gamma) * Wide(T);
  if (z < ldexp(Wide(1), -60)) return std::nextafter(T, 0.0);  // T (1 − z/2) < s(T) < T
  const Wide power = z < kEverything ? Wide(exp(-z)) : Wide(0);
  const Dyadic s = dyadic(Wide((Wide(1) - power) / Wide(gamma)));
  const double below = rounded_quotient<double>(s, kOne, Rounding::down);
  return (s - dyadic(below)).sign() > 0 ? below : std::nextafter(below, 0.0);
}

double last_drag_time(double start) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  return start > 0 ? rounded_quotient<double>(dyadic(kLargest) - dyadic(start), kOne, Rounding::down)
                   : kLargest;
}

Dyadic drag_factor(double gamma, const Dyadic& s) {
  return kOne - dyadic(gamma) * s;
}

double drag_time(double gamma, const Dyadic& s, double start) {
  if (s.sign() == 0) return start;
  const Dyadic z = dyadic(gamma) * s;
  constexpr long kSeries = -60;
  std::optional<double> t;
  if (magnitude(z) < kSeries) t = by_series(s, z, start);
  if (t) return *t;
  const Dyadic rest = drag_factor(gamma, s);
  if (start == 0) t = by_long_double(gamma, z, rest);
  return t ? *t : by_wide_number(gamma, rest, start);
}

}  // namespace tps

#include "verify/exact/rounded_drag_time.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "verify/exact/drag_time.hpp"

namespace tps::exact {
namespace {

/// A double near t(s): γs is exact, its logarithm that of long double.
double near_drag_time(double gamma, const tps::Dyadic& z, double s) {
  if (msb(z.digits) + z.exponent < -60) return s;
  const auto rounded = [](const tps::Dyadic& a) {  // the leading digits
    const auto size = static_cast<long>(msb(a.digits));
    const long shift = std::max(0L, size - 63);
    const boost::multiprecision::cpp_int leading = a.digits >> static_cast<unsigned long>(shift);
    return std::ldexp(leading.convert_to<long double>(), static_cast<int>(a.exponent + shift));
  };
  const tps::Dyadic rest = tps::Dyadic{1, 0} - z;
  const long double part = rounded(z);
  return static_cast<double>(-(part < 0.5L ? std::log1p(-part) : std::log(rounded(rest))) /
                             static_cast<long double>(gamma));
}

}  // namespace

bool drag_clock_is_reached(double gamma, double s) {
  return (tps::Dyadic{1, 0} - tps::dyadic(gamma) * tps::dyadic(s)).sign() > 0;
}

DragTime rounded_drag_time(double gamma, double s) {
  const tps::Dyadic clock = tps::dyadic(s);
  if (s == 0) return {0};
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double t = near_drag_time(gamma, tps::dyadic(gamma) * clock, s);
  for (;;) {
    const double up = std::nextafter(t, kInfinity);
    const Sign above = std::isinf(t) ? Sign::negative : compare_drag_time(gamma, clock, middle_of(t, up));
    if (above == Sign::uncertain) return {t, false};
    if (above == Sign::positive) {
      t = up;
      continue;
    }
    const double down = std::nextafter(t, 0.0);
    const Sign below = compare_drag_time(gamma, clock, middle_of(down, t));
    if (below != Sign::negative) return {t, below != Sign::uncertain};
    t = down;
  }
}

}  // namespace tps::exact

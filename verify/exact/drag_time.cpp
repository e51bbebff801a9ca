#include "verify/exact/drag_time.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tps::exact {
namespace {

using boost::multiprecision::cpp_int;

/// Integers around 2^bits times a real number.
struct Bounds {
  cpp_int lo, hi;
};

/// 2^bits · artanh(n/d) for 0 ≤ n/d ≤ 1/3: Σ y^(2k+1)/(2k+1), every term rounded down in lo and up in hi.
/// What the series leaves out after the last term T is at most its ratio y²/(1 − y²) ≤ 1/8 of T.
Bounds artanh(const cpp_int& n, const cpp_int& d, unsigned bits) {
  const cpp_int scaled = n << bits;
  Bounds power{scaled / d, scaled / d + 1};
  const Bounds square{(power.lo * power.lo) >> bits, ((power.hi * power.hi) >> bits) + 1};
  Bounds sum{0, 0};
  for (unsigned k = 1;; k += 2) {
    const cpp_int last = power.hi / k + 1;
    sum.lo += power.lo / k;
    sum.hi += last;
    power = {(power.lo * square.lo) >> bits, ((power.hi * square.hi) >> bits) + 1};
    if (power.hi <= 2) return {sum.lo, sum.hi + last / 8 + 1};
  }
}

/// 2^bits · (−ln x), 0 < x ≤ 1: x = 2^e m with m in [1/2, 1], −ln m = 2 artanh((1 − m)/(1 + m)), and
/// ln 2 = 2 artanh(1/3).
Bounds minus_ln(const Dyadic& x, unsigned bits) {
  const auto size = static_cast<unsigned>(msb(x.digits)) + 1;
  const cpp_int one = cpp_int(1) << size;
  const Bounds of_m = artanh(one - x.digits, one + x.digits, bits);
  const cpp_int halvings = -(x.exponent + static_cast<long>(size));
  const Bounds of_2 = artanh(1, 3, bits);
  return {2 * (of_m.lo + halvings * of_2.lo), 2 * (of_m.hi + halvings * of_2.hi)};
}

/// Bits behind the point from which a number has its leading ones.
long leading_zeros(const Dyadic& a) {
  return std::max(0L, -(static_cast<long>(msb(abs(a.digits))) + a.exponent));
}

}  // namespace

Sign compare_drag_time(double gamma, const Dyadic& s, const Dyadic& t) {
  if (s.sign() == 0) return t.sign() == 0 ? Sign::zero : t.sign() < 0 ? Sign::positive : Sign::negative;
  if (t.sign() <= 0) return Sign::positive;
  const Dyadic z = dyadic(gamma) * s;
  const Dyadic rest = Dyadic{1, 0} - z;
  const Dyadic g = dyadic(gamma) * t;  // against −ln(1 − z)
  // x = 1 is 2^1 · 1/2 in minus_ln, whose halvings would be −1: z > 0 keeps it below.
  constexpr long kFirst = 256, kMost = 1L << 13;
  for (long more = kFirst; more <= kMost; more *= 2) {
    const auto bits = static_cast<unsigned>(leading_zeros(z) + more);
    const Bounds ln = minus_ln(rest, bits);
    const long shift = static_cast<long>(bits) + g.exponent;
    const cpp_int down = shift >= 0 ? cpp_int(g.digits << static_cast<unsigned long>(shift))
                                    : cpp_int(g.digits >> static_cast<unsigned long>(-shift));
    if (ln.lo > down) return Sign::positive;   // down + 1 > 2^bits g, lo ≥ down + 1
    if (ln.hi <= down) return Sign::negative;  // never equal
  }
  return Sign::uncertain;
}

bool is_nearest_drag_time(double gamma, const Dyadic& s, double start, double rounded) {
  if (!std::isfinite(rounded)) return false;
  if (s.sign() == 0) return rounded == start;
  const auto middle = [&](double other) { return middle_of(rounded, other) - dyadic(start); };
  const double inf = std::numeric_limits<double>::infinity();
  return compare_drag_time(gamma, s, middle(std::nextafter(rounded, -inf))) != Sign::negative &&
         compare_drag_time(gamma, s, middle(std::nextafter(rounded, inf))) != Sign::positive;
}

Dyadic middle_of(double x, double y) {
  const auto exactly = [](double a) { return std::isinf(a) ? Dyadic{a < 0 ? -1 : 1, 1024} : dyadic(a); };
  return (exactly(x) + exactly(y)) * Dyadic{1, -1};
}

}  // namespace tps::exact

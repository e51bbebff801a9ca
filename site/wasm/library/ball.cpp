// Enclosures of real numbers where there is no Arb: intervals whose ends are integers times powers of two.
// The same class and law as verify/certified/ball.cpp; site/test/bits.test.mjs asks both all committed
// questions.
#include "verify/certified/ball.hpp"

#include <algorithm>
#include <cstdlib>

namespace tps::certified {
namespace {

/// m 2^e.
struct Dyadic {
  Integer m = 0;
  long e = 0;
};

struct Interval {
  Dyadic lo, hi;
};

/// Of intermediate results.
long precision() {
  return WorkingPrecision::bits() + 64;
}

long length(const Integer& x) {
  return x == 0 ? 0 : static_cast<long>(msb(abs(x))) + 1;
}

/// The magnitude `whole` of a number with that sign, one unit more where something is left and the direction
/// is away from zero.
Integer directed(Integer whole, bool is_rest, bool negative, bool up) {
  if (is_rest && negative != up) ++whole;
  return negative ? Integer(-whole) : whole;
}

Dyadic rounded(const Dyadic& x, bool up) {
  const long excess = length(x.m) - precision();
  if (excess <= 0) return x;
  const auto shift = static_cast<unsigned>(excess);
  const Integer magnitude = abs(x.m), whole = magnitude >> shift;
  return {directed(whole, (whole << shift) != magnitude, x.m < 0, up), x.e + excess};
}

Dyadic sum(const Dyadic& x, const Dyadic& y) {
  if (x.m == 0) return y;
  if (y.m == 0) return x;
  const long e = std::min(x.e, y.e);
  return {(x.m << static_cast<unsigned>(x.e - e)) + (y.m << static_cast<unsigned>(y.e - e)), e};
}

Dyadic product(const Dyadic& x, const Dyadic& y) {
  return {x.m * y.m, x.e + y.e};
}

/// REQUIRES y ≠ 0.
Dyadic quotient(const Dyadic& x, const Dyadic& y, bool up) {
  const long shift = std::max(0L, precision() + length(y.m) - length(x.m) + 2);
  const Integer dividend = abs(x.m) << static_cast<unsigned>(shift), divisor = abs(y.m);
  const Integer whole = dividend / divisor;
  return {directed(whole, whole * divisor != dividend, (x.m < 0) != (y.m < 0), up), x.e - y.e - shift};
}

/// REQUIRES x ≥ 0.
Dyadic root(const Dyadic& x, bool up) {
  long shift = std::max(0L, 2 * precision() - length(x.m) + 2);
  if ((x.e - shift) % 2 != 0) ++shift;
  const Integer scaled = x.m << static_cast<unsigned>(shift);
  const Integer whole = boost::multiprecision::sqrt(scaled);
  return {directed(whole, whole * whole != scaled, false, up), (x.e - shift) / 2};
}

bool less(const Dyadic& x, const Dyadic& y) {
  return sum(x, {-y.m, y.e}).m < 0;
}

Interval hull(const Dyadic& lo, const Dyadic& hi) {
  return {rounded(lo, false), rounded(hi, true)};
}

Interval point(const Integer& m, long e = 0) {
  return {{m, e}, {m, e}};
}

Interval operator+(const Interval& x, const Interval& y) {
  return hull(sum(x.lo, y.lo), sum(x.hi, y.hi));
}

Interval operator-(const Interval& x) {
  return {{-x.hi.m, x.hi.e}, {-x.lo.m, x.lo.e}};
}

/// The least and the greatest of four.
template <typename Combine>
Interval of_ends(const Interval& x, const Interval& y, const Combine& combine) {
  const Dyadic* const xs[] = {&x.lo, &x.hi};
  const Dyadic* const ys[] = {&y.lo, &y.hi};
  Interval result{combine(x.lo, y.lo, false), combine(x.lo, y.lo, true)};
  for (const Dyadic* a : xs) {
    for (const Dyadic* b : ys) {
      result.lo = std::min(result.lo, combine(*a, *b, false), less);
      result.hi = std::max(result.hi, combine(*a, *b, true), less);
    }
  }
  return hull(result.lo, result.hi);
}

Interval operator*(const Interval& x, const Interval& y) {
  return of_ends(x, y, [](const Dyadic& a, const Dyadic& b, bool) { return product(a, b); });
}

/// REQUIRES that y does not hold zero.
Interval operator/(const Interval& x, const Interval& y) {
  return of_ends(x, y, quotient);
}

Interval over(const Interval& x, long whole) {
  return x / point(whole);
}

Dyadic magnitude(const Interval& x) {
  return std::max({abs(x.lo.m), x.lo.e}, Dyadic{abs(x.hi.m), x.hi.e}, less);
}

bool vanishes(const Interval& x) {
  return less(magnitude(x), {1, -precision()});
}

/// x ± 2 |rest|.
Interval widened(const Interval& x, const Interval& rest) {
  const Dyadic error = product(magnitude(rest), {1, 1});
  return x + Interval{{-error.m, error.e}, error};
}

/// Σ z^(2k+1)/(2k+1), the terms with alternating signs for arctan. REQUIRES |z| ≤ 1/3: what is left out is
/// less than 9/8 of the first term that is.
Interval odd_series(const Interval& z, bool alternates) {
  const Interval square = alternates ? -(z * z) : z * z;
  Interval power = z, total = point(0);
  for (long k = 0; !vanishes(power); ++k) {
    total = total + over(power, 2 * k + 1);
    power = power * square;
  }
  return widened(total, power);
}

/// Machin: π = 16 arctan(1/5) − 4 arctan(1/239).
Interval pi() {
  return point(16) * odd_series(over(point(1), 5), true) +
         -(point(4) * odd_series(over(point(1), 239), true));
}

/// REQUIRES 0 ≤ y ≤ 2: the terms fall from the second on, so that the rest is less than its first.
Interval cosine(const Interval& y) {
  const Interval square = -(y * y);
  Interval term = point(1), total = point(0);
  for (long k = 0; !vanishes(term) || k < 2; ++k) {
    total = total + term;
    term = over(term * square, (2 * k + 1) * (2 * k + 2));
  }
  return widened(total, term);
}

/// By halving until |y| < 1/16, where the rest is less than 2 of its first term, and squaring.
Interval exponential(Interval y) {
  const Dyadic size = magnitude(y);
  const long halvings = std::max(0L, length(size.m) + size.e + 4);
  y = y * point(1, -halvings);
  Interval term = point(1), total = point(0);
  for (long k = 1; !vanishes(term); ++k) {
    total = total + term;
    term = over(term * y, k);
  }
  total = widened(total, term);
  for (long k = 0; k < halvings; ++k) total = total * total;
  return total;
}

/// log(f 2^n) = 2 artanh((f − 1)/(f + 1)) + n log 2 with f in [1/2, 1). REQUIRES x > 0.
Interval logarithm(const Dyadic& x) {
  const long n = length(x.m) + x.e;
  const Interval f = point(x.m, x.e - n), one = point(1);
  const Interval of_f = odd_series((f + -one) / (f + one), false);
  const Interval of_two = odd_series(over(one, 3), false);
  return point(2) * (of_f + point(n) * of_two);
}

}  // namespace

/// The name is the class's own; here it is no Arb.
struct Ball::Arb {
  Interval x;
  bool is_known = true;  ///< false: a division by what may be zero
};

Ball::Ball() : arb_(std::make_shared<Arb>()) {}

Ball::Ball(const Rational& x) : Ball() {
  const Interval n = point(numerator(x)), d = point(denominator(x));
  arb_->x = n / d;
}

Ball::Ends Ball::ends() const {
  if (!arb_->is_known) {
    WorkingPrecision::doubt();
    const Rational beyond_doubles(Integer(1) << 1100U);
    return {-beyond_doubles, beyond_doubles};
  }
  const auto end = [](const Dyadic& x) {
    const Integer power = Integer(1) << static_cast<unsigned>(std::abs(x.e));
    return x.e >= 0 ? Rational(x.m * power) : Rational(x.m, power);
  };
  return {end(arb_->x.lo), end(arb_->x.hi)};
}

Sign Ball::sign() const {
  if (arb_->is_known && arb_->x.lo.m > 0) return Sign::positive;
  if (arb_->is_known && arb_->x.hi.m < 0) return Sign::negative;
  WorkingPrecision::doubt();
  return Sign::uncertain;
}

Ball operator+(const Ball& x, const Ball& y) {
  Ball result;
  *result.arb_ = {x.arb_->x + y.arb_->x, x.arb_->is_known && y.arb_->is_known};
  return result;
}

Ball operator*(const Ball& x, const Ball& y) {
  Ball result;
  *result.arb_ = {x.arb_->x * y.arb_->x, x.arb_->is_known && y.arb_->is_known};
  return result;
}

Ball operator/(const Ball& x, const Ball& y) {
  Ball result;
  const Interval& divisor = y.arb_->x;
  result.arb_->is_known = x.arb_->is_known && y.arb_->is_known && (divisor.lo.m > 0 || divisor.hi.m < 0);
  if (result.arb_->is_known) result.arb_->x = x.arb_->x / divisor;
  return result;
}

Ball sqrt(const Ball& x) {
  Ball result;
  const Dyadic zero;
  *result.arb_ = {
      hull(root(std::max(x.arb_->x.lo, zero, less), false), root(std::max(x.arb_->x.hi, zero, less), true)),
      x.arb_->is_known};
  return result;
}

Ball cos_squared_pi(const Ball& x) {
  Ball result;
  const Interval c = cosine(pi() * x.arb_->x);
  *result.arb_ = {c * c, x.arb_->is_known};
  return result;
}

Ball pow(const Ball& x, const Ball& y) {
  Ball result;
  const Interval log{logarithm(x.arb_->x.lo).lo, logarithm(x.arb_->x.hi).hi};
  *result.arb_ = {exponential(y.arb_->x * log), x.arb_->is_known && y.arb_->is_known};
  return result;
}

}  // namespace tps::certified

// Real numbers that are exact while they are rational, and enclosed at 150 digits from then on. Heavy header:
// only sources of this folder include it.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <variant>
#include <vector>

#include "verify/exact/verdict.hpp"

namespace tps::certified {

using exact::Sign;

// Without expression templates: `auto` and `?:` then mean what they say.
using Integer =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;
using Rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;
using Wide =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<150>, boost::multiprecision::et_off>;

/// lo ≤ x ≤ hi. Every operation moves both ends outward by 2^-400 of their size, which is 2^98 units in the
/// last place: more than any rounding of the library's, and still 120 digits.
struct Interval {
  Wide lo, hi;
};

/// A rational number, exactly, or an interval around a real one.
///
/// A rational of more than 2^14 bits becomes an interval, so that no input costs more than a moment.
/// Law: the true value of an expression lies in the result.
class Real {
 public:
  Real() : value_(Rational(0)) {}
  Real(int x) : value_(Rational(x)) {}
  Real(Rational x);
  Real(Interval x) : value_(std::move(x)) {}

  /// The double, exactly. REQUIRES finite.
  static Real of(double x);

  const Rational* rational() const { return std::get_if<Rational>(&value_); }
  Interval interval() const;

 private:
  std::variant<Rational, Interval> value_;
};

Real operator+(const Real& x, const Real& y);
Real operator-(const Real& x, const Real& y);
Real operator*(const Real& x, const Real& y);
/// REQUIRES sign(y) certain and not zero.
Real operator/(const Real& x, const Real& y);
/// Exact for squares of rationals. REQUIRES x ≥ 0 (an interval may reach below).
Real sqrt(const Real& x);

/// Uncertain where an interval holds zero.
Sign sign(const Real& x);

/// cos²θ of an angle in degrees, 0 < θ < 90. Exact at 30°, 45° and 60°, the only rational degrees where it is
/// rational (Niven's theorem).
Real cos_squared_degrees(double theta_deg);

/// c^(θ/90°) for c in [0, 1] and 0 < θ < 90: the square of the paper's speed ratio. Exact where c is 0 or 1,
/// or θ = 45 and c a rational square.
Real squared_speed_ratio(double c, double theta_deg);

using RealVector = std::vector<Real>;

RealVector lifted(const std::vector<double>& x);
RealVector operator+(const RealVector& x, const RealVector& y);
RealVector operator-(const RealVector& x, const RealVector& y);
RealVector operator*(const Real& factor, const RealVector& x);
Real dot(const RealVector& x, const RealVector& y);

}  // namespace tps::certified

// Real numbers that are exact while they are rational or have one square root, and balls of Arb from then on.
// Heavy header: only sources of this folder include it.
#pragma once

#include <utility>
#include <variant>
#include <vector>

#include "verify/certified/ball.hpp"
#include "verify/certified/numbers.hpp"
#include "verify/certified/surd.hpp"

namespace tps::certified {

/// A rational number or a + b√D, exactly, or a ball around a real one.
///
/// Fractions of more than 2^14 bits become balls, so that no input costs more than a moment.
/// Law: the true value of an expression lies in the result.
class Real {
 public:
  Real() : value_(Rational(0)) {}
  Real(int x) : value_(Rational(x)) {}
  Real(Rational x);
  Real(Surd x);
  Real(SurdOrRational x);
  Real(Ball x) : value_(std::move(x)) {}

  /// The double, exactly. REQUIRES finite.
  static Real of(double x);

  const Rational* rational() const { return std::get_if<Rational>(&value_); }
  const Surd* surd() const { return std::get_if<Surd>(&value_); }
  /// At the working precision.
  Ball ball() const;

 private:
  std::variant<Rational, Surd, Ball> value_;
};

Real operator+(const Real& x, const Real& y);
Real operator-(const Real& x, const Real& y);
Real operator*(const Real& x, const Real& y);
/// REQUIRES sign(y) certain and not zero.
Real operator/(const Real& x, const Real& y);
/// Exact where the root is rational or has one square root itself. REQUIRES x ≥ 0 (a ball may reach below).
Real sqrt(const Real& x);

/// Uncertain, which is a doubt of the working precision, where a ball holds zero.
Sign sign(const Real& x);

/// cos²θ of an angle in degrees, 0 < θ < 90. Exact where cos 2θ is rational (30°, 45°, 60°; Niven's theorem)
/// or has one square root (15°, 18°, 22.5°, 36° and their complements).
Real cos_squared_degrees(double theta_deg);

/// c^(θ/90°) for c in [0, 1] and 0 < θ < 90: the square of the paper's speed ratio. Exact where it is
/// rational or the square root of a rational.
Real squared_speed_ratio(double c, double theta_deg);

using RealVector = std::vector<Real>;

RealVector lifted(const std::vector<double>& x);
RealVector operator+(const RealVector& x, const RealVector& y);
RealVector operator-(const RealVector& x, const RealVector& y);
RealVector operator*(const Real& factor, const RealVector& x);
Real dot(const RealVector& x, const RealVector& y);

}  // namespace tps::certified

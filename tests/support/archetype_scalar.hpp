// The least that a scalar must offer to the equations: a double in a wrapper that converts from and to
// nothing by itself. A hidden `double` in an equation does not compile with it.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <ostream>

namespace archetype {

class Scalar {
 public:
  Scalar() = default;
  explicit Scalar(int value) : value_(value) {}
  explicit Scalar(double value) : value_(value) {}
  explicit Scalar(const char* digits) : value_(std::strtod(digits, nullptr)) {}  // constants such as π

  friend Scalar operator+(Scalar x, Scalar y) { return Scalar(x.value_ + y.value_); }
  friend Scalar operator-(Scalar x, Scalar y) { return Scalar(x.value_ - y.value_); }
  friend Scalar operator*(Scalar x, Scalar y) { return Scalar(x.value_ * y.value_); }
  friend Scalar operator/(Scalar x, Scalar y) { return Scalar(x.value_ / y.value_); }
  friend Scalar operator-(Scalar x) { return Scalar(-x.value_); }
  Scalar& operator+=(Scalar y) { return *this = *this + y; }  // Eigen's sums
  Scalar& operator-=(Scalar y) { return *this = *this - y; }
  Scalar& operator*=(Scalar y) { return *this = *this * y; }
  Scalar& operator/=(Scalar y) { return *this = *this / y; }

  friend bool operator==(Scalar x, Scalar y) { return x.value_ == y.value_; }
  friend bool operator!=(Scalar x, Scalar y) { return x.value_ != y.value_; }
  friend bool operator<(Scalar x, Scalar y) { return x.value_ < y.value_; }
  friend bool operator<=(Scalar x, Scalar y) { return x.value_ <= y.value_; }
  friend bool operator>(Scalar x, Scalar y) { return x.value_ > y.value_; }
  friend bool operator>=(Scalar x, Scalar y) { return x.value_ >= y.value_; }

  friend Scalar sqrt(Scalar x) { return Scalar(std::sqrt(x.value_)); }
  friend Scalar abs(Scalar x) { return Scalar(std::abs(x.value_)); }
  friend Scalar frexp(Scalar x, int* exponent) { return Scalar(std::frexp(x.value_, exponent)); }
  friend Scalar ldexp(Scalar x, int exponent) { return Scalar(std::ldexp(x.value_, exponent)); }
  friend Scalar tan(Scalar x) { return Scalar(std::tan(x.value_)); }
  friend Scalar log1p(Scalar x) { return Scalar(std::log1p(x.value_)); }
  friend Scalar pow(Scalar x, Scalar y) { return Scalar(std::pow(x.value_, y.value_)); }

  friend std::ostream& operator<<(std::ostream& out, Scalar x) { return out << x.value_; }  // test messages

 private:
  double value_ = 0;
};

}  // namespace archetype

template <>
class std::numeric_limits<archetype::Scalar> {
 public:
  static constexpr bool is_specialized = true;
  static constexpr bool is_integer = false;
  static constexpr bool is_signed = true;
  static constexpr bool has_infinity = true;
  static constexpr int digits = std::numeric_limits<double>::digits;
  static constexpr int digits10 = std::numeric_limits<double>::digits10;
  static constexpr int min_exponent = std::numeric_limits<double>::min_exponent;
  static constexpr int max_exponent = std::numeric_limits<double>::max_exponent;
  static archetype::Scalar epsilon() { return archetype::Scalar(std::numeric_limits<double>::epsilon()); }
  static archetype::Scalar infinity() { return archetype::Scalar(std::numeric_limits<double>::infinity()); }
  static archetype::Scalar min() { return archetype::Scalar((std::numeric_limits<double>::min)()); }
  static archetype::Scalar max() { return archetype::Scalar((std::numeric_limits<double>::max)()); }
};

template <>
struct Eigen::NumTraits<archetype::Scalar> : Eigen::GenericNumTraits<archetype::Scalar> {
  using Real = archetype::Scalar;
  using NonInteger = archetype::Scalar;
  using Literal = archetype::Scalar;
  using Nested = archetype::Scalar;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
};

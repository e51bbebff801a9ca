// The numbers of a trace and the wider ones that judge them.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "reference/equations/square_root.hpp"

namespace tps::check {

/// What a stored number is judged in: float and double in long double, whose roundings are 2^-11 of a
/// double's (docs/check.md, "Bounds"); wider scalars in one type that is wider than all of them.
template <typename Number>
struct WorkOf {
  using type = Number;
};
template <>
struct WorkOf<double> {
  using type = long double;
};
template <typename Number>
using Work = typename WorkOf<Number>::type;

constexpr double kRightAngle = 1.5707963267948966;

/// A position, velocity or impulse; planar ones have z = 0.
template <typename T>
struct Vec {
  std::array<T, 3> x{T(0), T(0), T(0)};

  T& operator[](std::size_t k) { return x[k]; }
  const T& operator[](std::size_t k) const { return x[k]; }
  bool operator==(const Vec&) const = default;
};

template <typename T, typename U>
Vec<T> widened(const Vec<U>& a) {
  return {{T(a[0]), T(a[1]), T(a[2])}};
}
template <typename T>
Vec<T> operator+(const Vec<T>& a, const Vec<T>& b) {
  return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
}
template <typename T>
Vec<T> operator-(const Vec<T>& a, const Vec<T>& b) {
  return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
}
template <typename T>
Vec<T> operator*(const T& s, const Vec<T>& a) {
  return {{s * a[0], s * a[1], s * a[2]}};
}
template <typename T>
T dot(const Vec<T>& a, const Vec<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <typename T>
T length(const Vec<T>& a) {
  return square_root(dot(a, a));
}
template <typename T>
Vec<T> cross(const Vec<T>& a, const Vec<T>& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}
template <typename T>
T largest(const Vec<T>& a) {
  using std::abs;
  T result(0);
  for (const T& component : a.x) {
    if (abs(component) > result) result = abs(component);
  }
  return result;
}

/// Time since the start of the run as a sum hi + lo with hi the nearest number to it.
template <typename Number>
struct Instant {
  Number hi = Number(0);
  Number lo = Number(0);

  friend bool operator==(const Instant& a, const Instant& b) { return a.hi == b.hi && a.lo == b.lo; }
  friend bool operator<(const Instant& a, const Instant& b) {
    return a.hi < b.hi || (a.hi == b.hi && a.lo < b.lo);
  }
};

/// later − earlier, to the working precision.
template <typename Number>
Work<Number> elapsed(const Instant<Number>& earlier, const Instant<Number>& later) {
  using W = Work<Number>;
  return (W(later.hi) - W(earlier.hi)) + (W(later.lo) - W(earlier.lo));
}

/// How the scalar of a trace rounds.
template <typename Number>
struct Precision {
  Work<Number> u;         ///< largest relative error of one operation
  Work<Number> smallest;  ///< what an underflow can lose
  int digits = 53;        ///< bits of the scalar
  bool is_float = false;  ///< stored in double, computed in float
};

/// A time as a run of floats has it, hi the nearest float. The sum of two floats may take more bits than a
/// double has; where the first of them is in the middle between two floats, the rest decides.
inline Instant<float> in_floats(const Instant<double>& t) {
  const auto nearest = static_cast<float>(t.hi);
  const auto rest_of = [&](float hi) { return (t.hi - static_cast<double>(hi)) + t.lo; };
  float hi = nearest;
  for (const float towards : {-HUGE_VALF, HUGE_VALF}) {
    const float other = std::nextafter(nearest, towards);
    if (std::fabs(rest_of(other)) < std::fabs(rest_of(hi))) hi = other;
  }
  return {hi, static_cast<float>(rest_of(hi))};
}

/// A time rounded to the scalar, to even where it is in the middle: what a clock of one number would show.
template <typename Number>
Number reading(const Instant<Number>& t, const Precision<Number>& precision) {
  using std::floor;
  using std::frexp;
  using std::ldexp;
  if constexpr (std::is_same_v<Number, double>) {
    return precision.is_float ? static_cast<double>(in_floats(t).hi) : t.hi;
  } else {
    int exponent = 0;
    const Number scaled = ldexp(Number(frexp(t.hi, &exponent)), precision.digits);
    Number whole = floor(scaled);
    const Number rest = scaled - whole;
    const bool is_odd = Number(floor(whole / 2)) * 2 != whole;
    if (rest > Number(0.5) || (rest == Number(0.5) && is_odd)) whole += 1;
    return ldexp(whole, exponent - precision.digits);
  }
}

}  // namespace tps::check

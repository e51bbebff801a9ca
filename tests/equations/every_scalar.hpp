// Runs a test suite in every scalar type. The sources of this folder are compiled twice: as they are with the
// built-in types and the archetype, and as one translation unit with the wide types (TPS_WIDE_SCALARS).
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

#include "reference/equations/vector.hpp"
#ifdef TPS_WIDE_SCALARS
#include "reference/scalars.hpp"
#else
#include "tests/support/archetype_scalar.hpp"
#endif

namespace tps::test {

#ifdef TPS_WIDE_SCALARS
using EveryScalar = testing::Types<Quad, Mp50>;
#else
using EveryScalar = testing::Types<float, double, long double, archetype::Scalar>;
#endif

struct ScalarName {
  template <typename Scalar>
  static std::string GetName(int) {
    if constexpr (std::is_same_v<Scalar, float>) return "float";
    if constexpr (std::is_same_v<Scalar, double>) return "double";
    if constexpr (std::is_same_v<Scalar, long double>) return "long_double";
    if constexpr (!std::is_floating_point_v<Scalar>) {
      return std::is_class_v<Scalar> && std::numeric_limits<Scalar>::digits == 53
                 ? "archetype"
                 : "bits" + std::to_string(std::numeric_limits<Scalar>::digits);
    }
  }
};

template <typename Scalar>
Vector<Scalar, 2> vec(double x, double y) {
  return Vector<Scalar, 2>(Scalar(x), Scalar(y));
}

template <typename Scalar>
Vector<Scalar, 3> vec(double x, double y, double z) {
  return Vector<Scalar, 3>(Scalar(x), Scalar(y), Scalar(z));
}

template <typename Scalar>
Scalar infinity() {
  return std::numeric_limits<Scalar>::infinity();
}

/// Unit roundoff u.
template <typename Scalar>
Scalar roundoff() {
  return std::numeric_limits<Scalar>::epsilon() / Scalar(2);
}

/// Whether |actual − expected| ≤ units · u · scale.
template <typename Scalar>
testing::AssertionResult near_by(const Scalar& actual, const std::type_identity_t<Scalar>& expected,
                                 int units, const std::type_identity_t<Scalar>& scale) {
  using std::abs;
  if (abs(Scalar(actual - expected)) <= Scalar(units) * roundoff<Scalar>() * scale) {
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << actual << " is not within " << units << " roundoffs of " << expected;
}

template <typename Scalar, int D>
testing::AssertionResult near_by(const Vector<Scalar, D>& actual, const Vector<Scalar, D>& expected,
                                 int units, const std::type_identity_t<Scalar>& scale) {
  for (int k = 0; k < D; ++k) {
    const testing::AssertionResult one = near_by<Scalar>(actual[k], expected[k], units, scale);
    if (!one) return testing::AssertionFailure() << "component " << k << ": " << one.message();
  }
  return testing::AssertionSuccess();
}

}  // namespace tps::test

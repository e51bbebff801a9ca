// What error bounds take for granted of a build: compiled as the library is, not as the tests are.
#include <gtest/gtest.h>

#include <array>

namespace {

struct Pair {
  double first, second;
};

/// Read at run time, so that no result is known to the compiler.
double given(double x) {
  volatile double hidden = x;
  return hidden;
}

[[gnu::noinline]] Pair as_floats(const Pair& x) {
  return {static_cast<float>(x.first), static_cast<float>(x.second)};
}

[[gnu::noinline]] void round_to_floats(std::array<double, 3>& x) {
  for (double& each : x) each = static_cast<float>(each);
}

[[gnu::noinline]] double cross(double a, double b, double c, double d) {
  return a * b - c * d;
}

double nearest_float(double x) {
  volatile float rounded = static_cast<float>(x);
  return static_cast<double>(rounded);
}

// g++ 12 left the rounding out where two stand side by side (docs/decisions.md, N77).
TEST(Compiler, RoundsNeighboursToFloat) {
  const Pair pair = as_floats({given(.1), given(.3)});
  EXPECT_EQ(pair.first, nearest_float(.1));
  EXPECT_EQ(pair.second, nearest_float(.3));
  std::array<double, 3> list{given(.1), given(.2), given(.3)};
  round_to_floats(list);
  EXPECT_EQ(list, (std::array{nearest_float(.1), nearest_float(.2), nearest_float(.3)}));
}

TEST(Compiler, ContractsNoProducts) {
  EXPECT_EQ(cross(given(.1), given(.3), given(.3), given(.1)), 0);
}

TEST(Compiler, KeepsSubnormals) {
  EXPECT_GT(given(0x1p-1022) / 4, 0);
}

}  // namespace

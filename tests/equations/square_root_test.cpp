// The square root of the scalars of the hardware, which is that of the library.
#include "reference/equations/square_root.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using tps::square_root;

TEST(SquareRootOfHardware, IsThatOfTheLibrary) {
  EXPECT_EQ(square_root(2.0), std::sqrt(2.0));
  EXPECT_EQ(square_root(2.0F), std::sqrt(2.0F));
  EXPECT_EQ(square_root(2.0L), std::sqrt(2.0L));
}

}  // namespace

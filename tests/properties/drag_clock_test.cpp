#include "properties/laws/drag_clock.hpp"

#include <gtest/gtest.h>

namespace tps::properties {
namespace {

// The laws judge scalars of up to 100 digits: −ln(1 − z) has to be good to far less than their 2⁻³³², on both
// sides of the change from series to logarithm. 400 digits keep 1 − z exact.
TEST(DragClock, IsExactBesideEveryScalar) {
  using Wider =
      boost::multiprecision::number<boost::multiprecision::cpp_bin_float<400>, boost::multiprecision::et_off>;
  for (int power = 1; power <= 600; ++power) {
    for (const double significand : {1., 1.2, 1.75}) {
      const double z = std::ldexp(significand, -power);
      if (z >= 1) continue;
      const Wider exact = -log(Wider(1) - Wider(z));
      const Wider error = abs(Wider(minus_log(Wide(z))) - exact) / exact;
      EXPECT_LT(error, ldexp(Wider(1), -390)) << significand << " · 2^-" << power;
    }
  }
}

}  // namespace
}  // namespace tps::properties

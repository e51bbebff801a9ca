// Responses in each scalar against their enclosures.
#include "verify/cost/response_level.hpp"

#include <gtest/gtest.h>

namespace tps::cost {
namespace {

const ResponseLevel& few() {
  static const ResponseLevel level = [] {
    ResponseLevelOptions options;
    options.questions = 30;
    options.repetitions = 1;
    return measure_responses(options);
  }();
  return level;
}

/// Whether a stratum has impulses with components that are exactly zero, which a root loses at any precision.
bool has_exact_zeros(const std::string& stratum) {
  return stratum == "integers" || stratum == "perpendicular" || stratum == "boundary" ||
         stratum == "near_boundary";
}

TEST(Responses, InFiftyDigitsRoundToTheDoublesOfTheirEnclosures) {
  std::uint64_t asked = 0;
  for (const ResponseRow& row : few().rows) {
    if (row.scalar != "mp50" && row.scalar != "mp100") continue;
    EXPECT_EQ(row.lost, 0U) << row.op << " " << row.stratum << " " << row.scalar;
    if (!has_exact_zeros(row.stratum)) {
      EXPECT_EQ(row.off, 0U) << row.op << " " << row.stratum << " " << row.scalar;
    }
    // The double beside 0 is 2^-1074, and its difference from 2 is held by no scalar.
    if (row.stratum != "near_boundary") {
      EXPECT_EQ(row.other_kind, 0U) << row.op << " " << row.stratum << " " << row.scalar;
    }
    asked += row.asked;
  }
  EXPECT_GE(asked, 2U * 40 * 30);
}

/// The numbers of stratum float32 are exact in float, so both scalars are asked the same, and 29 bits of
/// precision are 29 bits of the answer; ± 3 for what the roundings of thirty questions come to.
TEST(Responses, InFloatAreOffByTheBitsThatItLacks) {
  const ResponseLevel& level = few();
  int compared = 0;
  for (const ResponseRow& in_float : level.rows) {
    if (in_float.scalar != "float" || in_float.stratum != "float32") continue;
    for (const ResponseRow& in_double : level.rows) {
      if (in_double.scalar != "double" || in_double.op != in_float.op || in_double.stratum != "float32")
        continue;
      EXPECT_NEAR(*in_float.log2_p99 - *in_double.log2_p99, 53 - 24, 3) << in_float.op;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 4);
}

}  // namespace
}  // namespace tps::cost

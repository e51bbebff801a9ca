// The generators hit what they aim at: floors on the cases of each hazard and of each exact verdict.
#include <gtest/gtest.h>

#include <map>

#include "properties/check_law.hpp"
#include "properties/classify.hpp"
#include "properties/generators/pairs.hpp"

namespace tps::properties {
namespace {

std::map<std::string, int> hits(const char* law_id, const Format& format, std::uint64_t cases) {
  std::map<std::string, int> counts;
  for (std::uint64_t number = 0; number < cases; ++number) {
    for (const std::string& hazard : hazards_of(generated_case(*find_law(law_id), format, 20260101, number)))
      ++counts[hazard];
  }
  return counts;
}

// Of 1,000 cases: 20 a verdict, edges that only exact numbers reach among them; 50 an aim.
TEST(Hazards, EveryVerdictAndEveryAimIsHit) {
  for (const int bits : {53, 24}) {
    std::map<std::string, int> counts = hits("Eq2Laws.Law1SwapOfNames", Format::of_bits(bits), 1000);
    for (const std::string& verdict : verdict_hazards())
      EXPECT_GE(counts[verdict], 20) << verdict << ", " << bits;
    for (const std::string& aim : pair_hazards()) EXPECT_GE(counts[aim], 50) << aim << ", " << bits;
  }
}

TEST(Hazards, MassesReachThirtyDecadesAndInfinity) {
  double smallest = 1, largest = 1;
  int infinite = 0, equal = 0;
  for (std::uint64_t number = 0; number < 1000; ++number) {
    const Masses m =
        generated_case(*find_law("Eq4Laws.Law5PowersOfTwo"), Format::of_bits(53), 20260101, number).masses();
    ASSERT_FALSE(std::isinf(m.A) && std::isinf(m.B));
    infinite += std::isinf(m.A) || std::isinf(m.B) ? 1 : 0;
    equal += m.A == m.B ? 1 : 0;
    for (const double each : {m.A, m.B}) {
      if (std::isinf(each)) continue;
      smallest = std::min(smallest, each);
      largest = std::max(largest, each);
    }
  }
  EXPECT_GE(infinite, 50);
  EXPECT_GE(equal, 100);
  EXPECT_GE(largest / smallest, 1e29);
}

TEST(Hazards, GroupsAndOrdersHaveTheirOwn) {
  std::map<std::string, int> groups = hits("GroupLaws.Law2MomentumIsConserved", Format::of_bits(53), 400);
  for (const char* hazard : {"chain", "wall", "pairs", "perpendicular"})
    EXPECT_GE(groups[hazard], 50) << hazard;
  std::map<std::string, int> orders = hits("OrderLaws.Law3Transitive", Format::of_bits(53), 300);
  for (const char* hazard : {"unrelated", "same_time", "one_bit"}) EXPECT_GE(orders[hazard], 50) << hazard;
}

}  // namespace
}  // namespace tps::properties

// Hard cases whose right outcome is known without a run in 100 digits.
#include "verify/cost/hard_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace tps::cost {
namespace {

CaseResult result_of(const std::string& name) {
  const std::vector<HardCase> all = hard_cases();
  return measure_case(
      *std::find_if(all.begin(), all.end(), [&](const HardCase& one) { return one.name == name; }));
}

const CaseOutcome& in(const CaseResult& result, const std::string& scalar, const std::string& timing) {
  return *std::find_if(result.outcomes.begin(), result.outcomes.end(), [&](const CaseOutcome& outcome) {
    return outcome.scalar == scalar && outcome.timing == timing;
  });
}

TEST(HardCases, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const HardCase& one : hard_cases()) EXPECT_TRUE(names.insert(one.name).second) << one.name;
  EXPECT_GE(names.size(), 15U);
}

/// k = 3, 5, …, 39 hit: 19 events. The printed discriminant at 1024 L loses those that pass within 2^-32.
TEST(HardCases, OfAGrazingTrainAreMissedByThePrintedFormulaAlone) {
  const CaseResult train = result_of("grazing-train");
  EXPECT_EQ(train.events, 19U);
  ASSERT_NE(train.good_enough(), nullptr);
  EXPECT_EQ(train.good_enough()->scalar, "double");
  EXPECT_EQ(train.good_enough()->timing, "stable");
  EXPECT_LT(in(train, "double", "paper").events, 19U);
  // A pass at L(1 - 2^-40) from 1024 L away: 40 bits of the miss and 10 of the way, and some to tell them
  // apart.
  EXPECT_EQ(train.proven_bits, 64);
}

/// A pair that should rest must not creep: what is beyond the limit after 2^40 is what landing on it left.
TEST(HardCases, OfPairsAtRestDoNotCreep) {
  const CaseResult rest = result_of("resting");
  EXPECT_EQ(rest.events, 20U) << "one contact each, and no second";
  EXPECT_EQ(rest.proven_bits, 113);
  for (const CaseOutcome& outcome : rest.outcomes) {
    EXPECT_FALSE(outcome.horizon) << outcome.scalar << " " << outcome.timing;
    // Two coordinates a component, each advanced with an error of an ulp, three components.
    EXPECT_LT(outcome.worst_excess, 8) << outcome.scalar << " " << outcome.timing;
  }
}

TEST(HardCases, OfTheEndsOfThetaRevolveInEveryScalar) {
  for (const char* name : {"theta-least", "theta-most"}) {
    const CaseResult circling = result_of(name);
    EXPECT_EQ(circling.events, 300U);
    EXPECT_EQ(circling.unproven, "start") << "the pair is taut from the beginning";
    for (const CaseOutcome& outcome : circling.outcomes) {
      EXPECT_FALSE(outcome.horizon) << name << " " << outcome.scalar << " " << outcome.timing;
    }
  }
}

}  // namespace
}  // namespace tps::cost

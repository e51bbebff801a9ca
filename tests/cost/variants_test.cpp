// Every variant answers; those that are certified are right everywhere, and the printed formula is wrong
// where docs/eq2.md says so.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "verify/cost/exact_answer.hpp"
#include "verify/cost/measure.hpp"
#include "verify/vectors/timing_strata.hpp"

namespace tps::cost {
namespace {

using exact::Kind;
using exact::strata::relative;

const Variant& variant_named(const std::string& name) {
  const auto& all = variants();
  return *std::find_if(all.begin(), all.end(), [&](const Variant& v) { return v.name == name; });
}

std::vector<Variant> only(const std::string& name) {
  return {variant_named(name)};
}

TEST(Variants, HaveNamesOfTheirOwnAndTheBaselineFirst) {
  std::set<std::string> names;
  for (const Variant& variant : variants()) EXPECT_TRUE(names.insert(variant.name).second) << variant.name;
  EXPECT_EQ(variants().front().name, kBaseline);
}

/// Times that every arithmetic holds: 6, 14 and 4; a miss; a contact.
TEST(Variants, AllAnswerEasyQuestions) {
  for (const Variant& variant : variants()) {
    const auto ask = [&](Kind kind, exact::Vec3 r, exact::Vec3 v, double L) {
      const TimingQuery query = relative(kind, r, v, L);
      const Answer answer = variant.answer(query);
      const ExactAnswer exact(query);
      EXPECT_EQ(answer.occurs, exact.occurs()) << variant.name;
      EXPECT_EQ(answer.at_once, exact.at_once()) << variant.name;
      if (!variant.has_time || !exact.occurs() || exact.at_once()) return;
      ASSERT_TRUE(answer.t) << variant.name;
      EXPECT_EQ(exact.log2_error(*answer.t), -1000) << variant.name << ": not exact";
    };
    ask(Kind::block, {-10, 3, 0}, {1, 0, 0}, 5);
    ask(Kind::tether, {-10, 3, 0}, {1, 0, 0}, 5);
    ask(Kind::tether, {2, 0, 0}, {-1, 0, 0}, 2);
    ask(Kind::block, {-10, 6, 0}, {1, 0, 0}, 5);
    ask(Kind::block, {-5, 0, 0}, {1, 0, 0}, 5);
    ask(Kind::block, {5, 0, 0}, {1, 0, 0}, 5);
  }
}

TEST(Variants, CertifiedOnesAreRightOnEveryStratum) {
  StudyOptions options;
  options.questions = 60;
  for (const Hazard& hazard : hazards()) {
    for (const char* name : {"certified-verdict", "certified-time", "rational-verdict", "integers"}) {
      const Cell cell = measure_accuracy(hazard, options, only(name)).cells.front();
      EXPECT_EQ(cell.verdicts.asked, 60U);
      EXPECT_EQ(cell.verdicts.all(), 0U) << name << " on " << hazard.name;
      if (cell.errors.compared > 0) {
        EXPECT_LE(cell.errors.max, -53) << name << " on " << hazard.name;
      }
    }
  }
}

/// r = (−1e4, 1 ∓ 2^-30): the printed discriminant is 0 for both (docs/eq2.md).
TEST(Variants, ThePrintedFormulaMissesAGrazeInDouble) {
  const TimingQuery hit = relative(Kind::block, {-1e4, 1 - 0x1p-30, 0}, {1, 0, 0}, 1);
  EXPECT_FALSE(variant_named("printed-double").answer(hit).occurs);
  EXPECT_TRUE(variant_named("printed-mp50").answer(hit).occurs);
  EXPECT_TRUE(variant_named("stable-double").answer(hit).occurs);
}

/// r = (1 + 2^-50, 0), v = (−.75, .4), L = 1: the printed root is off by 3.8 %, the other by 3e-16.
TEST(Variants, AreJudgedAsTheirPagesSay) {
  const TimingQuery query = relative(Kind::block, {1 + 0x1p-50, 0, 0}, {-0.75, 0.4, 0}, 1);
  const ExactAnswer exact(query);
  EXPECT_NEAR(std::exp2(exact.log2_error(*variant_named("printed-double").answer(query).t)), 0.038, 0.001);
  EXPECT_LT(std::exp2(exact.log2_error(*variant_named("stable-double").answer(query).t)), 4e-16);
}

/// r = (5, 2), v = (0, −2), L = 5 touches at t = 1. |r| = √29 is rounded, and with it c and D.
TEST(Variants, AnExactTangentIsLostToTheRootAtAnyPrecision) {
  const TimingQuery query = relative(Kind::block, {5, 2, 0}, {0, -2, 0}, 5);
  ASSERT_EQ(ExactAnswer(query).verdict(), exact::Verdict::tangent);
  EXPECT_TRUE(variant_named("stable-double").answer(query).occurs);
  EXPECT_TRUE(variant_named("stable-mp100").answer(query).occurs);
  EXPECT_FALSE(variant_named("printed-double").answer(query).occurs) << "whose integers are not rounded";
  EXPECT_FALSE(variant_named("certified-time").answer(query).occurs);
}

/// |v| = 1e155: |v|² is infinite, and b² − 4ac not a number.
TEST(Variants, SquaresOutOfRangeAreLostToThePrintedFormula) {
  const TimingQuery query = relative(Kind::block, {-5, 0, 0}, {1e155, 0, 0}, 1);
  EXPECT_FALSE(variant_named("printed-double").answer(query).t);
  const ExactAnswer exact(query);
  for (const char* name : {"scaled-double", "stable-double", "certified-time"}) {
    ASSERT_TRUE(variant_named(name).answer(query).t) << name;
    EXPECT_LE(exact.log2_error(*variant_named(name).answer(query).t), -51) << name;
  }
}

TEST(Variants, AreTimed) {
  StudyOptions options;
  options.questions = options.timed = 16;
  options.repetitions = 3;
  const std::vector<Variant> two = {variants().front(), variant_named("certified-time")};
  StratumResult result = measure_accuracy(hazards().front(), options, two);
  measure_times(result, options, two);
  for (const Cell& cell : result.cells) {
    ASSERT_TRUE(cell.times);
    EXPECT_GT(cell.times->throughput.min, 0);
    EXPECT_GT(cell.times->latency.min, 0);
    EXPECT_LE(cell.times->ratio_interval.low, cell.times->ratio_interval.high);
  }
  EXPECT_EQ(result.cells.front().times->ratio, 1);
  std::uint64_t questions = 0;
  for (const Path& path : result.cells.back().paths) questions += path.questions;
  EXPECT_EQ(questions, 16U);
}

}  // namespace
}  // namespace tps::cost

// Ceilings of the reference's formula on every stratum, in every scalar from 24 to 334 bits: where a verdict
// may be wrong, and how far from the limit a pair may be at the time told (docs/accuracy-cost.md, "The
// bound").
#include <gtest/gtest.h>

#include <cmath>

#include "tests/cost/stratum_questions.hpp"
#include "verify/cost/exact_answer.hpp"
#include "verify/cost/variant.hpp"
#include "verify/vectors/timing_strata.hpp"

namespace tps::cost {
namespace {

constexpr double kResidual = 80;          ///< units of u N
constexpr double kSumIsNoNoise = 0x1p14;  ///< units of u a M that (|h| + √D)² must have
constexpr int kPerStratum = 120;

/// The most that D is off, in units of a M: the discriminant has two forms, told apart by h² < a L².
double doubt_of_D(const Magnitudes& m, double u) {
  const bool by_moment = m.hh > m.LL * (1 + 0x1p-8);
  if (!by_moment) return 26 * u;
  const double moment = std::sqrt(m.ww * m.rr);  // |r × v| |r| |v|
  return u * (8 * m.LL + 4 * m.ww + 12 * moment) + 34 * u * u * m.rr;
}

/// Whether a coefficient that verdicts rest on is within its rounding.
bool is_in_doubt(const Magnitudes& m, double u) {
  return m.h <= 6 * u || m.c <= 7 * u || m.D <= doubt_of_D(m, u);
}

struct Seen {
  int wrong = 0, in_doubt = 0;  ///< verdicts
  int compared = 0;             ///< times of hits
  double worst = 0;             ///< residual, in units of u N
  std::string wrong_at, worst_at;
};

Seen seen(const std::vector<TimingQuery>& queries, const std::vector<ExactAnswer>& exact,
          const Variant& variant) {
  const double u = std::ldexp(1.0, -variant.bits);
  Seen result;
  for (std::size_t k = 0; k < queries.size(); ++k) {
    if (!exact[k].magnitudes()) continue;  // without motion nothing is rounded
    const Magnitudes& m = *exact[k].magnitudes();
    const Answer answer = variant.answer(queries[k]);
    const bool in_doubt = is_in_doubt(m, u);
    if (in_doubt) ++result.in_doubt;
    if (answer.verdict != exact[k].verdict()) {
      if (!in_doubt) {
        ++result.wrong;
        result.wrong_at = exact::strata::text(queries[k]);
      }
      continue;
    }
    if (exact[k].verdict() != exact::Verdict::hit || !answer.t || m.sum < kSumIsNoNoise * u) continue;
    ++result.compared;
    const double units = std::ldexp(exact[k].residual(*answer.t), variant.bits);
    if (units <= result.worst) continue;
    result.worst = units;
    result.worst_at = exact::strata::text(queries[k]);
  }
  return result;
}

std::vector<ExactAnswer> exact_answers(const std::vector<TimingQuery>& queries) {
  std::vector<ExactAnswer> answers;
  for (const TimingQuery& query : queries) answers.emplace_back(query);
  return answers;
}

const Variant& variant_of_name(const std::string& name) {
  for (const Variant& variant : variants()) {
    if (variant.name == name) return variant;
  }
  throw std::invalid_argument(name);
}

class Ceilings : public testing::TestWithParam<Hazard> {};

TEST_P(Ceilings, OnWrongVerdictsAndOnResiduals) {
  const std::string& stratum = GetParam().name;
  const std::vector<TimingQuery> queries = questions_for(stratum, kPerStratum);
  const std::vector<ExactAnswer> exact = exact_answers(queries);
  for (const Variant& variant : variants()) {
    if (variant.formula != "stable" || variant.bits < asked(stratum).fewest_bits) continue;
    const Seen result = seen(queries, exact, variant);
    EXPECT_EQ(result.wrong, 0) << variant.name << ": wrong beyond doubt at " << result.wrong_at;
    EXPECT_LE(result.worst, kResidual) << variant.name << ": " << result.worst_at;
    // Most strata have contacts, misses and turnings, too; an exact tangent is no hit.
    EXPECT_GE(result.compared, stratum == "tangent" ? 0 : 5) << variant.name;
    if (stratum == "plain") {
      EXPECT_EQ(result.in_doubt, 0) << variant.name << ": there, every verdict must be right";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Strata, Ceilings, testing::ValuesIn(hazards()),
                         [](const auto& hazard) { return hazard.param.name; });

/// From afar the printed discriminant loses what the stable one keeps: grazes that no rounding of the latter
/// can hide.
TEST(CeilingsSee, WhatThePrintedFormulaMisses) {
  const std::vector<TimingQuery> queries = questions_for("graze", kPerStratum);
  const std::vector<ExactAnswer> exact = exact_answers(queries);
  EXPECT_GT(seen(queries, exact, variant_of_name("printed-float")).wrong, 0);
  EXPECT_GT(seen(queries, exact, variant_of_name("printed-double")).wrong, 0);
}

/// Eleven bits short, as a constant in double would leave a long double.
TEST(CeilingsSee, LostDigits) {
  const std::vector<TimingQuery> queries = questions_for("plain", kPerStratum);
  Variant pretender = variant_of_name("stable-double");
  pretender.bits = 64;
  EXPECT_GT(seen(queries, exact_answers(queries), pretender).worst, kResidual);
}

}  // namespace
}  // namespace tps::cost

// Who passes: tolerance classes, other readings, and the reference in double.
#include "verify/vectors/check_answers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "verify/operations/evaluate.hpp"
#include "verify/vectors/generate.hpp"

namespace tps::vectors {
namespace {

/// A time of about 1 with condition number 10, of which U(2) and K(8) are accepted.
Json timing_case() {
  return {{"verdict", "hit"},
          {"t", {hex(1), hex(std::nextafter(1.0, 2.0))}},
          {"nearest", "lo"},
          {"cond", 10},
          {"accept", {"R", "K(8)"}}};
}

bool passes(const Json& known, const Json& out) {
  return !wrong_in_answer(Op::block_time, known, out);
}

Json time_off_by(double units) {
  return {{"verdict", "hit"}, {"t", hex(1 + units * 0x1p-52)}};
}

TEST(Judging, KIsATimesTheConditionNumber) {
  EXPECT_TRUE(passes(timing_case(), time_off_by(0)));
  EXPECT_TRUE(passes(timing_case(), time_off_by(1)));
  EXPECT_TRUE(passes(timing_case(), time_off_by(40)));
  EXPECT_TRUE(passes(timing_case(), time_off_by(41)));
  EXPECT_FALSE(passes(timing_case(), time_off_by(42)));
  EXPECT_TRUE(passes(timing_case(), time_off_by(-40)));
  EXPECT_FALSE(passes(timing_case(), time_off_by(-41)));
}

TEST(Judging, RIsTheNearestDoubleAlone) {
  Json known = timing_case();
  known["accept"] = {"R"};
  EXPECT_TRUE(passes(known, time_off_by(0)));
  EXPECT_FALSE(passes(known, time_off_by(1)));
}

TEST(Judging, UIsCountedInUnitsOfTheLastPlace) {
  Json known = timing_case();
  known["accept"] = {"U(2)"};
  EXPECT_TRUE(passes(known, time_off_by(3)));
  EXPECT_FALSE(passes(known, time_off_by(4)));
}

TEST(Judging, NamesWhatIsWrong) {
  const Json known = timing_case();
  const auto wrong = [&](const Json& out) {
    return wrong_in_answer(Op::block_time, known, out).value_or("nothing");
  };
  EXPECT_EQ(wrong({{"verdict", "miss"}, {"t", nullptr}}), R"(verdict is "miss"; it is "hit")");
  EXPECT_EQ(wrong({{"t", nullptr}}), R"(t is absent; the event is at "0x1p+0")");
  EXPECT_EQ(wrong({{"t", "soon"}}),
            R"("soon" is not a number; allowed: a JSON number, a hexadecimal float, "inf")");
  EXPECT_EQ(wrong({{"t", {1, 2}}}), "t has 2 numbers; it has 1");
  EXPECT_EQ(wrong(Json(3)), "out is not an object");
  EXPECT_EQ(wrong({{"t", 1.0}}), "nothing");
}

TEST(Judging, EitherResponsePassesAtABoundary) {
  for (const Stratum& stratum : strata()) {
    if (stratum.file_name() != "tether_response.boundary.jsonl") continue;
    const Json known = Json::parse(case_line(stratum, kCommittedSeed, 0));
    ASSERT_TRUE(known.contains("also"));
    for (const Json& answer : {known, known["also"][0]}) {
      Json out{{"kind", answer["kind"]}};
      for (const auto& [key, ends] : answer["out"].items()) {
        for (const Json& end : ends) out[key].push_back(end[0]);
      }
      EXPECT_FALSE(wrong_in_answer(Op::tether_response, known, out)) << out.dump();
      out["kind"] = "break";
      EXPECT_TRUE(wrong_in_answer(Op::tether_response, known, out));
    }
  }
}

/// The reference's own equations in double.
Json answer_in_double(Op op, const Json& in) {
  const operations::Operation& operation = operations::operation(op);
  operations::Input input;
  for (const std::string& key : operation.keys) {
    const bool is_vector = in.at(key).is_array();
    input.values[key] = is_vector ? read_vector(in.at(key)) : std::vector<double>{read_number(in.at(key))};
    if (is_vector) input.dimension = static_cast<int>(in.at(key).size());
  }
  return Json::parse(operations::report_json(operation.name, "double",
                                             operations::evaluate(operation, input, "double")))
      .at("out");
}

/// Where the equations are well conditioned in double, the tolerance classes let the reference pass: they are
/// not tighter than a careful evaluation, and the known answers are no invention.
TEST(Judging, TheReferenceInDoublePassesWhereDoublesSuffice) {
  int judged = 0;
  for (const Stratum& stratum : strata()) {
    if (stratum.op == Op::order || stratum.op == Op::group) continue;
    if (stratum.name != "plain" && stratum.name != "planar" && stratum.name != "masses" &&
        stratum.name != "offset_origin" && stratum.name != "coefficients") {
      continue;
    }
    if (operations::operation(stratum.op).answers == operations::Answers::time && stratum.name != "plain")
      continue;
    for (std::uint64_t n = 0; n < 40; ++n) {
      const Json known = Json::parse(case_line(stratum, 3, n));
      const auto wrong = wrong_in_answer(stratum.op, known, answer_in_double(stratum.op, known.at("in")));
      EXPECT_FALSE(wrong) << known.at("id") << ": " << wrong.value_or("") << " cond " << known.at("cond");
      ++judged;
    }
  }
  EXPECT_GT(judged, 1000);
}

}  // namespace
}  // namespace tps::vectors

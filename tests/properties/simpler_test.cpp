// Shrinking: it ends, stays within the rules, and ends at what a person can read.
#include "properties/generators/simpler.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "properties/check_law.hpp"
#include "properties/explore/regressions.hpp"
#include "properties/implementations/reference.hpp"

namespace tps::properties {
namespace {

std::string shown(const Case& c) {
  std::ostringstream text;
  text << c;
  return text.str();
}

/// Answers nothing.
class Nobody final : public Implementation {
 public:
  std::string name() const override { return "nobody"; }
  Format format() const override { return {}; }
  Answer ask(const Question&) override { return {Answer::Status::failed, {}, "nobody is there"}; }
};

/// A law on the cases of eq. (4) that is broken where `condition` holds.
Law broken_where(std::function<bool(const Case&)> condition) {
  Law law = *find_law("Eq4Laws.Law1NormalVelocityTurnsByCAndTangentialStays");
  law.check = [condition = std::move(condition)](Interview&, const Case& c) {
    return condition(c) ? broken("as told") : Outcome{};
  };
  return law;
}

std::string shrunk_where(std::function<bool(const Case&)> condition) {
  const Law law = broken_where(std::move(condition));
  Nobody nobody;
  Tally tally;
  const auto finding = check_law(law, nobody, {.seed = 3, .first = 0, .count = 500}, tally);
  return finding ? shown(finding->shrunk) : "held";
}

// Hazards stay in the text; everything else is as small as it can be.
TEST(Simpler, EndsAtWhatAPersonCanRead) {
  const std::string anything = shrunk_where([](const Case&) { return true; });
  EXPECT_NE(anything.find("m_A = 1, m_B = 1, u_A = (0, 0), u_B = (0, 0), v_A = (0, 0), v_B = (0, 0)"),
            std::string::npos)
      << anything;
  const std::string heavy = shrunk_where([](const Case& c) { return c.number("m_B") > 100; });
  EXPECT_NE(heavy.find("m_B = 128"), std::string::npos) << heavy;
  const std::string fast = shrunk_where([](const Case& c) { return c.vector("v_B")[0] > 5.5; });
  EXPECT_NE(fast.find("v_B = (8, 0)"), std::string::npos) << fast;
  const std::string spatial = shrunk_where([](const Case& c) { return c.vector("u_B")[2] < 0; });
  EXPECT_NE(spatial.find("3-D"), std::string::npos) << spatial;
  EXPECT_NE(spatial.find("u_B = (0, 0, -1)"), std::string::npos) << spatial;
}

TEST(Simpler, EveryStepIsSimplerAndKeepsTheRules) {
  for (const char* scalar : {"double", "float"}) {
    const Format format = reference(scalar)->format();
    for (const Law& law : laws()) {
      for (std::uint64_t number = 0; number < 5; ++number) {
        const Case c = generated_case(law, format, 1, number);
        ASSERT_TRUE(fits(c, format)) << law.text.id << ": " << shown(c);
        for (const Case& each : simpler(c, format)) {
          ASSERT_LT(complexity(each), complexity(c)) << shown(each);
          ASSERT_TRUE(fits(each, format)) << law.text.id << ": " << shown(each);
          for (const auto& [key, values] : each.numbers) {
            for (const double x : values) {
              const Kind kind = kind_of(key);
              ASSERT_TRUE(x > 0 || (kind != Kind::length && kind != Kind::mass && kind != Kind::angle))
                  << key;
              ASSERT_TRUE((x >= 0 && x <= 1) || kind != Kind::coefficient) << key;
            }
          }
        }
      }
    }
  }
}

TEST(Simpler, CasesAreFunctionsOfLawFormatSeedAndNumber) {
  const Law& law = laws().front();
  EXPECT_EQ(generated_case(law, {}, 7, 3), generated_case(law, {}, 7, 3));
  EXPECT_NE(generated_case(law, {}, 7, 3), generated_case(law, {}, 7, 4));
  EXPECT_NE(generated_case(law, {}, 7, 3), generated_case(law, {}, 8, 3));
  EXPECT_NE(generated_case(law, {}, 7, 3).numbers, generated_case(laws()[1], {}, 7, 3).numbers);
}

TEST(Simpler, CasesGoThroughFilesUnchanged) {
  for (const Law& law : laws()) {
    for (std::uint64_t number = 0; number < 20; ++number) {
      const Case c = generated_case(law, {}, 11, number);
      EXPECT_EQ(read_case(Json::parse(case_json(c).dump())), c) << law.text.id;
    }
  }
}

}  // namespace
}  // namespace tps::properties

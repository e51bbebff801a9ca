#include "properties/explore/explore.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "properties/explore/report.hpp"
#include "properties/implementations/reference.hpp"

namespace tps::properties {
namespace {

Exploration explored(std::uint64_t first, std::uint64_t count) {
  const auto subject = reference("double");
  const Plan plan{laws_matching({"Eq6Laws.*"}), 5, first, count};
  return explore(
      *subject, plan, [] { return false; }, [](const Exploration&) {});
}

TEST(Explore, GoesOnWhereItEnded) {
  const Exploration whole = explored(0, 120), begun = explored(0, 70), ended = explored(begun.next, 50);
  EXPECT_EQ(begun.next, 70U);
  EXPECT_EQ(ended.next, whole.next);
  for (std::size_t k = 0; k < whole.laws.size(); ++k) {
    EXPECT_EQ(begun.laws[k].tally.held + ended.laws[k].tally.held, whole.laws[k].tally.held);
    EXPECT_EQ(begun.laws[k].tally.outside + ended.laws[k].tally.outside, whole.laws[k].tally.outside);
  }
}

TEST(Explore, AStopLeavesTheRoundToBeAskedAgain) {
  const auto subject = reference("double");
  const Plan plan{laws_matching({"Eq6Laws.*"}), 5, 0, 1000};
  int asked = 0;
  const Exploration stopped = explore(
      *subject, plan, [&asked] { return ++asked > 500; }, [](const Exploration&) {});
  EXPECT_EQ(stopped.next % 50, 0U);
  EXPECT_LT(stopped.next, 200U);
}

TEST(Explore, LawsAreChosenByIdAndNumber) {
  EXPECT_EQ(laws_matching({"(4) law 1"}).size(), 1U);
  EXPECT_EQ(laws_matching({"Eq4Laws.*"}).size(), 5U);
  EXPECT_EQ(laws_matching({"Eq4Laws.*", "(6) law 2"}).size(), 6U);
  EXPECT_EQ(laws_matching({}).size(), laws().size());
  EXPECT_TRUE(laws_matching({"Eq9*"}).empty());
}

// A law is named once, says something, and is explained on a page that is there.
TEST(Explore, LawsAreWellNamed) {
  std::set<std::string> ids, numbers;
  for (const Law& law : laws()) {
    EXPECT_TRUE(ids.insert(law.text.id).second) << law.text.id;
    EXPECT_TRUE(numbers.insert(law.text.number).second) << law.text.number;
    EXPECT_NE(law.text.number.find("law "), std::string::npos) << law.text.number;
    EXPECT_GE(law.text.sentence.size(), 20U) << law.text.id;
    EXPECT_FALSE(law.operations.empty()) << law.text.id;
    FILE* page = std::fopen((TPS_SOURCE_DIR "/" + law.text.page).c_str(), "r");
    ASSERT_NE(page, nullptr) << law.text.page;
    std::fclose(page);
  }
}

TEST(Explore, ReportsAreJsonToo) {
  const Json report = Json::parse(exploration_json(explored(0, 50)));
  EXPECT_EQ(report.at("next"), 50);
  EXPECT_EQ(report.at("laws").size(), 4U);
  EXPECT_EQ(report.at("laws")[0].at("state"), "holds");
  EXPECT_GT(report.at("hazards").at("infinite_mass"), 0);
  EXPECT_EQ(Json::parse(list_json(laws_matching({}))).size(), laws().size());
}

}  // namespace
}  // namespace tps::properties

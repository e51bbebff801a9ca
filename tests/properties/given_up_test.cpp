// When asking a program again is no use.
#include <gtest/gtest.h>

#include "properties/explore/explore.hpp"
#include "properties/implementations/program.hpp"

namespace tps::properties {
namespace {

/// A program that says hello and then does this for each request, $line.
std::unique_ptr<Implementation> shell(const std::string& act, std::chrono::milliseconds timeout) {
  return command(
      {"sh", "-c", "read -r line; echo '{\"name\":\"x\"}'; while read -r line; do " + act + "; done"},
      {timeout, std::nullopt});
}

const Question kQuestion{Op::load, Json::object()};

TEST(GivenUp, AfterAFewHangs) {
  const auto hangs = shell("sleep 1000", std::chrono::milliseconds(50));
  for (int n = 0; n < kMostHangs; ++n) {
    EXPECT_EQ(hangs->given_up(), "") << n;
    EXPECT_NE(hangs->ask(kQuestion).reason.find("hung: no reply within 50 ms"), std::string::npos);
  }
  EXPECT_EQ(hangs->given_up(), "given up after 5 hangs");
  EXPECT_EQ(hangs->ask(kQuestion).reason, hangs->given_up());
}

TEST(GivenUp, AfterManyFailuresInARow) {
  const auto ends = shell("exit 3", std::chrono::milliseconds(20'000));
  for (int n = 0; n < kMostFailuresInARow; ++n) {
    EXPECT_EQ(ends->given_up(), "") << n;
    EXPECT_EQ(ends->ask(kQuestion).reason, "ended with exit code 3");
  }
  EXPECT_EQ(ends->given_up(), "given up after 200 failures in a row");
}

/// Every other request is answered: the failures are those of a program that can be asked on.
TEST(GivenUp, NotWhereItAnswersInBetween) {
  const auto program = shell(
      "n=${line#*:}; n=${n%%,*}; [ $((n % 2)) = 0 ] && echo \"{\\\"seq\\\":$n,\\\"out\\\":{}}\" || exit 3",
      std::chrono::milliseconds(20'000));
  for (int n = 0; n < 2 * kMostFailuresInARow + 10; ++n) {
    const Answer answer = program->ask(kQuestion);
    ASSERT_EQ(answer.status, n % 2 == 0 ? Answer::Status::failed : Answer::Status::answered)
        << n << answer.reason;
  }
  EXPECT_EQ(program->given_up(), "");
}

/// All laws, thousands of cases: a timeout each would take hours.
TEST(GivenUp, EndsAnExploration) {
  const auto hangs = shell("sleep 1000", std::chrono::milliseconds(50));
  const Exploration exploration = explore(
      *hangs, {laws_matching({}), 1, 0, 500}, [] { return false; }, [](const Exploration&) {});
  ASSERT_EQ(exploration.findings().size(), 1U);
  EXPECT_NE(exploration.findings()[0]->outcome.why.find("hung"), std::string::npos);
}

}  // namespace
}  // namespace tps::properties

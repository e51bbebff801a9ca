// Every case that ever broke a law holds now: on the reference at every scalar that can hold its numbers.
#include "properties/explore/regressions.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "properties/implementations/reference.hpp"
#include "reference/text/input_error.hpp"

namespace tps::properties {
namespace {

std::vector<Regression> committed_regressions() {
  std::vector<Regression> all;
  for (const auto& entry : std::filesystem::directory_iterator(TPS_SOURCE_DIR "/data/regressions")) {
    if (entry.path().extension() != ".jsonl") continue;
    std::ifstream file(entry.path());
    for (Regression& each : read_regressions(file, entry.path().string())) all.push_back(std::move(each));
  }
  return all;
}

TEST(Regressions, CommittedCasesHoldNow) {
  const std::vector<Regression> regressions = committed_regressions();
  ASSERT_GE(regressions.size(), 5U);
  int held = 0;
  for (const std::string& name : reference_names()) {
    const auto implementation = reference(name);
    for (const Regression& each : regressions) {
      if (!fits(each.shrunk, implementation->format())) continue;
      const Examined found = examine(*each.law, *implementation, each.shrunk, true);
      EXPECT_FALSE(found.outcome.is_finding()) << name << ", " << each.law->text.id << ": "
                                               << found.outcome.why << "; once found in " << each.subject;
      held += found.outcome.kind == properties::Outcome::Kind::holds ? 1 : 0;
    }
  }
  EXPECT_GE(held, 5);
}

std::string refusal(const std::string& line) {
  std::istringstream in(line);
  try {
    read_regressions(in, "mine.jsonl");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Regressions, WrongFilesSayWhatIsWrong) {
  EXPECT_NE(refusal("{").find("mine.jsonl:1"), std::string::npos) << refusal("{");
  const std::string unknown =
      R"({"law":"Eq4Laws.Law1","case":{"dimension":2,"hazard":"x","numbers":{}},"subject":"s","why":"w"})";
  EXPECT_NE(refusal(unknown).find("did you mean Eq"), std::string::npos) << refusal(unknown);
  const auto law4 = [](const std::string& numbers, int dimension) {
    return R"({"law":"Eq6Laws.Law3SwapOfNames","case":{"dimension":)" + std::to_string(dimension) +
           R"(,"hazard":"x","numbers":)" + numbers + R"(},"subject":"s","why":"w"})";
  };
  EXPECT_NE(refusal(law4("{}", 2)).find("needs m_A"), std::string::npos) << refusal(law4("{}", 2));
  const std::string numbers =
      R"({"m_A":["0x1p+0"],"m_B":["inf"],"v_A":["0x1p+0","0x0p+0"],"v_B":["0x0p+0","0x0p+0"]})";
  EXPECT_EQ(refusal(law4(numbers, 2)), "accepted");
  EXPECT_NE(refusal(law4(numbers, 3)).find("2 components in 3 dimensions"), std::string::npos);
  EXPECT_NE(refusal(law4(R"({"m_A":[1]})", 2)).find("m_A has 1; a number is a hexadecimal float"),
            std::string::npos);
  EXPECT_NE(
      refusal(law4(R"({"m_A":[],"m_B":["inf"],"v_A":["inf","inf"],"v_B":[]})", 2)).find("outside its range"),
      std::string::npos);
  EXPECT_NE(refusal(law4(R"({"m_A":[],"m_B":[],"v_A":["0x0p+0","0x0p+0"],"v_B":["0x0p+0","0x0p+0"]})", 2))
                .find("needs m_A"),
            std::string::npos);
}

}  // namespace
}  // namespace tps::properties

// Known-answer files that are not what they should be.
#include "verify/vectors/read_vectors.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "verify/vectors/check_answers.hpp"
#include "verify/vectors/generate.hpp"

namespace tps::vectors {
namespace {

struct Found {
  int cases = 0;
  std::vector<std::string> problems;
};

Found read(const std::string& text) {
  Found found;
  std::istringstream in(text);
  read_vectors(in, "file",
               {[&](const std::string&, const Json&, const Place&) { ++found.cases; },
                [&](const std::string& problem, const Place& place) {
                  found.problems.push_back(std::to_string(place.line) + ": " + problem);
                }});
  return found;
}

const Stratum& integers() {
  for (const Stratum& stratum : strata()) {
    if (stratum.file_name() == "block_time.integers.jsonl") return stratum;
  }
  throw std::logic_error("no such stratum");
}

std::string file(std::uint64_t count) {
  std::string text;
  write_stratum(integers(), 1, {0, count}, [&](std::string_view line) { text += line; });
  return text;
}

TEST(ReadVectors, TakesFilesOneAfterTheOther) {
  const Found found = read(file(3) + file(2));
  EXPECT_EQ(found.cases, 5);
  EXPECT_TRUE(found.problems.empty());
}

TEST(ReadVectors, NoticesTruncation) {
  const std::string text = file(3);
  const Found found = read(text.substr(0, text.rfind("{\"id\"")));
  ASSERT_EQ(found.problems.size(), 1U);
  EXPECT_NE(found.problems[0].find("2 cases where the header announces 3"), std::string::npos);
  EXPECT_FALSE(read(text.substr(0, text.size() - 20)).problems.empty());
}

TEST(ReadVectors, SurvivesWhatIsNoFile) {
  for (const std::string& text :
       {std::string(), std::string("garbage\n"), std::string("[1,2]\n"), std::string("\xff\xfe\n"),
        std::string("{\n"), std::string(3 << 20, 'x'), std::string(100000, '['),
        std::string("{\"schema\":\"vectors\"}\n"), std::string("{\"id\":\"a case before its header\"}\n")}) {
    const Found found = read(text);
    EXPECT_EQ(found.cases, 0) << text.substr(0, 40);
    EXPECT_FALSE(found.problems.empty()) << text.substr(0, 40);
  }
}

TEST(Generate, ACaseDependsOnNothingButItsNumber) {
  EXPECT_EQ(case_line(integers(), 5, 17), case_line(integers(), 5, 17));
  EXPECT_NE(case_line(integers(), 5, 17), case_line(integers(), 6, 17));
}

TEST(Generate, EveryIdIsThereOnce) {
  std::set<std::string> files;
  for (const Stratum& stratum : strata())
    EXPECT_TRUE(files.insert(stratum.file_name()).second) << stratum.file_name();
}

}  // namespace
}  // namespace tps::vectors

// Scenes that must be refused, each with its whole message: broken/NAME.json and broken/NAME.expected.
// A message that changes on purpose: run the test program with TPS_UPDATE_EXPECTED=1 and review the
// difference.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "reference/scene/read_scene.hpp"
#include "tests/support/content.hpp"

namespace tps {
namespace {

const std::filesystem::path broken_folder = std::filesystem::path(TPS_SOURCE_DIR) / "tests/scene/broken";

std::vector<std::string> broken_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(broken_folder)) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

// The message without the folder; "accepted" if there is none.
std::string message_of(const std::string& name) {
  try {
    read_scene_text(content(broken_folder / (name + ".json")), name + ".json");
  } catch (const InputError& error) {
    return std::string(error.what()) + "\n";
  }
  return "accepted\n";
}

class BrokenScene : public testing::TestWithParam<std::string> {};

TEST_P(BrokenScene, IsRefusedWithItsMessage) {
  const std::filesystem::path expected = broken_folder / (GetParam() + ".expected");
  const std::string message = message_of(GetParam());
  if (std::getenv("TPS_UPDATE_EXPECTED") != nullptr) std::ofstream(expected, std::ios::binary) << message;
  EXPECT_EQ(message, content(expected));
}

INSTANTIATE_TEST_SUITE_P(Files, BrokenScene, testing::ValuesIn(broken_names()),
                         [](const auto& parameter) { return parameter.param; });

TEST(BrokenScenes, AreManyAndEachHasAMessage) {
  const std::vector<std::string> names = broken_names();
  EXPECT_GE(names.size(), 30U);
  for (const std::string& name : names) {
    EXPECT_EQ(content(broken_folder / (name + ".expected")).rfind(name + ".json", 0), 0U) << name;
  }
}

}  // namespace
}  // namespace tps

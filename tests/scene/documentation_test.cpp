// docs/scene.md keeps its promises: its examples are scenes, its messages are ours, its sections are the
// keys.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "reference/scene/read_scene.hpp"
#include "reference/text/schema_validator.hpp"
#include "tests/support/content.hpp"

namespace tps {
namespace {

const std::filesystem::path root = TPS_SOURCE_DIR;

// The fenced blocks of one language.
std::vector<std::string> blocks(const std::string& language) {
  std::vector<std::string> found;
  std::istringstream page(content(root / "docs/scene.md"));
  std::string line;
  bool inside = false;
  while (std::getline(page, line)) {
    if (inside && line == "```") {
      inside = false;
    } else if (inside) {
      found.back() += line + "\n";
    } else if (line == "```" + language) {
      inside = true;
      found.emplace_back();
    }
  }
  return found;
}

// What a fragment of a scene ("key": value) is put into.
const char* const surroundings = R"({
  "tps": 1, "dimension": 2, "duration": 1,
  "species": {"vesicle": {"mass": 1, "radius": 0.5}, "synapsin": {"mass": 1, "radius": 0.1},
              "membrane": {"mass": "inf", "radius": 10}},
  "pairs": [{"between": ["vesicle", "synapsin"], "blocking": {"c_rebound": 1},
             "tethering": {"distance": 3, "c_retract": 1, "c_revolve": 1, "theta_revolve_deg": 45}}],
  "particles": [{"species": "vesicle", "position": [-2, 0]}, {"species": "vesicle", "position": [2, 0]},
                {"species": "synapsin", "position": [0, 0]}]
})";

TEST(SceneDocumentation, ExamplesAreAccepted) {
  const std::vector<std::string> examples = blocks("json");
  EXPECT_GE(examples.size(), 10U);
  for (const std::string& example : examples) {
    std::string text = example;
    if (text.front() != '{') {
      nlohmann::json scene = nlohmann::json::parse(surroundings);
      scene.update(nlohmann::json::parse("{" + example + "}"));
      text = scene.dump();
    }
    EXPECT_NO_THROW(read_scene_text(text, "example")) << example;
  }
}

TEST(SceneDocumentation, MessagesAreTheProgramsOwn) {
  std::size_t lines = 0;
  for (const std::string& block : blocks("text")) {
    std::istringstream text(block);
    std::string line;
    while (std::getline(text, line)) {
      const std::string name = line.substr(0, line.find(".json"));
      const std::string whole = content(root / "tests/scene/broken" / (name + ".expected"));
      EXPECT_NE(whole.find(line + "\n"), std::string::npos) << line;
      ++lines;
    }
  }
  EXPECT_GE(lines, 5U);
}

TEST(SceneDocumentation, EveryKeyHasItsSection) {
  const std::string page = content(root / "docs/scene.md");
  const nlohmann::json schema = nlohmann::json::parse(embedded_schema_text("scene"));
  for (const auto& [key, property] : schema.at("properties").items()) {
    const std::string mention = property.contains("not") ? "`" + key + "`" : "\n### `" + key + "`";
    EXPECT_NE(page.find(mention), std::string::npos) << key;
  }
}

}  // namespace
}  // namespace tps

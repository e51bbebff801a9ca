// Scenarios of ARSLab_TPS: what becomes of each key, and what is said about files that cannot be used.
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/scene/read_scene.hpp"
#include "reference/scene/write_scene.hpp"
#include "tests/support/content.hpp"
#include "verify/import/arslab_tps.hpp"

namespace tps::arslab {
namespace {

const std::string data_folder = TPS_SOURCE_DIR "/tests/import/data/";
const ImportOptions as_it_is{};
const ImportOptions without_impulses{
    .c_rebound = {}, .dt_restitute = {}, .duration = {}, .without_random_impulses = true};

ImportedScene import_text(const std::string& text, const ImportOptions& options = as_it_is) {
  return import_scenario(parse_json(text, "f", import_limits), options);
}

ImportedScene import_data(const std::string& name, const ImportOptions& options = as_it_is) {
  return import_text(content(data_folder + name), options);
}

/// The message about a text; "accepted" if there is none.
std::string message_about(const std::string& text) {
  try {
    import_text(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("the file has no " + from);
  return text.replace(at, from.size(), to);
}

bool reads_back(const Scene& scene) {
  return read_scene_text(write_scene(scene), "imported") == scene;
}

TEST(ArslabTps, KeepsIdsNamesAndNumbers) {
  const Scene scene = import_data("three_bodies.json").scene;
  EXPECT_EQ(scene.dimension, 2);
  EXPECT_EQ(scene.duration, 10);
  EXPECT_FALSE(scene.grouping);
  const std::vector<Species> species{{.name = "ball", .mass = 1, .radius = 0.5, .max_tethers = {}},
                                     {.name = "block", .mass = 3, .radius = 0.25, .max_tethers = {}}};
  EXPECT_EQ(scene.species, species);
  const std::vector<Particle> particles{
      {.id = 1, .species = 0, .position = {-3, 0, 0}, .velocity = {1, 0, 0}},
      {.id = 2, .species = 0, .position = {0, 0, 0}, .velocity = {}},
      {.id = 10, .species = 1, .position = {2.75, 0, 0}, .velocity = {}}};
  EXPECT_EQ(scene.particles, particles);
}

TEST(ArslabTps, EveryTwoSpeciesBlockAtTheSumOfTheirRadii) {
  const std::vector<PairLaw> laws{{.species_a = 0,
                                   .species_b = 0,
                                   .blocking = BlockingLaw{.distance = 1, .c_rebound = 1},
                                   .tethering = {}},
                                  {.species_a = 0,
                                   .species_b = 1,
                                   .blocking = BlockingLaw{.distance = 0.75, .c_rebound = 1},
                                   .tethering = {}},
                                  {.species_a = 1,
                                   .species_b = 1,
                                   .blocking = BlockingLaw{.distance = 0.5, .c_rebound = 1},
                                   .tethering = {}}};
  EXPECT_EQ(import_data("three_bodies.json").scene.pairs, laws);
}

TEST(ArslabTps, PointsDoNotCollideWithPoints) {
  const Scene scene = import_data("four_bodies.json", without_impulses).scene;
  ASSERT_EQ(scene.pairs.size(), 2U);
  EXPECT_EQ(scene.pairs[1].species_b, 1);
  EXPECT_EQ(scene.pairs[1].blocking->distance, 0.5);
  EXPECT_EQ(scene.dimension, 3);
}

TEST(ArslabTps, OptionsSayWhatTheFileDoesNot) {
  const Scene scene = import_data("three_bodies.json", {.c_rebound = 0.5,
                                                        .dt_restitute = 0.125,
                                                        .duration = std::numeric_limits<double>::infinity(),
                                                        .without_random_impulses = false})
                          .scene;
  for (const PairLaw& law : scene.pairs) EXPECT_EQ(law.blocking->c_rebound, 0.5);
  EXPECT_EQ(scene.grouping, Grouping{0.125});
  EXPECT_EQ(scene.duration, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(reads_back(scene));
}

TEST(ArslabTps, SaysWhatItAssumesAndDrops) {
  EXPECT_EQ(import_data("three_bodies.json").notes.size(), 1U) << "c_rebound";
  const ImportedScene four = import_data("four_bodies.json", without_impulses);
  EXPECT_EQ(four.scene.duration, 25) << "that program's built-in time";
  const std::vector<std::string> expected{
      "config.ri is true; the scene has no random impulses, as asked",
      "config.runtime is missing; the duration is 25, the built-in time of ARSLab_TPS for such files; "
      "--duration gives "
      "another",
      "tau, shape and mean of the species are dropped: they describe random impulses",
      "the file has no coefficient of restitution; every pair has c_rebound 1; --c-rebound gives another",
      "radius 0: particles of \"point\" do not collide with one another"};
  EXPECT_EQ(four.notes, expected);
}

TEST(ArslabTps, WhatIsImportedReadsBackAsTheSameScene) {
  EXPECT_TRUE(reads_back(import_data("three_bodies.json").scene));
  EXPECT_TRUE(reads_back(import_data("four_bodies.json", without_impulses).scene));
}

TEST(ArslabTps, ThePageShowsTheExample) {
  EXPECT_NE(content(TPS_SOURCE_DIR "/docs/import.md").find(content(data_folder + "three_bodies.json")),
            std::string::npos);
}

TEST(ArslabTps, RandomImpulsesAreImportedUnlessDropped) {
  const Scene scene = import_data("four_bodies.json").scene;
  EXPECT_EQ(scene.species[0].random_impulses, (RandomImpulses{0.5, 2, 0.25}));
  EXPECT_EQ(scene.species[1].random_impulses, (RandomImpulses{1, 2, 0.5}));
  EXPECT_TRUE(reads_back(scene));
  EXPECT_EQ(import_data("without_config.json").scene.species[0].random_impulses,
            (RandomImpulses{0.2, 0.2, 0.2}));
  EXPECT_EQ(import_data("four_bodies.json", without_impulses).scene.species[0].random_impulses, std::nullopt);
  std::string file = content(data_folder + "four_bodies.json");
  file.replace(file.find("\"tau\": 0.5, "), 12, "");
  EXPECT_EQ(message_about(file),
            "f:4: /species/bead: lacks tau; random impulses have tau, shape and mean; add it, or give "
            "--without-random-impulses");
  file = content(data_folder + "four_bodies.json");
  file.replace(file.find("0.25"), 4, "-1");
  EXPECT_EQ(message_about(file),
            "f:4: /species/bead/mean: is -1; allowed: above 0, or give --without-random-impulses");
}

struct Wrong {
  const char* from;  ///< in three_bodies.json
  const char* to;
  const char* says;
};

TEST(ArslabTps, SaysWhatIsWrong) {
  const Wrong cases[] = {
      {"\"runtime\"", "\"runtim\"",
       R"(f:2: /config: unknown key "runtim"; the nearest known key is "runtime"; allowed: "ri", "runtime")"},
      {"\"ri\": false, ", "", R"(f:2: /config: key "ri" is missing; it holds true or false)"},
      {"10}", "0}", "f:2: /config/runtime: found 0; allowed: a number greater than 0"},
      {"\"mass\": 3", "\"mass\": 0", "f:5: /species/block/mass: found 0; allowed: a number greater than 0"},
      {"\"mass\": 3", "\"mass\": \"0x3p0\"",
       "f:5: /species/block/mass: found \"0x3p0\"; allowed: a number greater than 0"},
      {"\"mass\": 3", "\"mass\": NaN", "f:5: /species/block/mass: found NaN; allowed: JSON numbers"},
      {"\"radius\": 0.25", "\"radius\": -1",
       "f:5: /species/block/radius: found -1; allowed: a number of at least 0"},
      {"\"10\"", "\"x\"",
       "f:10: /particles/x: the key \"x\" is no id; allowed: an integer from 0 to 2147483647 in digits, "
       "without "
       "sign, space or leading zero"},
      {"\"10\"", "\"-1\"", "f:10: /particles/-1: the key \"-1\" is no id"},
      {"\"10\"", "\"-0\"", "f:10: /particles/-0: the key \"-0\" is no id"},
      {"\"10\"", "\"01\"", "f:10: /particles/01: the key \"01\" is no id"},
      {"\"10\"", "\"1 \"", "f:10: /particles/1 : the key \"1 \" is no id"},
      {"\"10\"", "\"\"", "f:10: /particles/: the key \"\" is no id"},
      {"\"10\"", "\"2147483648\"", "f:10: /particles/2147483648: the key \"2147483648\" is no id"},
      {"\"10\"", "\"a/b~\"", "f:10: /particles/a~1b~0: the key \"a/b~\" is no id"},
      {"\"10\"", "\"\\u0031\"", "f:10: /particles: key \"1\" stands twice, here and in line 8; keep one"},
      {"\"species\": \"block\"", "\"species\": \"blok\"",
       "f:10: /particles/10/species: no species is named \"blok\"; the nearest is \"block\""},
      {"[2.75, 0]", "[2.75, 0, 0]",
       "f:10: /particles/10/position: found 3 numbers; allowed: 2, as in the position of particle \"1\" "
       "(line 8)"},
      {"[1, 0]", "[1, 0, 0]",
       "f:8: /particles/1/velocity: found 3 numbers; allowed: 2, as in the position of particle \"1\" (line "
       "8)"},
      {"[2.75, 0]", "[2.75]",
       "f:10: /particles/10/position: found a list of 1 entry; allowed: a list of 2 or 3 "},
      {"[2.75, 0]", "[1e999, 0]",
       "f:10: /particles/10/position/0: number 1e999 is beyond the largest double"},
      {"[2.75, 0]", "[0.5, 0]",
       "f:10: /particles/10/position: particles 2 and 10 start 0.5 apart, nearer than their blocking "
       "distance 0.75"},
      {", \"velocity\": [0, 0]", "", "f:9: /particles/2: key \"velocity\" is missing"},
  };
  const std::string text = content(data_folder + "three_bodies.json");
  for (const Wrong& wrong : cases) {
    const std::string message = message_about(replaced(text, wrong.from, wrong.to));
    EXPECT_TRUE(message.starts_with(wrong.says)) << message << "\nexpected " << wrong.says;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message << "\nis more than was broken";
  }
}

/// What is printed of a key is not the key: it is escaped, and cut.
TEST(ArslabTps, WhatLacksAKeyIsNotReadWhateverItIsCalled) {
  std::vector<std::string> names = {"a~b/c",   "~1",      "",        "/",           "\u009B1",
                                    "\u202E1", "\uFEFF1", "\\u0007", "\\u001b[31m", "\\\\\\\""};
  for (int length = 1; length <= 1000; length += 37) names.emplace_back(length, 'x');
  const std::vector<std::string> keys = {R"("position":[0,0])", R"("velocity":[1,0])", R"("species":"a")"};
  for (const std::string& name : names) {
    for (unsigned left_out = 1; left_out < 8; ++left_out) {
      std::vector<std::string> left;
      for (unsigned k = 0; k < keys.size(); ++k) {
        if ((left_out >> k & 1U) == 0) left.push_back(keys[k]);
      }
      const std::string text = fmt::format(
          R"({{"config":{{"ri":false}},"species":{{"a":{{"mass":1,"radius":1}}}},"particles":{{"{}":{{{}}}}}}})",
          name, fmt::join(left, ","));
      EXPECT_NE(message_about(text).find("is missing"), std::string::npos) << text;
    }
    EXPECT_NE(
        message_about(
            fmt::format(R"({{"config":{{"ri":false}},"species":{{"{}":{{"mass":1}}}},"particles":{{}}}})",
                        name))
            .find("is missing"),
        std::string::npos)
        << name;
  }
}

TEST(ArslabTps, SaysEverythingAtOnce) {
  std::string text = content(data_folder + "three_bodies.json");
  text = replaced(text, "\"mass\": 1", "\"mass\": -1");
  text = replaced(text, "\"2\":", "\"two\":");
  text = replaced(text, "\"block\"}", "\"bloc\"}");
  const std::string message = message_about(text);
  for (const char* place :
       {"f:4: /species/ball/mass: ", "f:9: /particles/two: ", "f:10: /particles/10/species: "}) {
    EXPECT_NE(message.find(place), std::string::npos) << place << " is not in\n" << message;
  }
}

TEST(ArslabTps, AFileWithoutParticlesHasNoDimension) {
  const char* text =
      R"({"config": {"ri": false}, "species": {"bead": {"mass": 1, "radius": 1}}, "particles": {}})";
  EXPECT_EQ(
      message_about(text),
      "f:1: /particles: found no particle, and so no dimension; allowed: at least one; add those that are to "
      "be simulated");
}

TEST(ArslabTps, NotAScenario) {
  for (const char* text :
       {"", " ", "null", "[]", "{}", "7", "{\"config\": 1, \"species\": [], \"particles\": \"\"}"}) {
    EXPECT_NE(message_about(text), "accepted") << text;
  }
}

std::string with_species(const std::string& species) {
  return R"({"config": {"ri": false, "runtime": 1}, "species": {)" + species +
         R"(}, "particles": {"0": {"position": [0, 0], "velocity": [0, 0], "species": "s0"}}})";
}

std::string many_species(std::size_t count) {
  std::string list;
  for (std::size_t k = 0; k < count; ++k) {
    list += fmt::format(R"({}"s{}": {{"mass": 1, "radius": 1}})", k == 0 ? "" : ", ", k);
  }
  return list;
}

// Pairs grow with the square of the species: without a limit a file of a megabyte would ask for gigabytes.
TEST(ArslabTps, LimitsWhatASmallFileCanAskFor) {
  EXPECT_TRUE(reads_back(import_text(with_species(many_species(max_species))).scene));
  EXPECT_EQ(message_about(with_species(many_species(max_species + 1))),
            "f:1: /species: found 101 species; allowed: at most 100, since every two of them interact; "
            "remove those "
            "without particles");
  const std::string long_name =
      fmt::format(R"("s0": {{"mass": 1, "radius": 1}}, "{}": {{"mass": 1, "radius": 1}})",
                  std::string(max_species_name + 1, 'n'));
  EXPECT_NE(message_about(with_species(long_name)).find("the name has 201 bytes; allowed: at most 200"),
            std::string::npos);
  const std::string huge = R"("s0": {"mass": 1, "radius": 1e308}, "huge": {"mass": 1, "radius": 1e308})";
  EXPECT_NE(message_about(with_species(huge))
                .find("/species/huge/radius: the sum of the radii of \"s0\" and \"huge\""),
            std::string::npos);
}

TEST(ArslabTps, NoBeginningOfAFileIsAFile) {
  const std::string text = content(data_folder + "three_bodies.json");
  const std::size_t end = text.rfind('}');
  for (std::size_t length = 0; length <= end; ++length) {
    EXPECT_NE(message_about(text.substr(0, length)), "accepted") << length;
  }
}

TEST(ArslabTps, AnyOtherByteIsRefusedOrMakesAScene) {
  const std::string text = content(data_folder + "three_bodies.json");
  std::size_t scenes = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    for (const char byte : {'0', '9', '-', 'e', '"', '}', ' ', '\0', '\xff'}) {
      std::string changed = text;
      changed[at] = byte;
      try {
        EXPECT_TRUE(reads_back(import_text(changed).scene)) << changed;
        ++scenes;
      } catch (const InputError&) {
        continue;
      }
    }
  }
  EXPECT_GT(scenes, 100U) << "spaces for spaces at least";
}

}  // namespace
}  // namespace tps::arslab

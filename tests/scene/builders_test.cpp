// The catalogue of parametrised scenes: the committed files, the options, and what each scene promises.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <sstream>
#include <stdexcept>

#include "reference/run/run.hpp"
#include "reference/scene/read_scene.hpp"
#include "reference/scene/write_scene.hpp"
#include "verify/scenes/gas.hpp"
#include "verify/scenes/registry.hpp"
#include "verify/scenes/ring.hpp"
#include "verify/scenes/terminal.hpp"
#include "verify/scenes/three_body.hpp"

namespace tps {
namespace {

const std::filesystem::path kData = std::filesystem::path(TPS_SOURCE_DIR) / "data";

std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file.is_open()) << path;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

Scene built(const std::string& name, const OptionValues& values = {}) {
  return scene_builder(name).build(values);
}

/// The scene that "NAME --option value …" describes.
Scene built_by_command(const std::string& command) {
  std::istringstream words(command);
  std::string name, option, value;
  words >> name;
  OptionValues values;
  while (words >> option >> value) values[option.substr(2)] = value;
  return built(name, values);
}

/// File and command of each row "| [`scenes/FILE`](…) | `tps scene COMMAND` | … |" of data/README.md.
std::map<std::string, std::string> generator_commands() {
  std::map<std::string, std::string> commands;
  std::istringstream lines(contents(kData / "README.md"));
  const std::string before_command = "`tps scene ";
  for (std::string line; std::getline(lines, line);) {
    const auto file = line.find("](scenes/");
    const auto command = line.find("| " + before_command);
    if (file == std::string::npos || command == std::string::npos) continue;
    const auto file_start = file + 2;
    const auto command_start = command + 2 + before_command.size();
    commands[line.substr(file_start, line.find(')', file_start) - file_start)] =
        line.substr(command_start, line.find('`', command_start) - command_start);
  }
  return commands;
}

std::string message_of(const std::string& name, const OptionValues& values) {
  try {
    built(name, values);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "(accepted)";
}

TEST(Builders, CommittedScenesAreWhatTheirCommandsWrite) {
  const auto commands = generator_commands();
  ASSERT_GE(commands.size(), scene_builders().size());
  for (const auto& [file, command] : commands) {
    EXPECT_TRUE(write_scene(built_by_command(command)) == contents(kData / file))
        << "data/" << file << " is not what `tps scene " << command << "` writes; write it again";
  }
}

TEST(Builders, EveryCommittedSceneHasACommandAndEveryBuilderAFile) {
  const auto commands = generator_commands();
  for (const auto& entry : std::filesystem::directory_iterator(kData / "scenes")) {
    EXPECT_TRUE(commands.contains("scenes/" + entry.path().filename().string())) << entry.path();
  }
  for (const SceneBuilder& builder : scene_builders()) {
    EXPECT_TRUE(commands.contains("scenes/" + builder.name + ".json")) << builder.name;
  }
}

TEST(Builders, EveryDefaultSceneIsAccepted) {
  for (const SceneBuilder& builder : scene_builders()) {
    EXPECT_NO_THROW(read_scene_text(write_scene(builder.build({})), builder.name)) << builder.name;
  }
}

TEST(Builders, TouchingAndTautStartsAreAcceptedAsContacts) {
  const std::vector<std::string> commands{"cradle --particles 100",
                                          "sheet --rows 12 --columns 12 --spacing 1",
                                          "sheet --rows 12 --columns 12 --spacing 1.4",
                                          "sheet --spacing 1.3 --tether-distance 1.3",
                                          "ring",
                                          "three-body --gap 0"};
  for (const std::string& command : commands) {
    EXPECT_NO_THROW(read_scene_text(write_scene(built_by_command(command)), command)) << command;
  }
}

TEST(Builders, OptionsDescribeThemselves) {
  for (const SceneBuilder& builder : scene_builders()) {
    std::set<std::string> names;
    for (const BuilderOption& option : builder.options) {
      EXPECT_TRUE(names.insert(option.name).second) << builder.name << " --" << option.name << " twice";
      // A default, as help shows it, is accepted and changes nothing.
      EXPECT_EQ(write_scene(builder.build({{option.name, option.default_value}})),
                write_scene(builder.build({})))
          << builder.name << " --" << option.name;
      EXPECT_THROW(builder.build({{option.name, "nonsense"}}), std::invalid_argument);
      EXPECT_THROW(builder.build({{option.name, "nan"}}), std::invalid_argument);
      EXPECT_THROW(builder.build({{option.name, "-2"}}), std::invalid_argument);  // −1 is a β₀
    }
  }
}

TEST(Builders, ErrorsNameOptionValueAndRange) {
  EXPECT_EQ(message_of("chain", {{"particles", "1"}}),
            "--particles is \"1\"; allowed is an integer from 2 to 1000000");
  EXPECT_EQ(message_of("chain", {{"particles", "3.5"}}),
            "--particles is \"3.5\"; allowed is an integer from 2 to 1000000");
  EXPECT_EQ(message_of("pair", {{"c-revolve", "1.5"}}),
            "--c-revolve is \"1.5\"; allowed is a number from 0 to 1");
  EXPECT_EQ(message_of("pair", {{"speed", "0"}}), "--speed is \"0\"; allowed is a number above 0 to 1e+100");
  EXPECT_EQ(message_of("galperin", {{"mass", "3"}}),
            "the scene \"galperin\" has no option --mass; it has --digits --speed");
  EXPECT_EQ(message_of("cradle", {{"moving", "6"}}),
            "--moving is 6; allowed is an integer from 0 to --particles, 5");
  EXPECT_NE(message_of("sheet", {{"spacing", "1.5"}}).find("neighbours must start within their tethers"),
            std::string::npos);
  EXPECT_EQ(message_of("terminal", {{"impact-at", "80"}}),
            "--impact-at is 80; impacts begin before --duration, 80, or there are none: --impacts 0");
  EXPECT_NE(
      message_of("gas", {{"particles", "2"}, {"periodic", "1"}}).find("--periodic 1, --particles 2 and"),
      std::string::npos);
  EXPECT_NE(message_of("gas", {{"density", "1"}}).find("lower the density"), std::string::npos);
  EXPECT_NE(message_of("terminal", {{"vesicles", "400"}}).find("--membrane-radius"), std::string::npos);
  EXPECT_THROW(scene_builder("teminal"), std::invalid_argument);
}

TEST(Builders, HexadecimalValuesAreExact) {
  EXPECT_EQ(built("three-body", {{"gap", "0x1p-7"}}).particles[2].position[0], 0.75 + 0x1p-7);
}

TEST(Builders, SeedsChangeDrawnScenesOnly) {
  for (const SceneBuilder& builder : scene_builders()) {
    const bool has_seed = std::any_of(builder.options.begin(), builder.options.end(),
                                      [](const BuilderOption& option) { return option.name == "seed"; });
    if (!has_seed) continue;
    EXPECT_NE(builder.build({{"seed", "2"}}).particles[1].velocity, builder.build({}).particles[1].velocity)
        << builder.name;
  }
}

TEST(Builders, ThermalScenesHaveNoMomentumAndTheirTemperature) {
  for (const std::string name : {"terminal", "terminal-action-potential", "chain", "sheet", "gas"}) {
    const Scene scene = built(name, {{"temperature", "1"}});
    Coordinates momentum{};
    double twice_kinetic = 0, speed_sum = 0;
    int moving = 0;
    for (const Particle& particle : scene.particles) {
      const double mass = scene.species[static_cast<std::size_t>(particle.species)].mass;
      if (std::isinf(mass)) continue;
      ++moving;
      for (std::size_t k = 0; k < 3; ++k) {
        momentum[k] += mass * particle.velocity[k];
        speed_sum += mass * std::abs(particle.velocity[k]);
        twice_kinetic += mass * particle.velocity[k] * particle.velocity[k];
      }
    }
    // Sums of n terms: n roundings of terms whose magnitudes add up to speed_sum.
    for (const double p : momentum) EXPECT_LE(std::abs(p), moving * 0x1p-52 * speed_sum) << name;
    // 3(n-1) squares of normal numbers: mean 3(n-1), standard deviation sqrt(6(n-1)); five of them.
    EXPECT_NEAR(twice_kinetic, 3.0 * (moving - 1), 5 * std::sqrt(6.0 * (moving - 1))) << name;
  }
}

TEST(Builders, TerminalStartsIsolated) {
  const Scene scene = built("terminal");
  ASSERT_TRUE(scene.clusters.has_value());
  std::map<int, int> count, tethers;
  for (const Particle& particle : scene.particles) ++count[particle.species];
  EXPECT_EQ(count[0], 1);
  EXPECT_GE(count[1], 40);
  EXPECT_GE(count[2], 2 * 80);
  EXPECT_TRUE(std::isinf(scene.species[0].mass));
  // Every synapsin has its mate and nothing else; vesicles have nothing.
  for (const Tether& tether : scene.tethers) {
    for (const int i : {tether.i, tether.j}) {
      EXPECT_EQ(scene.particles[static_cast<std::size_t>(i)].species, 2);
      EXPECT_EQ(++tethers[i], 1) << "particle " << i;
    }
  }
  EXPECT_EQ(static_cast<int>(tethers.size()), count[2]);
  EXPECT_EQ(scene.species[2].max_tethers, 2);
  for (const ScheduledImpulse& impulse : scene.impulses) {
    EXPECT_EQ(scene.particles[static_cast<std::size_t>(impulse.particle)].species, 1);
    EXPECT_GT(impulse.at, scene.duration / 2);
    EXPECT_LT(impulse.at, scene.duration);
  }
}

TEST(Builders, AnActionPotentialBreaksUpClustersThatFormAgain) {
  const Scene scene = built("terminal-action-potential");
  ASSERT_EQ(scene.phases.size(), 1U);
  EXPECT_EQ(scene.species[static_cast<std::size_t>(scene.phases[0].species_a)].name, "vesicle");
  EXPECT_EQ(scene.species[static_cast<std::size_t>(scene.phases[0].species_b)].name, "synapsin");
  const auto clustered_at = [samples = run_scene(scene, {}).clusters](double t) {
    const auto last = std::ranges::upper_bound(samples, t, {}, &ClusterSample::t) - 1;
    return std::accumulate(last->sizes.begin(), last->sizes.end(), 0);
  };
  EXPECT_EQ(clustered_at(0), 0);
  EXPECT_EQ(clustered_at(42), 37);  // as action_potential.hpp says
  EXPECT_EQ(clustered_at(54), 0);
  EXPECT_EQ(clustered_at(60), 0);
  EXPECT_EQ(clustered_at(120), 27);
}

TEST(Builders, GasHasItsDensity) {
  for (const int particles : {10, 256, 1000}) {
    for (const double density : {0.01, 0.1, 0.3}) {
      const Scene scene = build_gas({.particles = particles, .density = density});
      EXPECT_EQ(static_cast<int>(scene.particles.size()), particles + 1);
      const double radius = scene.species[0].radius;
      const double found = particles / (4 * std::numbers::pi / 3 * radius * radius * radius);
      EXPECT_LE(found, density * (1 + 1e-12));                // radius³ is compared after three roundings
      EXPECT_GE(found, density * (1 - 3 * 0x1p-9 / radius));  // two steps of 1/1024 in the radius
    }
  }
}

TEST(Builders, ThreeBodyIsExactInBinary) {
  const Scene scene = built("three-body");
  EXPECT_EQ(scene.particles[1].position[0] - scene.particles[0].position[0], 0.75 + 1);  // contact at t = 1
  EXPECT_EQ(scene.particles[2].position[0] - scene.particles[1].position[0], 0.75 + 0x1p-6);
  EXPECT_TRUE(std::isinf(scene.duration));
  EXPECT_EQ(built("galperin", {{"digits", "4"}}).species[2].mass, 1e8);
  EXPECT_EQ(built("galperin", {{"digits", "10"}}).species[2].mass, 1e20);
}

TEST(Builders, SheetHasTheTethersOfAHexagonalNetwork) {
  for (const int rows : {1, 2, 5}) {
    for (const int columns : {1, 2, 5}) {
      const Scene scene =
          built("sheet", {{"rows", std::to_string(rows)}, {"columns", std::to_string(columns)}});
      // columns - 1 a row; between two rows two a particle, but for one at an end.
      EXPECT_EQ(static_cast<int>(scene.tethers.size()),
                rows * (columns - 1) + (rows - 1) * (2 * columns - 1));
      for (const Tether& tether : scene.tethers) {
        const auto& a = scene.particles[static_cast<std::size_t>(tether.i)].position;
        const auto& b = scene.particles[static_cast<std::size_t>(tether.j)].position;
        EXPECT_NEAR(std::hypot(a[0] - b[0], a[1] - b[1]), 1.2, 1e-14);  // few ulps of coordinates up to 6
      }
    }
  }
}

}  // namespace
}  // namespace tps

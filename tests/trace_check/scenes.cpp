#include "tests/trace_check/scenes.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>

#include "reference/scene/read_scene.hpp"
#include "tests/run/traced_run.hpp"
#include "verify/certified/exact_timing.hpp"
#include "verify/scenes/gas.hpp"
#include "verify/scenes/two_anchors.hpp"

namespace tps::mutation {
namespace {

using testing::add_particle;
using testing::add_species;
using testing::block;
using testing::plain_scene;
using testing::tether;

/// A gas in its membrane, whose second half is of another species, three times as heavy, that tethers to the
/// first.
Scene sticky_gas(FormRule form, BreakRule breaks, std::optional<int> capacity) {
  Scene scene = build_gas({.particles = 24, .density = .35, .restitution = .9, .duration = 100, .seed = 5});
  const auto sphere =
      static_cast<int>(std::ranges::find(scene.species, "sphere", &Species::name) - scene.species.begin());
  Species heavy = scene.species[static_cast<std::size_t>(sphere)];
  heavy.name = "heavy";
  heavy.mass = 3;
  heavy.max_tethers = capacity;
  scene.species.push_back(heavy);
  const int other = static_cast<int>(scene.species.size()) - 1;
  const PairLaw walled = scene.pairs.front();
  scene.pairs.push_back(walled);
  (walled.species_a == sphere ? scene.pairs.back().species_a : scene.pairs.back().species_b) = other;
  block(scene, other, other, .9);
  block(scene, sphere, other, .9);
  TetheringLaw law{.distance = 1.5,
                   .c_retract = .8,
                   .c_revolve = .7,
                   .theta_revolve_deg = 40,
                   .form = form,
                   .breaks = breaks};
  scene.pairs.back().tethering = law;
  for (std::size_t n = scene.particles.size() / 2; n < scene.particles.size(); ++n)
    scene.particles[n].species = other;
  for (PairLaw& pair : scene.pairs) {
    if (pair.species_a > pair.species_b) std::swap(pair.species_a, pair.species_b);
  }
  return scene;
}

Scene crowded() {
  return sticky_gas({.when = FormRule::When::always}, {}, 1);
}

Scene dicing() {
  return sticky_gas({.when = FormRule::When::probability, .probability = .5},
                    {.when = BreakRule::When::probability, .probability = .25}, {});
}

Scene tearing() {
  return sticky_gas({.when = FormRule::When::always},
                    {.when = BreakRule::When::impulse_above, .threshold = 2}, {});
}

/// Phases begin and end, impulses come, and the clock starts at 2^40.
Scene planned() {
  Scene scene = sticky_gas({.when = FormRule::When::always}, {}, {});
  scene.start_time = 0x1p40;
  const PairLaw& sticky = scene.pairs.back();
  for (const double from : {.25, .75, 1.25}) {
    scene.phases.push_back({.from = from,
                            .until = from + .25,
                            .species_a = sticky.species_a,
                            .species_b = sticky.species_b,
                            .form = FormRule{.when = FormRule::When::never, .probability = 1},
                            .breaks = BreakRule{.when = BreakRule::When::always}});
    scene.impulses.push_back({.at = from + .125, .particle = 20, .impulse = {4, -2, 1}});
  }
  return scene;
}

/// Bodies in a membrane: grounded ones, several at a time, pushed ones.
Scene grouped() {
  Scene scene = sticky_gas({.when = FormRule::When::always}, {}, {});
  scene.grouping = Grouping{.02};
  scene.impulses = {{.at = .125, .particle = 3, .impulse = {1, 2, 3}},
                    {.at = .375, .particle = 20, .impulse = {4, -2, 1}}};
  return scene;
}

/// Rows in which pairs meet pairs: trees with a root and two children, parted at one instant.
Scene nested() {
  Scene scene = plain_scene(2);
  const int heavy = add_species(scene, "heavy", 2, .5);
  const int wall = add_species(scene, "wall", std::numeric_limits<double>::infinity(), .5);
  block(scene, 0, 0, .75);
  block(scene, 0, heavy, .75);
  block(scene, heavy, heavy, .75);
  block(scene, 0, wall, 1);
  block(scene, heavy, wall, 1);
  const double gap = 0x1p-6;
  for (int row = 0; row < 3; ++row) {
    const double y = 3. * row + row * gap;
    const double push = 1 + .25 * row;
    add_particle(scene, 0, {-1 - gap, y, 0}, {push, 0, 0});
    add_particle(scene, heavy, {0, y + gap, 0}, {0, 0, 0});
    add_particle(scene, heavy, {1.0625, y, 0}, {-.25, 0, 0});
    add_particle(scene, 0, {2.0625 + 2 * gap, y, 0}, {-push - .25, 0, 0});
    add_particle(scene, wall, {-4, y, 0}, {0, 0, 0});
    add_particle(scene, wall, {5, y, 0}, {0, 0, 0});
  }
  scene.grouping = Grouping{.25};
  scene.duration = 60;
  return scene;
}

/// The same pair four times over, far apart: everything happens four times at one instant.
Scene abreast() {
  Scene scene = plain_scene(2);
  const int light = add_species(scene, "light", .25, .5);
  block(scene, 0, light, .5);
  tether(scene, 0, light, 1.75, .5, FormRule::When::always).tethering->c_revolve = .5;
  for (int n = 0; n < 4; ++n) {
    add_particle(scene, 0, {0, 16. * n, 0}, {1, 0, 0});
    add_particle(scene, light, {3, 16. * n + .25, 0}, {-1, .125, 0});
  }
  scene.duration = 40;
  return scene;
}

Scene stalled() {
  return build_two_anchors({});
}

const std::map<std::string, std::function<Scene()>>& made() {
  static const std::map<std::string, std::function<Scene()>> scenes = {
      {"abreast", abreast}, {"crowded", crowded}, {"dicing", dicing},   {"grouped", grouped},
      {"nested", nested},   {"planned", planned}, {"stalled", stalled}, {"tearing", tearing}};
  return scenes;
}

std::uint64_t cut(const std::string& name) {
  if (name == "stalled") return 20'000;  // it stalls at 10 004
  if (name == "gas" || name == "terminal" || name.starts_with("sheet")) return 100;
  return 200;
}

}  // namespace

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(TPS_SOURCE_DIR "/data/scenes")) {
    // With drag the clock is another one; lies about it are told in drag_check_test.cpp. The text tells:
    // every process that runs one of these tests asks for all the names.
    const bool has_drag = testing::read_bytes(file.path().string()).find("\"drag\"") != std::string::npos;
    if (!has_drag) names.push_back(file.path().stem().string());
  }
  for (const auto& [name, scene] : made()) names.push_back(name);
  std::ranges::sort(names);
  return names;
}

NamedScene scene_named(const std::string& name) {
  const auto own = made().find(name);
  return {
      name,
      own != made().end() ? own->second() : read_scene_file(TPS_SOURCE_DIR "/data/scenes/" + name + ".json"),
      cut(name), stands_still(name)};
}

bool stands_still(const std::string& name) {
  return name == "stalled";
}

Scene long_gas() {
  return build_gas({.particles = 60, .density = .3, .restitution = 1, .duration = 1e6, .seed = 3});
}

std::string trace_bytes(const Scene& scene, const std::string& scalar, Timing timing, std::uint64_t events,
                        std::uint64_t state_every) {
  certified::ExactTiming certifier;
  RunOptions options = testing::options_for(scalar, events);
  options.timing = timing;
  options.certifier = &certifier;
  options.state_every = state_every;
  return testing::traced_bytes(scene, options);
}

}  // namespace tps::mutation

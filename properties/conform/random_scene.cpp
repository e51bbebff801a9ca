#include "properties/conform/random_scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "properties/runs/scenes.hpp"
#include "reference/run/run.hpp"
#include "reference/text/input_error.hpp"

namespace tps::properties::conform {
namespace {

using runs::Wanted;

struct Feature {
  FeatureFacts facts;
  void (*apply)(Wanted&);
};

const std::vector<Feature>& features() {
  static const std::vector<Feature> all{
      {{"2d", "scenes of the plane alone"}, [](Wanted& w) { w.dimension = 2; }},
      {{"3d", "scenes of space alone"}, [](Wanted& w) { w.dimension = 3; }},
      {{"groups", "nearly simultaneous collisions grouped in every scene"},
       [](Wanted& w) { w.grouping = Wanted::Choice::always; }},
      {{"no-groups", "no grouping"}, [](Wanted& w) { w.grouping = Wanted::Choice::never; }},
      {{"no-draws", "no rule decides with a probability"}, [](Wanted& w) { w.draws = false; }},
      {{"no-phases", "rules do not change in time"}, [](Wanted& w) { w.phases = false; }},
      {{"no-impulses", "nothing is pushed from outside"}, [](Wanted& w) { w.impulses = false; }},
      {{"no-tethers", "no tethers, and no enclosures, which are tethers"},
       [](Wanted& w) { w.tethers = false; }},
      {{"no-tether-changes", "tethers neither form nor break"},
       [](Wanted& w) { w.changing_tethers = false; }},
      {{"no-infinite-masses", "neither walls nor enclosures"}, [](Wanted& w) { w.infinite_masses = false; }},
      {{"no-losses", "coefficients are 1"}, [](Wanted& w) { w.dissipation = false; }},
      {{"no-ties", "no starts at limits, nothing simultaneous"}, [](Wanted& w) { w.ties = false; }},
  };
  return all;
}

const Feature* find(const std::string& word) {
  for (const Feature& feature : features()) {
    if (feature.facts.name == word) return &feature;
  }
  return nullptr;
}

/// RapidCheck's size: the generators do not depend on it.
constexpr int kSize = 100;
constexpr std::uint64_t kMostEvents = 100;

RunSummary first_events(const Scene& scene, std::uint64_t count) {
  RunOptions options;
  options.max_events = count;
  return run_scene(scene, options);
}

/// The scene, so short that it has no more events than that; nothing where events do not end.
std::optional<Scene> shortened(Scene scene) {
  const RunSummary run = first_events(scene, kMostEvents + 1);
  if (run.end == "duration" || run.end == "no_more_events") return scene;
  if (run.end != "max_events") return std::nullopt;
  // Behind an event that another one follows at a later time, and as far from both.
  for (std::uint64_t events = kMostEvents; events >= 10; events /= 2) {
    const double before = first_events(scene, events).t, behind = first_events(scene, events + 1).t;
    const double between = before + (behind - before) / 2;
    if (!(before < between && between < behind)) continue;
    scene.duration = between;
    return scene;
  }
  return std::nullopt;
}

}  // namespace

const std::vector<FeatureFacts>& scene_features() {
  static const std::vector<FeatureFacts> facts = [] {
    std::vector<FeatureFacts> all;
    for (const Feature& feature : features()) all.push_back(feature.facts);
    return all;
  }();
  return facts;
}

void check_features(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (find(word) != nullptr) continue;
    std::vector<std::string> names;
    for (const FeatureFacts& facts : scene_features()) names.push_back(facts.name);
    throw std::invalid_argument(
        fmt::format("{} is no feature of scenes; there are {}", word, fmt::join(names, ", ")));
  }
}

std::optional<Scene> random_scene(const std::vector<std::string>& features, std::uint64_t seed,
                                  std::uint64_t number) {
  Wanted wanted;
  for (const std::string& word : features) find(word)->apply(wanted);
  const rc::Random stream(rc::Random::Key{seed, number, 0x7363656e65U, 0});
  Scene scene = runs::small_scene(wanted)(stream, kSize).value().scene;
  scene.title = fmt::format("random scene {} of seed {}", number, seed);
  try {
    return shortened(std::move(scene));
  } catch (const InputError&) {
    return std::nullopt;  // not in the range of double
  }
}

}  // namespace tps::properties::conform

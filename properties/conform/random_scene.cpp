#include "properties/conform/random_scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "properties/conform/inquiry.hpp"
#include "properties/conform/scene_variations.hpp"
#include "properties/runs/contact_scenes.hpp"
#include "reference/run/run.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/plain_json.hpp"
#include "verify/certified/exact_timing.hpp"

namespace tps::properties::conform {
namespace {

constexpr const char* kContacts = "contacts";
/// One scene of so many has ids, distances and tethers that the generator of run laws gives none: what is no
/// matter to the physics, but to who reads a scene.
constexpr std::uint64_t kToldOtherwise = 5;
/// Ends the titles of scenes whose text leaves out what has a default.
constexpr const char* kTerse = ", defaults left out";
/// Words of which no scene has the first and one of the others.
struct Exclusion {
  const char* word;
  std::vector<std::string> others;
  const char* why;
};

std::vector<std::string> without_contacts() {
  std::vector<std::string> words = effect_words();
  words.insert(words.end(), {"groups", "no-ties"});
  return words;
}

const std::vector<Exclusion>& exclusions() {
  constexpr const char* kGiveOne = "give one";
  static const std::vector<Exclusion> all{
      {"2d", {"3d"}, kGiveOne},
      {"groups", {"no-groups"}, kGiveOne},
      {"gravity", {"no-gravity"}, kGiveOne},
      {"groups",
       {"thermostat", "drag", "friction", "walls", "block", "periodic"},
       "beside that nothing is grouped (docs/effects.md)"},
      {kContacts, without_contacts(), "scenes of contacts have neither groups nor anything but ties"},
  };
  return all;
}

struct Feature {
  FeatureFacts facts;
  void (*apply)(Wishes&);
};

template <runs::Outlook effect>
void call_for(Wishes& wishes) {
  wishes.outlook.push_back(effect);
}

const std::vector<Feature>& features() {
  static const std::vector<Feature> all{
      {{"2d", "scenes of the plane alone"}, [](Wishes& w) { w.dimension = 2; }},
      {{"3d", "scenes of space alone"}, [](Wishes& w) { w.dimension = 3; }},
      {{"groups", "nearly simultaneous collisions grouped in every scene"},
       [](Wishes& w) { w.grouping = Wishes::Choice::always; }},
      {{"no-groups", "no grouping"}, [](Wishes& w) { w.grouping = Wishes::Choice::never; }},
      {{"no-draws", "no rule decides with a probability"}, [](Wishes& w) { w.draws = false; }},
      {{"no-phases", "rules do not change in time"}, [](Wishes& w) { w.phases = false; }},
      {{"no-impulses", "nothing is pushed from outside"}, [](Wishes& w) { w.impulses = false; }},
      {{"no-tethers", "no tethers, and no enclosures, which are tethers"},
       [](Wishes& w) { w.tethers = false; }},
      {{"no-tether-changes", "tethers neither form nor break"},
       [](Wishes& w) { w.changing_tethers = false; }},
      {{"no-infinite-masses", "neither walls nor enclosures"}, [](Wishes& w) { w.infinite_masses = false; }},
      {{"no-losses", "coefficients are 1"}, [](Wishes& w) { w.dissipation = false; }},
      {{"no-ties", "no starts at limits, nothing simultaneous"}, [](Wishes& w) { w.ties = false; }},
      {{"no-start-time", "the clock starts at 0"}, [](Wishes& w) { w.start_time = false; }},
      {{"no-gravity", "nothing falls between walls either"}, [](Wishes& w) { w.gravity = false; }},
      {{"gravity", "it falls"}, call_for<runs::Outlook::gravity>},
      {{"random-impulses", "particles are pushed at random times"}, call_for<runs::Outlook::random_impulses>},
      {{"thermostat", "particles get velocities of a temperature at random times"},
       call_for<runs::Outlook::thermostat>},
      {{"drag", "velocities decay"}, call_for<runs::Outlook::drag>},
      {{"friction", "rough particles, which spin"}, call_for<runs::Outlook::friction>},
      {{"walls", "a box around everybody, and a sphere that they are outside of"},
       call_for<runs::Outlook::walls>},
      {{"block", "a box around everybody, and a box that they are outside of"},
       call_for<runs::Outlook::block>},
      {{"periodic", "a periodic box"}, call_for<runs::Outlook::box>},
      {{kContacts, "pairs that touch and move across, and nothing else"},
       [](Wishes& w) { w.contacts = true; }},
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

/// Whether a run ends by itself and until then. At a tie or a threshold one right program turns another way
/// than the next, and goes on for ever: so as stable, certified and float runs go.
bool ends_by_itself(const Scene& endless, double until) {
  certified::ExactTiming certifier;
  const auto ends = [&](ScalarKind scalar, Timing timing) {
    RunOptions options;
    options.max_events = kMostEvents + 1;
    options.scalar = scalar;
    options.timing = timing;
    options.certifier = &certifier;
    try {
      const RunSummary run = run_scene(endless, options);
      return run.end == "no_more_events" && run.t <= until;
    } catch (const InputError&) {
      return false;  // no scene in that scalar
    }
  };
  return ends(ScalarKind::double_, Timing::stable) && ends(ScalarKind::double_, Timing::certified) &&
         ends(ScalarKind::float_, Timing::stable);
}

/// Without a duration, where the run ends by itself and soon: what is far away is known by few digits.
Scene without_duration(Scene scene) {
  constexpr double kSoon = 100;
  Scene endless = scene;
  endless.duration = std::numeric_limits<double>::infinity();
  return ends_by_itself(endless, kSoon * scene.duration) ? endless : scene;
}

/// The scene, so short that it has no more events than that; nothing where events do not end.
std::optional<Scene> shortened(Scene scene) {
  const RunSummary run = first_events(scene, kMostEvents + 1);
  if (run.end == "duration") return run.events > 0 ? without_duration(std::move(scene)) : scene;
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

/// The effects of the outlook in turn, each with some of the others.
rc::Gen<runs::SmallScene> plain_scene(const Wishes& wanted, std::uint64_t number) {
  if (wanted.contacts) return runs::touching_pairs(wanted.dimension);
  if (wanted.outlook.empty()) return runs::small_scene(wanted);
  return runs::outlook_scene(wanted.outlook[number % wanted.outlook.size()], wanted, wanted.outlook);
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
  for (const Exclusion& exclusion : exclusions()) {
    for (const std::string& other : exclusion.others) {
      if (has(words, exclusion.word) && has(words, other)) {
        throw std::invalid_argument(
            fmt::format("{} and {} exclude each other: {}", exclusion.word, other, exclusion.why));
      }
    }
  }
}

bool calls_for_effect(const std::string& word) {
  Wishes wishes;
  find(word)->apply(wishes);
  return !wishes.outlook.empty();
}

std::vector<std::string> effect_words() {
  std::vector<std::string> words;
  for (const FeatureFacts& facts : scene_features()) {
    if (calls_for_effect(facts.name)) words.push_back(facts.name);
  }
  return words;
}

std::string text_of_random(const Scene& scene, SceneStyle style) {
  const std::string text = write_scene(scene, style);
  if (!scene.title.ends_with(kTerse)) return text;
  Json json = Json::parse(text);
  for (std::size_t n = 0; n < scene.particles.size(); ++n) {
    if (scene.particles[n].velocity == Coordinates{}) json["particles"][n].erase("velocity");
  }
  for (std::size_t n = 0; n < scene.pairs.size(); ++n) {
    const PairLaw& law = scene.pairs[n];
    const double R_a = scene.species[static_cast<std::size_t>(law.species_a)].radius;
    const double R_b = scene.species[static_cast<std::size_t>(law.species_b)].radius;
    if (law.blocking && law.blocking->distance == R_a + R_b) json["pairs"][n]["blocking"].erase("distance");
    if (!law.tethering) continue;
    Json& tethering = json["pairs"][n]["tethering"];
    if (tethering["form"] == "always") tethering.erase("form");
    if (tethering["break"] == "never") tethering.erase("break");
  }
  return json_text(json) + (style == SceneStyle::compact ? "" : "\n");
}

std::optional<Scene> random_scene(const std::vector<std::string>& features, std::uint64_t seed,
                                  std::uint64_t number) {
  Wishes wanted;
  for (const std::string& word : features) find(word)->apply(wanted);
  const rc::Random stream(rc::Random::Key{seed, number, 0x7363656e65U, 0});
  rc::Random choices(rc::Random::Key{seed, number, 0x76617279U, 0});
  Scene scene = plain_scene(wanted, number)(stream, kSize).value().scene;
  const bool otherwise = number % kToldOtherwise == 1;
  rc::Random others(rc::Random::Key{seed, number, 0x6f74686572U, 0});
  scene.title = fmt::format("random scene {} of seed {}{}", number, seed,
                            otherwise && once_in(2, others) ? kTerse : "");
  try {
    scene = with_start_time(untethered(std::move(scene), wanted, choices), wanted, choices);
    if (otherwise && !wanted.contacts) scene = with_other_limits(std::move(scene), wanted, others);
    scene = with_near_threshold(std::move(scene), wanted, choices);
    if (otherwise) scene = with_other_ids(std::move(scene), others);
    return shortened(std::move(scene));
  } catch (const InputError&) {
    return std::nullopt;  // not in the range of double
  }
}

}  // namespace tps::properties::conform

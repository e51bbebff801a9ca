#include "properties/conform/feature_hint.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "properties/conform/inquiry.hpp"

namespace tps::properties::conform {
namespace {

bool draws(const FormRule& rule) {
  return rule.when == FormRule::When::probability;
}
bool draws(const BreakRule& rule) {
  return rule.when == BreakRule::When::probability;
}

bool has_draws(const Scene& scene) {
  return std::any_of(scene.pairs.begin(), scene.pairs.end(),
                     [](const PairLaw& law) {
                       return law.tethering && (draws(law.tethering->form) || draws(law.tethering->breaks));
                     }) ||
         std::any_of(scene.phases.begin(), scene.phases.end(), [](const Phase& phase) {
           return (phase.form && draws(*phase.form)) || (phase.breaks && draws(*phase.breaks));
         });
}

/// What a simulator may well not have.
struct Thing {
  const char *word, *name;
  bool (*is_in)(const Scene&);
};

constexpr std::array<Thing, 6> kThings{{
    {"no-groups", "grouping", [](const Scene& s) { return s.grouping.has_value(); }},
    {"no-phases", "phases", [](const Scene& s) { return !s.phases.empty(); }},
    {"no-impulses", "impulses from outside", [](const Scene& s) { return !s.impulses.empty(); }},
    {"no-draws", "rules that decide with a probability", has_draws},
    {"no-gravity", "gravity", [](const Scene& s) { return s.gravity.has_value(); }},
    {"no-start-time", "a start_time", [](const Scene& s) { return s.start_time != 0; }},
}};

}  // namespace

void FeatureHint::add(const Scene& scene, bool fails) {
  Asked asked{{}, fails};
  for (const Thing& thing : kThings) asked.has.push_back(thing.is_in(scene));
  scenes_.push_back(std::move(asked));
}

std::optional<std::string> FeatureHint::words() const {
  std::vector<const Asked*> failing;
  for (const Asked& each : scenes_) {
    if (each.fails) failing.push_back(&each);
  }
  std::vector<std::size_t> lacks;
  while (!failing.empty()) {
    std::array<std::ptrdiff_t, kThings.size()> explained{};
    for (std::size_t n = 0; n < kThings.size(); ++n) {
      if (!has(features_, kThings[n].word))
        explained[n] =
            std::count_if(failing.begin(), failing.end(), [n](const Asked* s) { return s->has[n]; });
    }
    const auto most = std::max_element(explained.begin(), explained.end());
    if (*most == 0) return std::nullopt;
    lacks.push_back(static_cast<std::size_t>(most - explained.begin()));
    std::erase_if(failing, [&](const Asked* s) { return s->has[lacks.back()]; });
  }
  const bool passes = std::any_of(scenes_.begin(), scenes_.end(), [&](const Asked& s) {
    return std::none_of(lacks.begin(), lacks.end(), [&](std::size_t n) { return s.has[n]; });
  });
  if (lacks.empty() || !passes) return std::nullopt;
  std::vector<std::string> names, words;
  for (const std::size_t n : lacks) {
    names.emplace_back(kThings[n].name);
    words.emplace_back(kThings[n].word);
  }
  return fmt::format("every scene that fails has {}; a simulator without that is asked with --features {}",
                     fmt::join(names, " or "), fmt::join(words, ","));
}

}  // namespace tps::properties::conform

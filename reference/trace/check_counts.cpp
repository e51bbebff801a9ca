#include "reference/trace/check_counts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "reference/trace/exact_text.hpp"

namespace tps {
namespace {

template <typename Range, typename Calls>
bool any(const Range& range, Calls calls) {
  return std::any_of(range.begin(), range.end(), calls);
}

/// What the effects that a scene calls for keep in a state for the summary.
std::vector<std::string> quantities_of_effects(const Scene& scene) {
  std::vector<std::string> names;
  if (scene.drag) names = {"drag_lost", "drag_taken", "drag_since"};
  if (scene.gravity) names.emplace_back("gravity_work");
  if (!scene.walls.empty()) names.insert(names.end(), {"walls_lost", "walls_work"});
  if (any(scene.species, [](const Species& s) { return s.random_impulses.has_value(); }))
    names.emplace_back("random_impulses_heat");
  if (any(scene.species, [](const Species& s) { return s.thermostat.has_value(); }))
    names.emplace_back("thermostat_heat");
  if (any(scene.pairs, [](const PairLaw& law) { return law.friction.has_value(); }))
    names.emplace_back("friction_lost");
  return names;
}

class CountCheck {
 public:
  CountCheck(const Scene& scene, const StateData& state, StateOf whose)
      : scene_(scene), state_(state), whose_(whose) {}

  std::vector<StateProblem> run() {
    check_progress();
    check_counts();
    check_quantities();
    check_observations();
    return std::move(problems_);
  }

 private:
  void demand(bool holds, const std::string& pointer, const std::string& message) {
    if (!holds && problems_.size() < kMostStateProblems) problems_.push_back({pointer, message});
  }

  void check_progress() {
    for (const auto& [effect, done] : state_.progress) {
      const std::string pointer = "/progress/" + effect;
      if (effect == "phases") {
        const auto ending = std::count_if(scene_.phases.begin(), scene_.phases.end(),
                                          [](const Phase& phase) { return std::isfinite(phase.until); });
        demand(done <= scene_.phases.size() + static_cast<std::size_t>(ending), pointer,
               "is more than the phases of the scene begin and end");
      } else if (effect == "scheduled_impulses") {
        demand(done <= scene_.impulses.size(), pointer, "is more than the impulses of the scene");
      } else if (effect == "gravity") {
        demand(scene_.gravity.has_value() && done <= state_.k, pointer, "is more than the events of the run");
      } else {
        demand(false, pointer, "is no effect with events known in advance");
      }
    }
  }

  void check_counts() {
    static const std::set<std::string, std::less<>> kinds = {
        "rebound",        "retract",    "revolve", "break",       "restitute", "scheduled_impulse",
        "random_impulse", "thermostat", "gravity", "phase_begin", "phase_end", "wall"};
    static const std::vector<std::string> counters = {"#noise", "#first_noise", "#zero_impulse",
                                                      "#largest_group"};
    std::uint64_t events = 0;
    for (const auto& [name, count] : state_.counts) {
      const bool is_counter = std::find(counters.begin(), counters.end(), name) != counters.end();
      demand(is_counter || kinds.contains(name), "/counts/" + name, "is nothing that a run counts");
      demand(count <= state_.k || name == "#largest_group", "/counts/" + name, "is more than all events");
      if (!is_counter && count <= state_.k) events += count;
    }
    if (whose_ == StateOf::our_run) {
      for (const std::string& name : counters)
        demand(state_.counts.contains(name), "/counts", fmt::format("lacks \"{}\"", name));
    }
    demand(events == state_.k, "/counts",
           fmt::format("adds up to {} events; there were {}", events, state_.k));
    const auto largest = state_.counts.find("#largest_group");
    demand(largest == state_.counts.end() || largest->second <= scene_.particles.size(),
           "/counts/#largest_group", "is more than all particles");
  }

  void check_quantities() {
    const auto dimension = static_cast<std::size_t>(scene_.dimension);
    std::map<std::string, std::size_t> sizes{{"momentum_at_start", dimension}};
    for (const char* name : {"kinetic_at_start", "energy_bound", "momentum_bound", "worst_inner_excess",
                             "worst_outer_excess", "oldest_group"})
      sizes[name] = 1;
    for (const char* name : {"lost", "stored", "work"}) sizes[name] = 2;
    for (std::size_t k = 0; k < dimension; ++k) {
      sizes[fmt::format("from_walls_{}", k)] = 2;
      sizes[fmt::format("from_outside_{}", k)] = 2;
    }
    for (const std::string& name : quantities_of_effects(scene_)) sizes[name] = 2;
    for (const auto& [name, numbers] : state_.quantities) {
      const auto known = sizes.find(name);
      demand(known != sizes.end(), "/quantities/" + name, "is no quantity of a run");
      demand(known == sizes.end() || known->second == numbers.size(), "/quantities/" + name,
             fmt::format("has {} numbers", numbers.size()));
    }
    if (whose_ == StateOf::any_program) return;
    for (const auto& [name, ignored] : sizes)
      demand(state_.quantities.contains(name), "/quantities", fmt::format("lacks \"{}\"", name));
  }

  void check_observations() {
    demand(state_.observations.empty() || scene_.clusters, "/observations", "the scene observes no clusters");
    for (std::size_t n = 0; n < state_.observations.size(); ++n) {
      demand(is_observation(state_.observations[n]), fmt::format("/observations/{}", n),
             "is no observation of clusters: a word, then numbers");
    }
  }

  const Scene& scene_;
  const StateData& state_;
  StateOf whose_;
  std::vector<StateProblem> problems_;
};

}  // namespace

std::vector<StateProblem> count_problems(const Scene& scene, const StateData& state, StateOf whose) {
  return CountCheck(scene, state, whose).run();
}

}  // namespace tps

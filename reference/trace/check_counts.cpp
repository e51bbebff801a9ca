#include "reference/trace/check_counts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

#include "reference/engine/effect_facts.hpp"
#include "reference/trace/exact_text.hpp"

namespace tps {
namespace {

class CountCheck {
 public:
  CountCheck(const Scene& scene, const StateData& state, StateOf whose)
      : scene_(scene), state_(state), whose_(whose), effects_(effect_facts(scene)) {}

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
    for (const auto& [name, done] : state_.progress) {
      const auto effect = std::find_if(
          effects_.begin(), effects_.end(),
          [&wanted = name](const EffectFacts& e) { return e.name == wanted && e.records.known; });
      const std::string pointer = "/progress/" + name;
      if (effect == effects_.end()) {
        demand(false, pointer, "is no effect with events known in advance");
      } else {
        const EffectRecords::Known& known = *effect->records.known;
        demand(done <= std::min(known.most, state_.k), pointer, known.too_many);
      }
    }
  }

  static bool is_kind(const std::string& name) {
    const auto& kinds = event_kinds();
    return std::any_of(kinds.begin(), kinds.end(),
                       [&](const KindOfEffect& k) { return k.kind.name == name; });
  }

  void check_counts() {
    static const std::vector<std::string> counters = {"#noise", "#first_noise", "#zero_impulse",
                                                      "#largest_group"};
    std::uint64_t events = 0;
    for (const auto& [name, count] : state_.counts) {
      const bool is_counter = std::find(counters.begin(), counters.end(), name) != counters.end();
      demand(is_counter || is_kind(name), "/counts/" + name, "is nothing that a run counts");
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
    for (const EffectFacts& effect : effects_) {
      if (!effect.called) continue;
      for (const EffectRecords::Quantity& q : effect.records.quantities) sizes[q.name] = q.size;
    }
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
  std::vector<EffectFacts> effects_;
  std::vector<StateProblem> problems_;
};

}  // namespace

std::vector<StateProblem> count_problems(const Scene& scene, const StateData& state, StateOf whose) {
  return CountCheck(scene, state, whose).run();
}

}  // namespace tps

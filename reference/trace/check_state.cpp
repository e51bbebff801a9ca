#include "reference/trace/check_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <tuple>
#include <unordered_map>

#include "reference/engine/effect_facts.hpp"
#include "reference/scene/random.hpp"
#include "reference/trace/check_counts.hpp"
#include "reference/trace/check_group.hpp"
#include "reference/trace/exact_text.hpp"

namespace tps {
namespace {

class StateCheck {
 public:
  StateCheck(const Scene& scene, const StateData& state, int digits, StateOf whose)
      : scene_(scene), state_(state), digits_(digits), whose_(whose) {
    for (std::size_t n = 0; n < scene.particles.size(); ++n)
      index_of_.emplace(scene.particles[n].id, static_cast<int>(n));
    for (const PairLaw& law : scene.pairs) laws_[{law.species_a, law.species_b}] = &law;
  }

  std::vector<StateProblem> run() {
    check_times();
    check_particles();
    check_tethers();
    check_responded();
    check_groups();
    check_draws();
    for (const StateProblem& problem : count_problems(scene_, state_, whose_))
      demand(false, problem.pointer, problem.message);
    return std::move(problems_);
  }

 private:
  void demand(bool holds, const std::string& pointer, const std::string& message) {
    if (!holds && problems_.size() < kMostStateProblems) problems_.push_back({pointer, message});
  }

  /// The same of one of very many places: pointer and message are put into words where something is wrong.
  template <typename Problem>
  void demand(bool holds, Problem problem) {
    if (!holds && problems_.size() < kMostStateProblems) problems_.push_back(problem());
  }

  /// The place of a particle in the scene; nothing, and a problem, for an id that it does not have.
  std::optional<int> index(std::int32_t id, const std::string& pointer) {
    const auto found = index_of_.find(id);
    demand(found != index_of_.end(), [&] {
      return StateProblem{pointer, fmt::format("names particle {}, which the scene does not have", id)};
    });
    return found == index_of_.end() ? std::nullopt : std::optional(found->second);
  }
  const Species& species(int i) const {
    return scene_.species[static_cast<std::size_t>(scene_.particles[static_cast<std::size_t>(i)].species)];
  }
  bool fixed(int i) const { return std::isinf(species(i).mass); }
  /// The law of a pair; null where it has none, or consists of two infinite masses.
  const PairLaw* law(int i, int j) const {
    if (fixed(i) && fixed(j)) return nullptr;
    const auto [a, b] = std::minmax(scene_.particles[static_cast<std::size_t>(i)].species,
                                    scene_.particles[static_cast<std::size_t>(j)].species);
    const auto found = laws_.find({a, b});
    return found == laws_.end() ? nullptr : found->second;
  }

  bool is_time(const HexTime& time) const {
    return is_normal_time(time, digits_) && is_not_after(time, state_.now);
  }
  void check_time(const HexTime& time, const std::string& pointer) {
    demand(is_normal_time(time, digits_), pointer,
           "is no time: hi is finite, not negative, and the nearest number to hi + lo");
    demand(is_not_after(time, state_.now), pointer, "is after \"now\"");
  }

  void check_times() {
    check_time(state_.now, "/now");
    check_time(state_.last_event, "/last_event");
    demand(is_not_after(state_.now, state_.last_event), "/now",
           "is behind \"last_event\"; a run's clock stands at its last event");
    if (!scene_.drag) {
      demand(state_.t.empty() || is_sum(state_.t, scene_.start_time, state_.now), "/t",
             "is not start_time + \"now\"");
    }
    demand(state_.progress_event <= state_.k, "/progress_event",
           fmt::format("is {}, but there were {} events", state_.progress_event, state_.k));
  }

  void check_particles() {
    demand(state_.particles.size() == scene_.particles.size(), "/particles",
           fmt::format("has {} entries; the scene has {} particles", state_.particles.size(),
                       scene_.particles.size()));
    for (std::size_t n = 0; n < state_.particles.size(); ++n) {
      const StateData::Particle& p = state_.particles[n];
      const auto at = [n](const char* key) { return fmt::format("/particles/{}{}", n, key); };
      const auto found = index_of_.find(p.id);
      if (found == index_of_.end()) {
        index(p.id, at("/id"));
        continue;
      }
      demand(particles_.emplace(p.id, &p).second, [&] {
        return StateProblem{at("/id"), fmt::format("particle {} stands twice", p.id)};
      });
      if (!has_dimension(p.position)) check_dimension(p.position, at("/position"));
      if (!has_dimension(p.velocity)) check_dimension(p.velocity, at("/velocity"));
      if (!is_time(p.clock)) check_time(p.clock, at("/clock"));
      const bool turns =
          keeps_spin(scene_, scene_.particles[static_cast<std::size_t>(found->second)].species);
      const std::size_t spin = turns ? (scene_.dimension == 2 ? 1U : 3U) : 0U;
      demand(p.spin.size() == spin, [&] {
        return StateProblem{at("/spin"),
                            fmt::format("has {} components; {} are needed", p.spin.size(), spin)};
      });
    }
  }
  bool has_dimension(const HexVector& x) const {
    return x.size() == static_cast<std::size_t>(scene_.dimension);
  }
  void check_dimension(const HexVector& x, const std::string& pointer) {
    demand(has_dimension(x), pointer,
           fmt::format("has {} components in {} dimensions", x.size(), scene_.dimension));
  }

  void check_tethers() {
    std::set<std::pair<int, int>> seen;
    std::unordered_map<int, int> count;
    for (std::size_t n = 0; n < state_.tethers.size(); ++n) {
      const std::string pointer = fmt::format("/tethers/{}", n);
      const auto i = index(state_.tethers[n][0], pointer);
      const auto j = index(state_.tethers[n][1], pointer);
      if (!i || !j) continue;
      const std::string pair = fmt::format("particles {} and {}", state_.tethers[n][0], state_.tethers[n][1]);
      demand(*i < *j, pointer, pair + " stand in the wrong order, or are one particle");
      demand(seen.insert({std::min(*i, *j), std::max(*i, *j)}).second, pointer, pair + " stand twice");
      const PairLaw* rules = law(*i, *j);
      demand(rules != nullptr && rules->tethering && rules->tethering->form.when != FormRule::When::permanent,
             pointer, pair + " cannot form a tether by the laws of the scene");
      for (const int particle : {*i, *j}) {
        const std::optional<int>& capacity = species(particle).max_tethers;
        const int tethers = ++count[particle];
        demand(!capacity || tethers <= *capacity, pointer,
               fmt::format("is tether number {} of particle {}, which has at most {}", tethers,
                           scene_.particles[static_cast<std::size_t>(particle)].id, capacity.value_or(0)));
      }
    }
  }

  bool has_limit(int i, int j, bool outer) const {
    const PairLaw* rules = i == j ? nullptr : law(i, j);
    return rules != nullptr && (outer ? rules->tethering.has_value() : rules->blocking.has_value());
  }

  void check_responded() {
    std::set<std::tuple<int, int, bool>> seen;
    for (std::size_t n = 0; n < state_.responded.size(); ++n) {
      const StateData::Responded& r = state_.responded[n];
      const std::string pointer = fmt::format("/responded/{}", n);
      const auto i = index(r.first, pointer);
      const auto j = index(r.second, pointer);
      if (!i || !j) continue;
      demand(has_limit(*i, *j, r.outer), pointer,
             fmt::format("particles {} and {} have no {} limit", r.first, r.second,
                         r.outer ? "outer" : "inner"));
      demand(seen.emplace(std::min(*i, *j), std::max(*i, *j), r.outer).second, pointer,
             fmt::format("particles {} and {} stand twice", r.first, r.second));
    }
  }

  void check_groups() {
    demand(state_.groups.empty() || scene_.grouping, "/groups", "the scene has no \"grouping\"");
    std::set<std::int32_t> in_a_body;
    for (std::size_t n = 0; n < state_.groups.size(); ++n) {
      const StateData::Group& group = state_.groups[n];
      const std::string pointer = fmt::format("/groups/{}", n);
      bool known = true;
      for (const std::int32_t id : group.members) {
        const auto i = index(id, pointer + "/members");
        known = known && i && !fixed(*i) && particles_.contains(id);
        demand(!i || !fixed(*i), pointer + "/members", fmt::format("particle {} has an infinite mass", id));
        demand(in_a_body.insert(id).second, pointer + "/members",
               fmt::format("particle {} is in two bodies, or twice in one", id));
      }
      for (std::size_t k = 0; k < group.nodes.size(); ++k) {
        const StateData::Node& node = group.nodes[k];
        const std::string at = fmt::format("{}/nodes/{}", pointer, k);
        const auto i = index(node.i, at);
        const auto j = index(node.j, at);
        known = known && i && j;
        if (!i || !j) continue;
        demand(has_limit(*i, *j, node.outer), at,
               fmt::format("particles {} and {} have no {} limit", node.i, node.j,
                           node.outer ? "outer" : "inner"));
        check_dimension(node.dp, at + "/dp");
      }
      if (known) check_body(group, pointer);
    }
  }

  void check_body(const StateData::Group& group, const std::string& pointer) {
    check_time(group.birth, pointer + "/birth");
    const double dt = scene_.grouping ? scene_.grouping->dt_restitute : HUGE_VAL;
    const auto late = expiry_problem(group.expiry, state_.now, dt, digits_, whose_ == StateOf::our_run);
    demand(!late, pointer + "/expiry", late.value_or(""));
    const auto mass_of = [this](std::int32_t id) { return species(index_of_.at(id)).mass; };
    if (const std::optional<GroupProblem> problem = group_problem(group, mass_of, digits_))
      demand(false, pointer + problem->pointer, problem->message);
    if (group.members.empty()) return;
    const StateData::Particle& first = *particles_.at(group.members.front());
    for (const std::int32_t id : group.members) {
      const StateData::Particle& p = *particles_.at(id);
      demand(p.velocity == first.velocity, pointer + "/members",
             fmt::format("particles {} and {} of one body have different velocities", first.id, id));
    }
  }

  void check_draws() {
    std::set<std::tuple<int, int, int>> seen;
    if (state_.draws.empty()) return;
    const std::vector<EffectFacts> effects = effect_facts(scene_);
    for (std::size_t n = 0; n < state_.draws.size(); ++n) {
      const StateData::Draws& d = state_.draws[n];
      const std::string pointer = fmt::format("/draws/{}", n);
      const auto i = index(d.first, pointer);
      const auto j = index(d.second, pointer);
      const auto is_for = [&](Purpose purpose) { return d.purpose == static_cast<int>(purpose); };
      const bool of_tethers = is_for(Purpose::tether_form) || is_for(Purpose::tether_break);
      const auto effect = std::find_if(effects.begin(), effects.end(), [&](const EffectFacts& e) {
        return e.records.draws && is_for(e.records.draws->purpose);
      });
      const bool of_effect = effect != effects.end();
      demand(of_tethers || of_effect, pointer, fmt::format("purpose {} is no purpose of a draw", d.purpose));
      if (!i || !j) continue;
      if (of_tethers)
        demand(*i < *j && has_limit(*i, *j, true), pointer,
               fmt::format("particles {} and {} draw for no tether", d.first, d.second));
      if (of_effect) {
        const bool draws =
            effect->records.draws->draws(scene_, scene_.particles[static_cast<std::size_t>(*i)]);
        demand(*i == *j && draws, pointer,
               fmt::format("particle {} gets no impulses at random times", d.first));
        demand(d.used <= state_.k, pointer,
               fmt::format("counts {} impulses; there were {} events", d.used, state_.k));
      }
      demand(seen.emplace(d.purpose, *i, *j).second, pointer, "stands twice");
    }
  }

  const Scene& scene_;
  const StateData& state_;
  int digits_;
  StateOf whose_;
  std::unordered_map<std::int32_t, int> index_of_;
  std::map<std::pair<int, int>, const PairLaw*> laws_;
  std::unordered_map<std::int32_t, const StateData::Particle*> particles_;
  std::vector<StateProblem> problems_;
};

}  // namespace

std::vector<StateProblem> state_problems(const Scene& scene, const StateData& state, int digits,
                                         StateOf whose) {
  return StateCheck(scene, state, digits, whose).run();
}

}  // namespace tps

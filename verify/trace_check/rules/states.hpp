// Rule states: a full state is what the events made.
#pragma once

#include <algorithm>

#include "reference/trace/check_state.hpp"
#include "verify/trace_check/context.hpp"
#include "verify/trace_check/rules/drag.hpp"
#include "verify/trace_check/rules/known_events.hpp"
#include "verify/trace_check/state_values.hpp"

namespace tps::check {

/// Compares a full state with the model. All is copied, nothing rounded, but masses of bodies and expiries,
/// which are sums. The counters of the summary other than events by kind, its quantities and observations are
/// not judged.
template <typename Number>
class StateJudge {
 public:
  using W = Work<Number>;

  StateJudge(const Context<Number>& c, const StateLine<Number>& line) : c_(c), model_(c.model), line_(line) {
    for (int n = 0; n < model_.size(); ++n) index_of_.emplace_back(model_.id(n), n);
  }

  /// @return whether all holds
  bool judge() {
    judge_itself();
    try {
      judge_clock();
      judge_particles();
      judge_pairs();
      judge_groups();
      judge_counts();
    } catch (const std::exception& error) {
      c_.tally.demand(Rule::states, false, [&](Finding& f) {
        f.message = fmt::format("the full state cannot be read: {}", error.what());
      });
      holds_ = false;
    }
    return holds_;
  }

 private:
  void expect(bool holds, const std::string& what, std::vector<std::int32_t> particles = {}) {
    holds_ = holds_ && holds;
    c_.tally.demand(Rule::states, holds, [&](Finding& f) {
      f.particles = std::move(particles);
      f.message = what;
    });
  }
  /// The same of one of very many particles: what to say is put into words where it is said.
  template <typename Words>
  void expect_of(std::int32_t particle, bool holds, Words words) {
    holds_ = holds_ && holds;
    c_.tally.demand(Rule::states, holds, [&](Finding& f) {
      f.particles = {particle};
      f.message = words();
    });
  }

  int index(std::int32_t id) const {
    const auto found = std::lower_bound(index_of_.begin(), index_of_.end(), std::pair(id, 0));
    if (found == index_of_.end() || found->first != id)
      throw std::runtime_error(fmt::format("it names particle {}", id));
    return found->second;
  }
  static Number number(const Hex& text) { return number_in_state<Number>(text); }
  static Instant<Number> instant(const HexTime& t) { return instant_in_state<Number>(t); }
  Vec<Number> vector(const HexVector& x) const { return vector_in_state<Number>(x, model_.scene.dimension); }
  /// Float clocks are two floats where the check has one double.
  static bool same(const Instant<Number>& a, const Instant<Number>& b) { return elapsed(a, b) == W(0); }

  /// Whether it can be a state of the scene at all, and is what was written.
  void judge_itself() {
    const StateData& s = line_.data;
    if (s.checksum == StateData::Checksum::absent) {
      c_.tally.not_judged(Rule::states,
                          "full states without a checksum are not protected: what damage did to numbers that "
                          "the events do not decide is not seen");
    } else {
      expect(s.checksum == StateData::Checksum::right,
             "the checksum of the full state is not that of its content: it was damaged or edited (an edited "
             "one may leave the checksum out)");
    }
    for (const StateProblem& problem :
         state_problems(model_.scene, s, model_.precision.digits, StateOf::any_program))
      expect(false, fmt::format("{} {}", problem.pointer, problem.message));
  }

  void judge_clock() {
    const StateData& s = line_.data;
    expect(s.k == model_.events,
           fmt::format("the state is of event {}, but stands behind event {}", s.k, model_.events));
    if (model_.scene.drag) {
      judge_drag_time(c_, Rule::states, instant(s.now), line_.time);
    } else {
      expect(same(instant(s.now), line_.t), "\"t\" is not the time \"now\"");
    }
    expect(same(instant(s.now), model_.now), "\"now\" is not the time of the event before");
    expect(same(instant(s.last_event), model_.now), "\"last_event\" is not the time of the event before");
    expect(s.progress_event == model_.progress_event,
           fmt::format("the clock last moved at event {}, not {}", model_.progress_event, s.progress_event));
  }

  void judge_particles() {
    const StateData& s = line_.data;
    expect(
        s.particles.size() == model_.flights.size(),
        fmt::format("the state has {} particles, the scene {}", s.particles.size(), model_.flights.size()));
    std::vector<bool> seen(model_.flights.size(), false);
    for (const StateData::Particle& p : s.particles) {
      const int n = index(p.id);
      expect_of(p.id, !seen[Model<Number>::at(n)],
                [&] { return fmt::format("particle {} stands twice in the state", p.id); });
      seen[Model<Number>::at(n)] = true;
      const Flight<Number>& flight = model_.flight(n);
      const Vec<Number> velocity = vector(p.velocity);
      expect_of(p.id, velocity == flight.velocity, [&] {
        return fmt::format("particle {} has velocity {}, but left its last event with {}", p.id,
                           shown(velocity, model_.scene.dimension),
                           shown(flight.velocity, model_.scene.dimension));
      });
      const Vec<Number> position = vector(p.position);
      expect_of(p.id, largest(widened<W>(position) - widened<W>(flight.position)) <= flight.blur, [&] {
        return fmt::format("particle {} is at {}, but was at {} at its last event", p.id,
                           shown(position, model_.scene.dimension),
                           shown(flight.position, model_.scene.dimension));
      });
      if (model_.keeps_spin(n)) {
        const Vec<Number> spin = spin_in_state<Number>(p.spin);
        expect_of(p.id, spin == model_.spins[Model<Number>::at(n)], [&] {
          return fmt::format("particle {} has a spin that it did not leave its last event with", p.id);
        });
      }
      expect_of(p.id, same(instant(p.clock), flight.since),
                [&] { return fmt::format("the clock of particle {} is not its last event's", p.id); });
    }
  }

  void judge_pairs() {
    const StateData& s = line_.data;
    std::set<std::array<std::int32_t, 2>> tethers;
    std::set<std::tuple<std::int32_t, std::int32_t, bool>> responded;
    for (int i = 0; i < model_.size(); ++i) {
      for (const int j : model_.tethers[static_cast<std::size_t>(i)]) {
        if (i < j) tethers.insert({model_.id(i), model_.id(j)});
      }
      for (const auto& [response, speeds] : model_.responses(i)) {
        const auto& [j, outer] = response;
        if (model_.responded(i, j, outer))
          responded.insert({model_.id(std::min(i, j)), model_.id(std::max(i, j)), outer});
      }
    }
    expect(s.tethers.size() == tethers.size() &&
               std::set<std::array<std::int32_t, 2>>(s.tethers.begin(), s.tethers.end()) == tethers,
           fmt::format("the state has {} tethers, which are not the {} that the events left",
                       s.tethers.size(), tethers.size()));
    std::set<std::tuple<std::int32_t, std::int32_t, bool>> stated;
    for (const StateData::Responded& r : s.responded) {
      stated.insert({std::min(r.first, r.second), std::max(r.first, r.second), r.outer});
    }
    expect(
        s.responded.size() == responded.size() && stated == responded,
        fmt::format("the state lists {} pairs that have responded, which are not the {} that the events left",
                    stated.size(), responded.size()));
  }

  void judge_groups() {
    const StateData& s = line_.data;
    const std::vector<const Body<Number>*> bodies = model_.groups.bodies();
    expect(s.groups.size() == bodies.size(),
           fmt::format("the state has {} bodies, the events left {}", s.groups.size(), bodies.size()));
    for (std::size_t n = 0; n < std::min(bodies.size(), s.groups.size()); ++n)
      judge_group(s.groups[n], *bodies[n]);
  }

  void judge_group(const StateData::Group& group, const Body<Number>& body) {
    std::vector<std::int32_t> members;
    for (const int member : body.members) members.push_back(model_.id(member));
    expect(group.members == members,
           fmt::format("the members of the body of particle {} differ", members.front()), members);
    const Number mass = number(group.mass);
    using std::abs;
    const bool same_mass = is_mass(mass, body.inverse_mass, body.loads);
    expect(same_mass,
           fmt::format("the mass of the body of particle {} is not that of its members", members.front()),
           members);
    const Instant<Number> expiry = body.expiry;
    expect(abs(elapsed(expiry, instant(group.expiry))) <= c_.time_error(expiry),
           fmt::format("the body of particle {} expires at another time", members.front()), members);
    expect(same(instant(group.birth), body.birth),
           fmt::format("the body of particle {} is of another age", members.front()), members);
    expect(group.nodes.size() == static_cast<std::size_t>(body.loads),
           fmt::format("the body of particle {} has {} loads, not {}", members.front(), body.loads,
                       group.nodes.size()),
           members);
    expect(is_tree(group, *body.root),
           fmt::format("the loads of the body of particle {} are not those of the events", members.front()),
           members);
  }

  /// Each of at most `sums` masses of a body was added rounded.
  bool is_mass(const Number& mass, const W& inverse_mass, int sums) const {
    using std::abs;
    if (inverse_mass == W(0)) return !(mass - mass == Number(0));
    return abs(W(mass) * inverse_mass - W(1)) <= W(2 * sums + 2) * c_.u() * c_.scale();
  }

  /// Whether the nodes of a state are the loads below a root, each side where it was.
  bool is_tree(const StateData::Group& group, const LoadNode<Number>& root) const {
    std::vector<std::pair<std::size_t, const LoadNode<Number>*>> open = {{0, &root}};
    while (!open.empty()) {
      const auto [n, load] = open.back();
      open.pop_back();
      const StateData::Node& node = group.nodes.at(n);
      if (node.i != model_.id(load->i) || node.j != model_.id(load->j) || node.outer != load->outer)
        return false;
      if (!(vector(node.dp) == load->dp)) return false;
      for (std::size_t side = 0; side < 2; ++side) {
        if (!is_mass(number(node.masses[side]), load->inverse_mass[side], model_.size())) return false;
      }
      for (std::size_t side = 0; side < 2; ++side) {
        const StateData::Side& stated = node.sides[side];
        const LoadNode<Number>* below = load->below[side].get();
        std::optional<std::int32_t> particle;
        if (below == nullptr && !load->members[side].empty())
          particle = model_.id(load->members[side].front());
        if (stated.node.has_value() != (below != nullptr) || stated.particle != particle) return false;
        if (below != nullptr) open.emplace_back(static_cast<std::size_t>(*stated.node), below);
      }
    }
    return true;
  }

  void judge_counts() {
    const StateData& s = line_.data;
    std::map<std::string, std::uint64_t> stated, counted;
    for (const auto& [kind, count] : s.counts) {
      if (!kind.starts_with('#') && count > 0) stated[kind] = count;
    }
    for (const KindRow& known : kinds()) {
      const std::uint64_t count = model_.kinds[static_cast<std::size_t>(known.kind)];
      if (count > 0) counted.emplace(known.name, count);
    }
    expect(stated == counted, "the counts of events by kind are not those of the events");
    std::map<std::array<int, 3>, std::uint32_t> draws;
    for (const StateData::Draws& d : s.draws) draws[{d.purpose, d.first, d.second}] = d.used;
    expect(s.draws.size() == draws.size() && draws == model_.draws,
           "the numbers of draws are not those of the events");
    judge_progress_of_effects();
  }

  void judge_progress_of_effects() {
    const auto& stated = line_.data.progress;
    std::vector<std::string> wrong, missing;
    for (const auto& of_effect : stated) {
      const std::string& name = of_effect.first;
      const auto effect = std::find_if(model_.effects.begin(), model_.effects.end(),
                                       [&](const auto& e) { return e->effect() == name; });
      const bool there = effect != model_.effects.end();
      expect(there, fmt::format("\"{}\" is no effect with events known in advance", name.substr(0, 60)));
      if (there && (*effect)->progress() != of_effect.second) wrong.push_back(name);
    }
    for (const auto& effect : model_.effects) {
      const std::string name(effect->effect());
      if (effect->progress() > 0 && !stated.contains(name)) missing.push_back(name);
    }
    expect(wrong.empty(),
           fmt::format("the progress of {} is not that of the events", fmt::join(wrong, " and ")));
    expect(missing.empty(), fmt::format("the progress of {} is missing", fmt::join(missing, " and ")));
  }

  const Context<Number>& c_;
  const Model<Number>& model_;
  const StateLine<Number>& line_;
  std::vector<std::pair<std::int32_t, int>> index_of_;
  bool holds_ = true;
};

}  // namespace tps::check

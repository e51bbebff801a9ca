// The engine's state to and from StateData. What is captured is everything that the run depends on and
// everything that its summary has counted, so that a resumed run cannot be told from one that never stopped.
#pragma once

#include <limits>
#include <stdexcept>
#include <string>

#include "reference/engine/simulation.hpp"
#include "reference/engine/state_numbers.hpp"
#include "reference/trace/check_state.hpp"

namespace tps {
namespace detail {

template <typename Scalar>
HexVector sum_data(const Sum<Scalar>& sum) {
  return {to_hex(sum.total()), to_hex(sum.rest())};
}

template <typename Scalar>
Sum<Scalar> sum_from(const HexVector& data) {
  return {number_from<Scalar>(data.at(0)), number_from<Scalar>(data.at(1))};
}

inline void require_fit(const Scene& scene, const StateData& state, int digits) {
  if (state.checksum == StateData::Checksum::wrong) {
    throw std::runtime_error(
        "its checksum is not that of its content, so that it was damaged or edited (an edited one may leave "
        "the "
        "checksum out)");
  }
  const std::vector<StateProblem> problems = state_problems(scene, state, digits);
  if (problems.empty()) return;
  std::string text;
  for (const StateProblem& problem : problems) {
    text += (text.empty() ? "" : "; ") + (problem.pointer + " " + problem.message);
  }
  throw std::runtime_error(text);
}

/// The quantities of ledger and statistics, each under its name, for both directions.
template <typename Ledger, typename Statistics, typename Visit>
void visit_quantities(Ledger& ledger, Statistics& statistics, Visit visit) {
  visit("kinetic_at_start", ledger.kinetic_at_start);
  visit("momentum_at_start", ledger.momentum_at_start);
  visit("lost", ledger.lost);
  visit("stored", ledger.stored);
  visit("work", ledger.work);
  for (std::size_t k = 0; k < ledger.from_walls.size(); ++k) {
    visit("from_walls_" + std::to_string(k), ledger.from_walls[k]);
    visit("from_outside_" + std::to_string(k), ledger.from_outside[k]);
  }
  visit("energy_bound", ledger.energy_bound);
  visit("momentum_bound", ledger.momentum_bound);
  visit("worst_inner_excess", statistics.worst_inner_excess);
  visit("worst_outer_excess", statistics.worst_outer_excess);
  visit("oldest_group", statistics.oldest_group);
}

template <typename Statistics, typename Visit>
void visit_counts(Statistics& statistics, Visit visit) {
  visit("#noise", statistics.noise);
  visit("#first_noise", statistics.first_noise);
  visit("#zero_impulse", statistics.zero_impulse);
  visit("#largest_group", statistics.largest_group);
}

}  // namespace detail

template <typename Scalar, int D>
StateData capture(const Simulation<Scalar, D>& simulation) {
  using namespace detail;
  const World<Scalar, D>& world = simulation.world();
  const auto id = [&](int i) { return world.scene.particles[world.index(i)].id; };
  StateData state;
  state.k = world.events;
  state.now = time_data(world.now);
  state.last_event = time_data(world.last_event);
  state.progress_event = simulation.progress_event();
  for (int i = 0; i < world.size(); ++i) {
    const ParticleState<Scalar, D>& p = world.particles[world.index(i)];
    state.particles.push_back({id(i), vector_data(p.position), vector_data(p.velocity), time_data(p.clock)});
    for (const int j : world.tethers.of(i)) {
      if (i < j) state.tethers.push_back({id(i), id(j)});
    }
    for (const Responded::Entry& entry : world.responded.of(i)) {
      const int j = entry.partner;
      const bool first_to_say = i < j || world.fixed(j);
      if (first_to_say && world.responded.contains(i, j, entry.limit)) {
        state.responded.push_back({id(i), id(j), entry.limit == Limit::outer});
      }
    }
  }
  for (const auto& [key, used] : world.draws) state.draws.push_back({key[0], key[1], key[2], used});
  for (const auto& effect : simulation.effects()) {
    effect->save(world, state);
    if (effect->progress() > 0) state.progress[std::string(effect->name())] = effect->progress();
    for (const auto& [name, numbers] : effect->numbers(world)) {
      for (const Scalar& x : numbers) state.quantities[name].push_back(to_hex(x));
    }
  }
  for (const auto& [kind, count] : world.statistics.by_kind) state.counts[kind] = count;
  visit_counts(world.statistics, [&](const char* name, std::uint64_t count) { state.counts[name] = count; });
  struct Writer {
    HexVector operator()(const Scalar& x) const { return {to_hex(x)}; }
    HexVector operator()(const Sum<Scalar>& x) const { return sum_data(x); }
    HexVector operator()(const Vector<Scalar, D>& x) const { return vector_data(x); }
  };
  visit_quantities(world.ledger, world.statistics,
                   [&](const std::string& name, const auto& x) { state.quantities[name] = Writer{}(x); });
  return state;
}

/// Puts a captured state into a fresh simulation of the same scene. Throws std::runtime_error, or
/// std::out_of_range from a look-up, when the state does not belong to the scene or to the scalar.
template <typename Scalar, int D>
void restore(Simulation<Scalar, D>& simulation, const StateData& state) {
  using namespace detail;
  World<Scalar, D>& world = simulation.world();
  require_fit(world.scene, state, std::numeric_limits<Scalar>::digits);
  IndexOfId index_of;
  for (int i = 0; i < world.size(); ++i) index_of[world.scene.particles[world.index(i)].id] = i;
  if (state.particles.size() != world.particles.size())
    throw std::runtime_error("the number of particles differs");
  world.events = state.k;
  world.now = time_from<Scalar>(state.now);
  world.last_event = time_from<Scalar>(state.last_event);
  for (const StateData::Particle& p : state.particles) {
    world.particles[world.index(index_of.at(p.id))] = {
        vector_from<Scalar, D>(p.position), vector_from<Scalar, D>(p.velocity), time_from<Scalar>(p.clock)};
  }
  world.tethers = Tethers(world.particles.size());
  for (const auto& [first, second] : state.tethers)
    world.tethers.add(index_of.at(first), index_of.at(second));
  for (const StateData::Responded& r : state.responded) {
    world.responded.add(index_of.at(r.first), index_of.at(r.second), r.outer ? Limit::outer : Limit::inner);
  }
  for (const StateData::Draws& d : state.draws) world.draws[{d.purpose, d.first, d.second}] = d.used;
  for (const auto& effect : simulation.effects()) {
    effect->load(world, state, index_of);
    const auto saved = state.progress.find(std::string(effect->name()));
    if (saved != state.progress.end()) effect->resume(world, saved->second);
    typename Effect<Scalar, D>::Numbers numbers = effect->numbers(world);
    for (auto& [name, list] : numbers) {
      for (std::size_t n = 0; n < list.size(); ++n)
        list[n] = number_from<Scalar>(state.quantities.at(name).at(n));
    }
    effect->take_numbers(world, numbers);
  }
  for (const auto& [kind, count] : state.counts) {
    if (!kind.starts_with('#')) world.statistics.by_kind[kind] = count;
  }
  visit_counts(world.statistics,
               [&](const char* name, std::uint64_t& count) { count = state.counts.at(name); });
  struct Reader {
    void operator()(Scalar& x, const HexVector& data) const { x = number_from<Scalar>(data.at(0)); }
    void operator()(Sum<Scalar>& x, const HexVector& data) const { x = sum_from<Scalar>(data); }
    void operator()(Vector<Scalar, D>& x, const HexVector& data) const { x = vector_from<Scalar, D>(data); }
  };
  visit_quantities(world.ledger, world.statistics,
                   [&](const std::string& name, auto& x) { Reader{}(x, state.quantities.at(name)); });
  simulation.resume(state.progress_event);
}

}  // namespace tps

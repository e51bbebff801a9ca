// The engine's state to and from StateData. What is captured is everything that the run depends on and
// everything that its summary has counted, so that a resumed run cannot be told from one that never stopped.
#pragma once

#include <limits>
#include <stdexcept>
#include <string>
#include <unordered_map>

#include "reference/engine/group_coupling.hpp"
#include "reference/engine/simulation.hpp"
#include "reference/engine/spin_coupling.hpp"
#include "reference/text/hexfloat.hpp"
#include "reference/trace/check_state.hpp"
#include "reference/trace/state_data.hpp"

namespace tps {
namespace detail {

template <typename Scalar>
HexTime time_data(const Time<Scalar>& t) {
  return {to_hex(t.hi), to_hex(t.lo)};
}

template <typename Scalar, int D>
HexVector vector_data(const Vector<Scalar, D>& v) {
  HexVector data;
  for (int k = 0; k < D; ++k) data.push_back(to_hex(Scalar(v[k])));
  return data;
}

template <typename Scalar>
Scalar number_from(const Hex& text) {
  const std::optional<Scalar> value = from_hex<Scalar>(text);
  if (!value)
    throw std::runtime_error("'" + text + "' is not a hexadecimal float that the scalar holds exactly");
  return *value;
}

template <typename Scalar>
Scalar finite_from(const Hex& text) {
  using std::abs;
  const Scalar value = number_from<Scalar>(text);
  if (abs(value) == std::numeric_limits<Scalar>::infinity())
    throw std::runtime_error("'" + text + "' stands where only a finite number can");
  return value;
}

template <typename Scalar>
Time<Scalar> time_from(const HexTime& data) {
  return {finite_from<Scalar>(data[0]), finite_from<Scalar>(data[1])};
}

template <typename Scalar, int D>
Vector<Scalar, D> vector_from(const HexVector& data) {
  if (data.size() != static_cast<std::size_t>(D)) throw std::runtime_error("a vector has the wrong length");
  Vector<Scalar, D> v;
  for (int k = 0; k < D; ++k) v[k] = finite_from<Scalar>(data[static_cast<std::size_t>(k)]);
  return v;
}

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

template <typename Scalar, int D>
StateData::Group group_data(const World<Scalar, D>& world, const GroupForest<Scalar, D>& forest,
                            const GroupBody<Scalar, D>& body) {
  using Node = GroupNode<Scalar, D>;
  const auto id = [&](int i) { return world.scene.particles[world.index(i)].id; };
  StateData::Group group;
  for (const int m : body.members) group.members.push_back(id(m));
  group.mass = to_hex(body.mass);
  group.expiry = time_data(body.expiry);
  group.birth = time_data(body.birth);
  std::vector<int> order = {body.root};  // breadth first; a node's number in the list is its place here
  for (std::size_t n = 0; n < order.size(); ++n) {
    const Node& node = forest.node(order[n]);
    StateData::Node data{id(node.i), id(node.j), node.limit == Limit::outer, {}, {}, vector_data(node.dp)};
    for (std::size_t s = 0; s < 2; ++s) {
      data.masses[s] = to_hex(node.mass[s]);
      if (node.side[s] == Node::kInfiniteMass) continue;
      if (node.side[s] < 0) {
        data.sides[s].particle = id(~node.side[s]);
      } else {
        data.sides[s].node = static_cast<int>(order.size());
        order.push_back(node.side[s]);
      }
    }
    group.nodes.push_back(data);
  }
  return group;
}

/// Rebuilds a group by joining its nodes again, children before parents.
template <typename Scalar, int D>
void restore_group(GroupForest<Scalar, D>& forest, const StateData::Group& data,
                   const std::unordered_map<std::int32_t, int>& index_of) {
  using Node = GroupNode<Scalar, D>;
  GroupBody<Scalar, D> body;
  for (const std::int32_t id : data.members) {
    body.members.push_back(index_of.at(id));
    if (forest.body(body.members.back()) != nullptr)
      throw std::runtime_error("particle " + std::to_string(id) + " is in two groups");
  }
  body.mass = number_from<Scalar>(data.mass);
  body.expiry = {number_from<Scalar>(data.expiry[0]), finite_from<Scalar>(data.expiry[1])};  // may be never
  body.birth = time_from<Scalar>(data.birth);
  std::vector<int> roots(data.nodes.size(), -1);
  for (std::size_t n = data.nodes.size(); n-- > 0;) {
    const StateData::Node& from = data.nodes[n];
    Node node{index_of.at(from.i),
              index_of.at(from.j),
              from.outer ? Limit::outer : Limit::inner,
              {},
              {},
              vector_from<Scalar, D>(from.dp)};
    for (std::size_t s = 0; s < 2; ++s) {
      node.mass[s] = number_from<Scalar>(from.masses[s]);
      const StateData::Side& side = from.sides[s];
      if (side.node && (*side.node <= static_cast<int>(n) || *side.node >= static_cast<int>(roots.size()))) {
        throw std::runtime_error("a group's nodes are not a tree");
      }
      node.side[s] = side.node       ? roots[static_cast<std::size_t>(*side.node)]
                     : side.particle ? ~index_of.at(*side.particle)
                                     : Node::kInfiniteMass;
    }
    roots[n] = forest.join(node, body).root;
  }
  if (roots.empty() || forest.members_of(roots.front()) != body.members)
    throw std::runtime_error("a group's members are not those of its nodes");
}

}  // namespace detail

template <typename Scalar, int D>
StateData capture(const Simulation<Scalar, D>& simulation) {
  using namespace detail;
  const World<Scalar, D>& world = simulation.world();
  const auto id = [&](int i) { return world.scene.particles[world.index(i)].id; };
  constexpr int kSpin = SpinCoupling<Scalar, D>::kSize;
  const auto* turning = dynamic_cast<const SpinCoupling<Scalar, D>*>(world.coupling.get());
  StateData state;
  state.k = world.events;
  state.now = time_data(world.now);
  state.last_event = time_data(world.last_event);
  state.progress_event = simulation.progress_event();
  for (int i = 0; i < world.size(); ++i) {
    const ParticleState<Scalar, D>& p = world.particles[world.index(i)];
    state.particles.push_back({id(i), vector_data(p.position), vector_data(p.velocity), time_data(p.clock)});
    if (turning != nullptr && keeps_spin(world.scene, world.species(i)))
      state.particles.back().spin = vector_data<Scalar, kSpin>(turning->spin(i));
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
  if (const auto* groups = dynamic_cast<const GroupCoupling<Scalar, D>*>(world.coupling.get())) {
    for (const GroupBody<Scalar, D>* body : groups->forest().bodies()) {
      state.groups.push_back(group_data(world, groups->forest(), *body));
    }
  }
  for (const auto& [key, used] : world.draws) state.draws.push_back({key[0], key[1], key[2], used});
  for (const auto& effect : simulation.effects()) {
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
  std::unordered_map<std::int32_t, int> index_of;
  for (int i = 0; i < world.size(); ++i) index_of[world.scene.particles[world.index(i)].id] = i;
  if (state.particles.size() != world.particles.size())
    throw std::runtime_error("the number of particles differs");
  world.events = state.k;
  world.now = time_from<Scalar>(state.now);
  world.last_event = time_from<Scalar>(state.last_event);
  auto* turning = dynamic_cast<SpinCoupling<Scalar, D>*>(world.coupling.get());
  for (const StateData::Particle& p : state.particles) {
    world.particles[world.index(index_of.at(p.id))] = {
        vector_from<Scalar, D>(p.position), vector_from<Scalar, D>(p.velocity), time_from<Scalar>(p.clock)};
    if (turning != nullptr && !p.spin.empty())
      turning->set_spin(index_of.at(p.id), vector_from<Scalar, SpinCoupling<Scalar, D>::kSize>(p.spin));
  }
  world.tethers = Tethers(world.particles.size());
  for (const auto& [first, second] : state.tethers)
    world.tethers.add(index_of.at(first), index_of.at(second));
  for (const StateData::Responded& r : state.responded) {
    world.responded.add(index_of.at(r.first), index_of.at(r.second), r.outer ? Limit::outer : Limit::inner);
  }
  if (auto* groups = dynamic_cast<GroupCoupling<Scalar, D>*>(world.coupling.get())) {
    for (const StateData::Group& group : state.groups) restore_group(groups->forest(), group, index_of);
  }
  for (const StateData::Draws& d : state.draws) world.draws[{d.purpose, d.first, d.second}] = d.used;
  for (const auto& effect : simulation.effects()) {
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

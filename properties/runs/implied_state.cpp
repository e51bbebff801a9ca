#include "properties/runs/implied_state.hpp"
#include "reference/scene/pair_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace tps::properties::runs {
namespace {

constexpr Real kInfinite = std::numeric_limits<Real>::infinity();

std::set<int> joined(std::set<int> all, const std::set<int>& more) {
  all.insert(more.begin(), more.end());
  return all;
}

}  // namespace

std::set<int> LoadedNode::particles() const {
  return joined(side_i, side_j);
}

Real reduced(Real mass_i, Real mass_j) {
  if (std::isinf(mass_i)) return mass_j;
  if (std::isinf(mass_j)) return mass_i;
  return mass_i * mass_j / (mass_i + mass_j);
}

ImpliedState::ImpliedState(const Scene& scene, const std::string& scalar)
    : scene_(&scene),
      in_float_(scalar == "float"),
      laws_(scene.pairs),
      active_phases_(scene.phases.size(), false) {
  for (const Particle& p : scene.particles) {
    Flight flight;
    for (std::size_t k = 0; k < 3; ++k) {
      flight.position[static_cast<Eigen::Index>(k)] = stored(p.position[k]);
      flight.velocity[static_cast<Eigen::Index>(k)] = stored(p.velocity[k]);
    }
    flights_.push_back(flight);
    masses_.push_back(stored(scene.species[at(p.species)].mass));
    if (std::isinf(masses_.back())) frame_velocity_ = flight.velocity;
  }
  for (const Tether& t : scene.tethers) tethers_.insert(ordered(t.i, t.j));
}

Real ImpliedState::stored(double x) const {
  return in_float_ ? Real(static_cast<float>(x)) : Real(x);
}

Real ImpliedState::stored_angle(double degrees) const {
  return stored(degrees) < 90 ? stored(degrees) : Real(90) - Real(std::ldexp(1.0, -17));
}

int ImpliedState::index_of(std::int32_t id) const {
  const auto& particles = scene_->particles;
  const auto found = std::lower_bound(particles.begin(), particles.end(), id,
                                      [](const Particle& p, std::int32_t wanted) { return p.id < wanted; });
  if (found == particles.end() || found->id != id)
    throw std::runtime_error("the trace names a particle " + std::to_string(id) +
                             ", which its scene has not");
  return static_cast<int>(found - particles.begin());
}

Point ImpliedState::position(int i, const Instant& t) const {
  const Flight& f = flight(i);
  return f.position + f.velocity * elapsed(f.clock, t);
}

bool ImpliedState::is_fixed(int i) const {
  return std::isinf(mass(i));
}

const PairLaw* ImpliedState::law(int i, int j) const {
  if (is_fixed(i) && is_fixed(j)) return nullptr;
  return pair_law(laws_, scene_->particles[at(i)].species, scene_->particles[at(j)].species);
}

bool ImpliedState::tethered(int i, int j) const {
  const PairLaw* pair = law(i, j);
  if (pair == nullptr || !pair->tethering) return false;
  return pair->tethering->form.when == FormRule::When::permanent || tethers_.contains(ordered(i, j));
}

int ImpliedState::tether_count(int i) const {
  return static_cast<int>(std::count_if(tethers_.begin(), tethers_.end(),
                                        [i](const auto& t) { return t.first == i || t.second == i; }));
}

const LoadedBody* ImpliedState::body(int i) const {
  const auto found = std::find_if(bodies_.begin(), bodies_.end(),
                                  [i](const LoadedBody& b) { return b.members.contains(i); });
  return found == bodies_.end() ? nullptr : &*found;
}

const LoadedNode* ImpliedState::node(int i, int j) const {
  for (const LoadedBody& group : bodies_) {
    for (const LoadedNode& n : group.nodes) {
      if (n.i == i && n.j == j) return &n;
    }
  }
  return nullptr;
}

Real ImpliedState::body_mass(int i) const {
  const LoadedBody* group = body(i);
  if (group == nullptr) return mass(i);
  if (group->ground >= 0) return kInfinite;
  Real sum = 0;
  for (const int m : group->members) sum += mass(m);
  return sum;
}

std::set<int> ImpliedState::with(int i) const {
  const LoadedBody* group = body(i);
  return group != nullptr ? group->members : std::set<int>{i};
}

bool ImpliedState::together(int i, int j) const {
  const LoadedBody* group = body(i);
  return group != nullptr && group->members.contains(j);
}

void ImpliedState::apply(const TracedEvent& event) {
  if (event.phase >= 0) return change_phase(event);
  const int i = index_of(event.i.value());
  const int j = event.j ? index_of(*event.j) : i;
  if (event.tether == "formed") tethers_.insert(ordered(i, j));
  if (event.tether == "broken") tethers_.erase(ordered(i, j));
  if (event.is_load()) load(event, i, j);
  if (event.kind == "restitute") part(event, i, j);
  for (const auto& [id, state] : event.post) {
    if (!is_fixed(index_of(id))) flights_[at(index_of(id))] = {state.position, state.velocity, event.t};
  }
}

void ImpliedState::load(const TracedEvent& event, int i, int j) {
  const auto particles_of = [this](int p) { return is_fixed(p) ? std::set<int>{} : with(p); };
  LoadedBody united;
  const LoadedNode node{i,
                        j,
                        particles_of(i),
                        particles_of(j),
                        body_mass(i),
                        body_mass(j),
                        event.dp_stored.value_or(Point::Zero()),
                        event.pre.at(id_of(i)).velocity.norm() + event.pre.at(id_of(j)).velocity.norm()};
  for (const int side : {i, j}) {
    if (is_fixed(side)) united.ground = side;
    const LoadedBody* old = body(side);
    if (old == nullptr) continue;
    united.nodes.insert(united.nodes.end(), old->nodes.begin(), old->nodes.end());
    if (old->ground >= 0) united.ground = old->ground;
  }
  united.members = node.particles();
  united.last_load = event.t;
  united.nodes.push_back(node);
  std::erase_if(bodies_, [&](const LoadedBody& b) { return united.members.contains(*b.members.begin()); });
  bodies_.push_back(united);
}

/// The members of the two bodies other than i and j take over their velocities, where they fly to.
void ImpliedState::part(const TracedEvent& event, int i, int j) {
  for (LoadedBody& group : bodies_) {
    const auto node = std::find_if(group.nodes.begin(), group.nodes.end(),
                                   [&](const LoadedNode& n) { return n.i == i && n.j == j; });
    if (node == group.nodes.end()) continue;
    for (const auto& [side, leader] : {std::pair{node->side_i, i}, std::pair{node->side_j, j}}) {
      for (const int m : side) {
        flights_[at(m)] = {position(m, event.t), event.post.at(id_of(leader)).velocity, event.t};
      }
    }
    group.nodes.erase(node);
    break;
  }
  std::erase_if(bodies_, [](const LoadedBody& b) { return b.nodes.empty(); });
}

void ImpliedState::change_phase(const TracedEvent& event) {
  active_phases_.at(at(event.phase)) = event.kind == "phase_begin";
  for (std::size_t n = 0; n < laws_.size(); ++n) {
    PairLaw& pair = laws_[n];
    if (!pair.tethering) continue;
    pair.tethering->form = scene_->pairs[n].tethering->form;
    pair.tethering->breaks = scene_->pairs[n].tethering->breaks;
    for (std::size_t p = 0; p < scene_->phases.size(); ++p) {
      const Phase& phase = scene_->phases[p];
      if (!active_phases_[p] || phase.species_a != pair.species_a || phase.species_b != pair.species_b)
        continue;
      if (phase.form) pair.tethering->form = *phase.form;
      if (phase.breaks) pair.tethering->breaks = *phase.breaks;
    }
  }
}

}  // namespace tps::properties::runs

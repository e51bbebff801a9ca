// What random impulses and the thermostat have in common: kicks on single particles at times that the scene
// knows in advance.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reference/engine/effect.hpp"
#include "reference/engine/outside_impulse.hpp"
#include "reference/engine/world.hpp"
#include "reference/scene/random_kicks.hpp"
#include "reference/text/json_pointer.hpp"

namespace tps {

/// Each particle that is kicked has one event ahead, which no change of a particle voids. How many it has had
/// is kept where draws are counted, so that a resumed run goes on with the next.
template <typename Scalar, int D>
class PoissonKicks : public Effect<Scalar, D> {
 public:
  PoissonKicks(std::string_view kind, Rank rank, Purpose purpose)
      : Effect<Scalar, D>({"heat"}), kind_(kind), rank_(rank), purpose_(purpose) {}

  void begin(World<Scalar, D>&, int self) override { self_ = self; }

  void queue_known(World<Scalar, D>& world) override {
    times_.clear();
    for (int i = 0; i < world.size(); ++i) {
      const Particle& particle = world.scene.particles[world.index(i)];
      const double tau = mean_wait(world.scene.species[world.index(particle.species)]);
      if (tau == 0) continue;
      times_.emplace_back(PoissonTimes(world.scene.seed, wait_purpose(), particle.id, tau));
      of_.resize(world.particles.size(), 0);
      of_[world.index(i)] = times_.size() - 1;
      while (times_.back().done() < done(world, i)) times_.back().advance();
      queue_next(world, i);
    }
  }

  void respond(World<Scalar, D>& world, const PendingEvent<Scalar>& event) override {
    const int i = event.detail;
    Record<Scalar, D> record = world.open_record(kind_, i, i);
    const Vector<Scalar, D> J = impulse(world, i, ++world.draws[stream(world, i)]);
    this->add_energy(0, push_from_outside(world, i, J, record));
    world.close_record(record);
    times_[of_[world.index(i)]].advance();
    queue_next(world, i);
  }

 protected:
  /// τ of a species that this effect kicks, else 0.
  virtual double mean_wait(const Species& species) const = 0;
  virtual Vector<Scalar, D> impulse(const World<Scalar, D>& world, int i, std::uint32_t n) const = 0;

 private:
  Purpose wait_purpose() const { return static_cast<Purpose>(static_cast<std::uint32_t>(purpose_) + 1); }

  std::array<int, 3> stream(const World<Scalar, D>& world, int i) const {
    const std::int32_t id = world.scene.particles[world.index(i)].id;
    return {static_cast<int>(purpose_), id, id};
  }
  std::uint32_t done(const World<Scalar, D>& world, int i) const {
    const auto found = world.draws.find(stream(world, i));
    return found == world.draws.end() ? 0 : found->second;
  }

  void queue_next(World<Scalar, D>& world, int i) {
    const Scalar t = Scalar(times_[of_[world.index(i)]].next());
    world.queue.push(world.pending({t, Scalar(0)}, rank_, -1, -1, i, self_));
  }

  std::string_view kind_;
  Rank rank_;
  Purpose purpose_;
  std::vector<PoissonTimes> times_;
  std::vector<std::size_t> of_;  ///< place in times_ of a particle that is kicked
  int self_ = 0;
};

/// "species A", of those that call for an effect.
template <typename Calls>
std::vector<CallingPlace> species_that(const Scene& scene, Calls calls) {
  std::vector<CallingPlace> places;
  for (const Species& species : scene.species) {
    if (calls(species))
      places.push_back({"species " + species.name, "/species/" + escape_pointer_key(species.name)});
  }
  return places;
}

/// How many particles are of species that call for an effect.
template <typename Calls>
std::uint64_t particles_that(const Scene& scene, Calls calls) {
  std::uint64_t count = 0;
  for (const Particle& p : scene.particles)
    count += calls(scene.species[static_cast<std::size_t>(p.species)]);
  return count;
}

}  // namespace tps

// An effect: one thing that can happen in a scene. The simulation is put together from those that the scene
// calls for, and knows none of them by name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/engine/clock.hpp"
#include "reference/engine/effect_call.hpp"
#include "reference/engine/energy_share.hpp"
#include "reference/engine/laws.hpp"
#include "reference/engine/pair_timing.hpp"
#include "reference/engine/queue.hpp"
#include "reference/engine/state_data.hpp"
#include "reference/scene/scene.hpp"

namespace tps {

template <typename Scalar, int D>
class World;

/// A law of the scene, "species A - species B", as a place of it.
inline CallingPlace between(const Scene& scene, const PairLaw& pair) {
  const auto& name_of = [&](int species) { return scene.species[static_cast<std::size_t>(species)].name; };
  return {name_of(pair.species_a) + " - " + name_of(pair.species_b),
          "/pairs/" + std::to_string(&pair - scene.pairs.data())};
}
/// A key of the scene as a place of it.
inline CallingPlace key_of_scene(const std::string& key) {
  return {"\"" + key + "\"", "/" + key};
}

/// How many pairs of particles follow a law that satisfies the condition; of two infinite masses, none.
template <typename Condition>
std::uint64_t interacting_pairs(const Scene& scene, Condition condition) {
  std::vector<std::uint64_t> count(scene.species.size(), 0);
  for (const Particle& p : scene.particles) ++count[static_cast<std::size_t>(p.species)];
  std::uint64_t pairs = 0;
  for (const PairLaw& law : scene.pairs) {
    if (!condition(law)) continue;
    if (is_never_followed(scene, law)) continue;
    const std::uint64_t a = count[static_cast<std::size_t>(law.species_a)];
    const std::uint64_t b = count[static_cast<std::size_t>(law.species_b)];
    pairs += law.species_a == law.species_b ? a * (a - (a > 0 ? 1 : 0)) / 2 : a * b;
  }
  return pairs;
}

template <typename Scalar, int D>
class Effect {
 public:
  virtual ~Effect() = default;
  virtual std::string_view name() const = 0;

  /// Once, before anything is predicted: sets up what it needs. `self` is the index under which it is called
  /// back.
  virtual void begin(World<Scalar, D>&, int /*self*/) {}

  /// Queues the events that it knows in advance, on the present state: at the start and after a resume.
  virtual void queue_known(World<Scalar, D>&) {}

  /// What decides about this effect's next event of a pair, i < j, on the present states; nothing where it
  /// has none. A pair that certainly never comes to its blocking distance, and has no tether, is not asked.
  virtual std::optional<LimitQuestion<Scalar>> asks(const World<Scalar, D>&, int /*i*/, int /*j*/) const {
    return std::nullopt;
  }
  virtual bool predicts_pairs() const { return false; }

  /// The exact moment of one of its events that is no pair's. REQUIRES certified timing.
  virtual Moment moment(const World<Scalar, D>& world, const PendingEvent<Scalar>& event) const;

  /// Queues again what a change of these particles has voided, other than events of pairs.
  virtual void refresh(World<Scalar, D>&, const std::vector<int>& /*touched*/) {}

  /// One of its events is due: changes the world and closes a record (or several).
  virtual void respond(World<Scalar, D>&, const PendingEvent<Scalar>&) = 0;

  /// How many of the events known in advance have happened; a resumed run starts there.
  /// Throws std::out_of_range when the scene has fewer.
  virtual std::uint64_t progress() const { return 0; }
  virtual void resume(World<Scalar, D>&, std::uint64_t /*progress*/) {}

  /// What a full state holds of this effect beside progress: lists of numbers by their names. A resumed run
  /// gets them back. By default its sums of energy, as "gravity_work".
  using Numbers = std::map<std::string, std::vector<Scalar>>;
  virtual Numbers numbers(const World<Scalar, D>&) const {
    Numbers numbers;
    for (const EnergyShare<Scalar>& share : shares_)
      numbers[named(share)] = {share.sum.total(), share.sum.rest()};
    return numbers;
  }
  virtual void take_numbers(World<Scalar, D>&, const Numbers& numbers) {
    for (EnergyShare<Scalar>& share : shares_) {
      const std::vector<Scalar>& kept = numbers.at(named(share));
      share.sum = {kept.at(0), kept.at(1)};
    }
  }

  /// What it has done to the energy of the scene from the start until `end`, which is not before the last
  /// event: lines of the summary.
  using Energies = std::vector<std::pair<std::string_view, Scalar>>;
  virtual Energies energies(const World<Scalar, D>&, const Time<Scalar>& /*end*/) const {
    Energies energies;
    for (const EnergyShare<Scalar>& share : shares_) energies.emplace_back(share.what, share.sum.value());
    return energies;
  }

  /// What it holds of particles and groups. load() undoes save(); it throws std::runtime_error, or
  /// std::out_of_range from a look-up, where a state does not belong to the scene or to the scalar.
  virtual void save(const World<Scalar, D>&, StateData&) const {}
  virtual void load(World<Scalar, D>&, const StateData&, const IndexOfId&) {}

 protected:
  Effect() = default;
  /// @param shares  what it adds up: "work", "heat", "lost"
  explicit Effect(std::initializer_list<std::string_view> shares) {
    for (const std::string_view what : shares) shares_.push_back({what, {}});
  }
  /// Adds to the nth of them. Throws OutOfRange.
  void add_energy(std::size_t n, const Scalar& energy) { shares_[n].add(energy, name()); }
  /// The nth of them, for a coupling that adds to it.
  EnergyShare<Scalar>& energy_share(std::size_t n) { return shares_[n]; }

 private:
  std::string named(const EnergyShare<Scalar>& share) const {
    return std::string(name()).append("_").append(share.what);
  }

  std::vector<EnergyShare<Scalar>> shares_;
};

/// What is known in advance is at its stored time.
template <typename Scalar, int D>
Moment Effect<Scalar, D>::moment(const World<Scalar, D>&, const PendingEvent<Scalar>& event) const {
  return PairTiming<Scalar, D>::known(event.time);
}

}  // namespace tps

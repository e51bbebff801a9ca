// What is simulated: the validated, immutable content of a scene file. Numbers are the doubles that the
// file stores; an engine of another scalar lifts them exactly or rounds them once.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tps {

/// Components beyond `Scene::dimension` are zero.
using Coordinates = std::array<double, 3>;

/// Impulses at random times on each particle of a species: waiting times exponential with mean `tau`,
/// magnitudes gamma-distributed with `shape` and `mean`, directions uniform (semantics §5).
struct RandomImpulses {
  double tau = 1;
  double shape = 1;
  double mean = 1;
  bool operator==(const RandomImpulses&) const = default;
};

/// Andersen's thermostat: at exponential times of mean `tau` a particle's velocity is drawn anew from the
/// Maxwell distribution of kT (semantics §5).
struct Thermostat {
  double tau = 1;
  double kT = 1;
  bool operator==(const Thermostat&) const = default;
};

/// A kind of particle. `mass` is in (0, ∞]; `radius` is in [0, ∞).
struct Species {
  std::string name;
  double mass = 1;
  double radius = 0;
  std::optional<int> max_tethers;  ///< tethers that count towards the capacity; none: unlimited
  std::optional<RandomImpulses> random_impulses = {};
  std::optional<Thermostat> thermostat = {};
  bool operator==(const Species&) const = default;
};

/// Inner limit of a pair (semantics §2): a blocking collision at `distance`, answered by eq. (4).
struct BlockingLaw {
  double distance = 0;
  double c_rebound = 1;
  bool operator==(const BlockingLaw&) const = default;
};

/// When a tether forms at a blocking collision (semantics §3).
struct FormRule {
  enum class When { never, always, probability, permanent };
  When when = When::always;
  double probability = 1;  ///< used with When::probability
  bool operator==(const FormRule&) const = default;
};

/// When a tether breaks at a tethering collision (semantics §3).
struct BreakRule {
  enum class When { never, always, probability, impulse_above };
  When when = When::never;
  double probability = 0;  ///< used with When::probability
  double threshold = 0;    ///< |Δp| above which it breaks; used with When::impulse_above
  bool operator==(const BreakRule&) const = default;
};

/// Outer limit of a tethered pair: retraction by eq. (4) or revolution by eq. (5) at `distance`.
struct TetheringLaw {
  double distance = 0;
  double c_retract = 1;
  double c_revolve = 1;
  double theta_revolve_deg = 45;
  FormRule form;
  BreakRule breaks;
  bool operator==(const TetheringLaw&) const = default;
};

/// Friction of rough particles at their rebounds (Walton): μ in [0, ∞), β₀ in [−1, 1].
struct FrictionLaw {
  double mu = 0;
  double beta0 = -1;
  bool operator==(const FrictionLaw&) const = default;
};

/// How two species interact; species are indices into Scene::species, species_a <= species_b.
struct PairLaw {
  int species_a = 0;
  int species_b = 0;
  std::optional<BlockingLaw> blocking;
  std::optional<TetheringLaw> tethering;
  std::optional<FrictionLaw> friction = {};
  bool operator==(const PairLaw&) const = default;
};

/// Replaces rules of a pair of species while from <= t < until.
struct Phase {
  double from = 0;
  double until = 0;
  int species_a = 0;
  int species_b = 0;
  std::optional<FormRule> form;
  std::optional<BreakRule> breaks;
  bool operator==(const Phase&) const = default;
};

/// An impulse from outside on one particle (an index into Scene::particles) at a given time.
struct ScheduledImpulse {
  double at = 0;
  int particle = 0;
  Coordinates impulse{};
  bool operator==(const ScheduledImpulse&) const = default;
};

/// Gravity as impulses m g δ on every finite mass at 0, δ, 2δ, …, the first a half (semantics §5).
struct Gravity {
  Coordinates acceleration{};
  double every = 0;  ///< δ
  bool operator==(const Gravity&) const = default;
};

/// Drag, the superimposed equation dv/dt = −γ v with one γ for everybody (semantics §5).
struct Drag {
  double gamma = 0;
  bool operator==(const Drag&) const = default;
};

/// A wall: a body of infinite mass that no collision moves, at `point` + `velocity` · t, which particles of
/// finite mass rebound from by eq. (4) when it touches them (semantics §5).
struct Wall {
  enum class Shape { plane, sphere, box };
  Shape shape = Shape::plane;
  Coordinates point{};   ///< through which a plane goes; centre of a sphere; lowest corner of a box
  Coordinates normal{};  ///< of a plane, towards the particles; of unit length to rounding
  Coordinates high{};    ///< highest corner of a box
  double radius = 0;     ///< of a sphere
  bool inside = true;    ///< particles are inside of a sphere or box; else outside of a sphere
  double c_rebound = 1;
  Coordinates velocity{};
  bool operator==(const Wall&) const = default;
};

/// A periodic box from the origin to `edges`: a pair meets by the image that is nearest (semantics §5).
struct PeriodicEdges {
  Coordinates edges{};  ///< infinite along an open axis
  bool operator==(const PeriodicEdges&) const = default;
};

/// Grouping of nearly simultaneous collisions (eqs. 6-7).
struct Grouping {
  double dt_restitute = 0;
  bool operator==(const Grouping&) const = default;
};

/// `id` is what files and traces call the particle; Scene::particles is sorted by it.
struct Particle {
  std::int32_t id = 0;
  int species = 0;
  Coordinates position{};
  Coordinates velocity{};
  bool operator==(const Particle&) const = default;
};

/// A pair of indices into Scene::particles, first < second.
struct Tether {
  int i = 0;
  int j = 0;
  bool operator==(const Tether&) const = default;
};

/// What the summary counts as a cluster: connected components of (non-permanent) tethers that hold at
/// least `at_least` particles of `species`.
struct ClusterObservation {
  int species = 0;
  int at_least = 3;
  bool operator==(const ClusterObservation&) const = default;
};

/// What a scene has under a key that an effect brings along (scene_key.hpp).
class SceneSection {
 public:
  virtual ~SceneSection() = default;
  /// Its value as JSON, in one line. Two sections are the same if this is.
  virtual std::string json() const = 0;
};

/// A section, shared by the copies of its scene.
class SharedSection {
 public:
  explicit SharedSection(std::shared_ptr<const SceneSection> section) : section_(std::move(section)) {}
  const SceneSection* get() const { return section_.get(); }
  const SceneSection* operator->() const { return section_.get(); }
  bool operator==(const SharedSection& other) const { return section_->json() == other->json(); }

 private:
  std::shared_ptr<const SceneSection> section_;
};

struct Scene {
  std::string title;
  int dimension = 3;
  double start_time = 0;  ///< the clock at the start; every other time of a scene counts from the start
  double duration = 0;    ///< in (0, ∞]
  std::uint64_t seed = 0;
  std::vector<Species> species;
  std::vector<PairLaw> pairs;
  std::optional<Grouping> grouping;
  std::optional<Gravity> gravity;
  std::optional<Drag> drag;
  std::vector<Wall> walls;
  std::optional<PeriodicEdges> box;
  std::vector<Phase> phases;
  std::vector<ScheduledImpulse> impulses;
  std::vector<Particle> particles;
  std::vector<Coordinates> spins;  ///< angular velocities at the start in the order of particles, read and
                                   ///< set below; empty without
  std::vector<Tether>
      tethers;  ///< formed at the start; permanent ones are implied by their law, never listed
  std::optional<ClusterObservation> clusters;
  std::map<std::string, SharedSection, std::less<>> sections;  ///< by key, of effects with one of their own
  bool operator==(const Scene&) const = default;
};

/// Angular velocity at the start of the particle at an index; in the plane its first number.
inline Coordinates spin_of(const Scene& scene, std::size_t particle) {
  return particle < scene.spins.size() ? scene.spins[particle] : Coordinates{};
}
/// Sets it. ENSURES a scene whose particles do not turn has no list of spins.
inline void set_spin(Scene& scene, std::size_t particle, const Coordinates& spin) {
  if (particle >= scene.spins.size()) {
    if (spin == Coordinates{}) return;
    scene.spins.resize(scene.particles.size());
  }
  scene.spins[particle] = spin;
}

/// Whether a law is of two infinite masses, which never interact (semantics §2).
inline bool is_never_followed(const Scene& scene, const PairLaw& law) {
  const auto is_infinite = [&](int species) {
    return scene.species[static_cast<std::size_t>(species)].mass == std::numeric_limits<double>::infinity();
  };
  return is_infinite(law.species_a) && is_infinite(law.species_b);
}

/// Whether particles of a species have a spin: those of finite mass that some pair's friction can turn.
inline bool keeps_spin(const Scene& scene, int species) {
  if (scene.species[static_cast<std::size_t>(species)].mass == std::numeric_limits<double>::infinity())
    return false;
  return std::any_of(scene.pairs.begin(), scene.pairs.end(), [&](const PairLaw& law) {
    return law.friction && (law.species_a == species || law.species_b == species);
  });
}

}  // namespace tps

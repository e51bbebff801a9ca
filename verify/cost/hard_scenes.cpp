// The scenes of the hard cases.
#include <cmath>
#include <limits>

#include "verify/cost/hard_cases.hpp"
#include "verify/scenes/cradle.hpp"
#include "verify/scenes/gas.hpp"
#include "verify/scenes/pair.hpp"
#include "verify/scenes/sheet.hpp"
#include "verify/scenes/three_body.hpp"
#include "verify/vectors/random.hpp"

namespace tps::cost {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::uint64_t kFew = 300;  ///< long enough for float to leave a gas, short enough for double not to
constexpr double kLong = 1e6;        ///< events end these runs

Scene gas(int particles = 20, double density = 0.3) {
  GasParams params;
  params.particles = particles;
  params.density = density;
  params.duration = kLong;
  return build_gas(params);
}

Scene late_start() {
  Scene scene = gas();
  scene.start_time = 0x1p40;
  return scene;
}

Scene far_origin() {
  Scene scene = gas();
  for (Particle& particle : scene.particles) {
    for (double& x : particle.position) x += 0x1p30;
  }
  return scene;
}

/// Lengths and velocities times `factor`, a power of two; times stay.
Scene scaled(double factor) {
  Scene scene = gas();
  for (Species& species : scene.species) species.radius *= factor;
  for (PairLaw& law : scene.pairs) {
    if (law.blocking) law.blocking->distance *= factor;
    if (law.tethering) law.tethering->distance *= factor;
  }
  for (Particle& particle : scene.particles) {
    for (double& x : particle.position) x *= factor;
    for (double& v : particle.velocity) v *= factor;
  }
  return scene;
}

/// Every other sphere weighs 1e15.
Scene unequal_masses() {
  Scene scene = gas();
  const auto heavy = static_cast<int>(scene.species.size());
  const int light = scene.particles.back().species;
  Species species = scene.species[static_cast<std::size_t>(light)];
  species.name = "heavy";
  species.mass = 1e15;
  scene.species.push_back(species);
  for (const PairLaw& law : std::vector<PairLaw>(scene.pairs)) {
    PairLaw other = law;
    if (law.species_a == light && law.species_b == light) {
      other.species_b = heavy;
      scene.pairs.push_back(other);
      other.species_a = heavy;
    } else {
      (law.species_a == light ? other.species_a : other.species_b) = heavy;
      if (other.species_a > other.species_b) std::swap(other.species_a, other.species_b);
    }
    scene.pairs.push_back(other);
  }
  bool odd = false;
  for (Particle& particle : scene.particles) {
    if (particle.species == light && (odd = !odd)) particle.species = heavy;
  }
  return scene;
}

/// X-Y-Z with c = e_c + `beyond`: collisions never end from e_c = (1 − sin α)/(1 + sin α) on downwards, with
/// cos α = 1/(1 + m_Y) (docs/claims.md).
Scene near_collapse(double beyond) {
  ThreeBodyParams params;
  const double cosine = 1 / (1 + params.middle_mass);
  const double sine = std::sqrt((1 - cosine) * (1 + cosine));
  params.restitution = (1 - sine) / (1 + sine) + beyond;
  return build_three_body(params);
}

/// Balls on parallel tracks, each past a fixed one of its own at L(1 ∓ 2^-k), k from 3 to 40: hits and misses
/// in turn. From 1024 L away, so that b² and 4ac cancel.
Scene grazing_train() {
  Scene scene;
  scene.title = "Balls that graze fixed ones";
  scene.dimension = 2;
  scene.duration = 4096;
  scene.species = {{.name = "fixed", .mass = kInfinity, .radius = 0.5, .max_tethers = {}},
                   {.name = "ball", .mass = 1, .radius = 0.5, .max_tethers = {}}};
  scene.pairs = {{.species_a = 0,
                  .species_b = 1,
                  .blocking = BlockingLaw{.distance = 1, .c_rebound = 1},
                  .tethering = {}}};
  int id = 0;
  for (int k = 3; k <= 40; ++k) {
    const double track = 4.0 * (k - 20);
    const double off = std::ldexp(k % 2 == 1 ? -1.0 : 1.0, -k);
    scene.particles.push_back({.id = id++, .species = 0, .position = {0, track, 0}, .velocity = {}});
    scene.particles.push_back(
        {.id = id++, .species = 1, .position = {-1024, track + 1 + off, 0}, .velocity = {1, 0, 0}});
  }
  return scene;
}

Scene circling_pair(double theta_deg, double c_retract) {
  PairParams params;
  params.theta = theta_deg;
  params.c_retract = c_retract;
  params.c_revolve = 1;
  params.duration = kInfinity;
  Scene scene = build_pair(params);
  scene.pairs.front().blocking.reset();
  return scene;
}

/// Twenty pairs that meet head on in directions of their own, with c = 0: from then on each rests in contact,
/// to t = 2^40.
Scene resting_pairs() {
  Scene scene;
  scene.title = "Pairs that come to rest in contact";
  scene.dimension = 3;
  scene.duration = 0x1p40;
  scene.species = {{.name = "ball", .mass = 1, .radius = 0.5, .max_tethers = {}}};
  scene.pairs = {{.species_a = 0,
                  .species_b = 0,
                  .blocking = BlockingLaw{.distance = 1, .c_rebound = 0},
                  .tethering = {}}};
  vectors::Random random(1);
  for (int pair = 0; pair < 20; ++pair) {
    Coordinates half{};
    for (double& x : half) x = random.uniform(0.6, 1.4);
    for (const int side : {-1, 1}) {
      Particle particle{.id = 2 * pair + (side + 1) / 2, .species = 0, .position = {}, .velocity = {}};
      for (std::size_t k = 0; k < 3; ++k) {
        particle.position[k] = side * half[k] + (k == 0 ? 16.0 * pair : 0);
        particle.velocity[k] = -side * half[k] / 4;
      }
      scene.particles.push_back(particle);
    }
  }
  return scene;
}

/// Every tether at its length but for rounding, at t = 0.
Scene taut_network() {
  SheetParams params;
  params.spacing = params.tether_distance = 1.2;
  params.grouped = 0;
  params.duration = kLong;
  return build_sheet(params);
}

Scene touching_row() {
  CradleParams params;
  params.particles = 10'000;
  return build_cradle(params);
}

}  // namespace

std::vector<HardCase> hard_cases() {
  return {
      {"late-start", "a gas of 20 spheres that starts at t = 2^40", late_start, kFew},
      {"far-origin", "the same gas, 2^30 from the origin", far_origin, kFew},
      {"huge", "the same gas, lengths and speeds times 2^400", [] { return scaled(0x1p400); }, kFew},
      {"tiny", "the same gas, lengths and speeds times 2^-400", [] { return scaled(0x1p-400); }, kFew},
      {"masses", "the same gas, every other sphere 1e15 times as heavy", unequal_masses, kFew},
      {"above-collapse", "X-Y-Z with c = e_c + 1e-5", [] { return near_collapse(1e-5); }, 20'000},
      {"below-collapse", "X-Y-Z with c = e_c - 1e-5", [] { return near_collapse(-1e-5); }, 20'000,
       RightBy::end},
      {"grazing-train", "38 balls that pass or hit fixed ones at L(1 -+ 2^-k), k to 40", grazing_train, kFew},
      {"retract-boundary", "a pair that circles at 30 degrees with c_retract = 1",
       [] { return circling_pair(30, 1); }, kFew, RightBy::nothing},
      {"resting", "20 pairs in contact with c = 0, until t = 2^40", resting_pairs, kFew},
      {"taut-network", "a sheet of 64, every tether taut", taut_network, kFew, RightBy::nothing},
      {"theta-least", "a pair that circles with theta = 1e-6 degrees",
       [] { return circling_pair(1e-6, 0.5); }, kFew},
      {"theta-most", "a pair that circles with theta = 90 - 1e-6 degrees",
       [] { return circling_pair(90 - 1e-6, 0.5); }, kFew},
      {"cage", "43 spheres as close as their cage takes them", [] { return gas(43, 0.88); }, kFew},
      {"contacts", "a row of 10^4 touching balls", touching_row, 20'000, RightBy::events, true}};
}

}  // namespace tps::cost

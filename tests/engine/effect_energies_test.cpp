// What each effect has done to the energy of a run: against the trace, against the ledger's totals, and after
// a resume (docs/ledger.md, "Effect by effect").
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "tests/run/resumed_run.hpp"
#include "tests/run/traced_run.hpp"

namespace tps {
namespace {

using testing::add_particle;
using Shares = std::map<std::string, double>;  // by "effect what"

Shares shares_of(const RunSummary& s) {
  Shares shares;
  for (const EffectEnergy& share : s.by_effect) shares[share.effect + ' ' + share.what] = share.energy;
  return shares;
}

double sum_of(const RunSummary& s, const std::string& what) {
  double sum = 0;
  for (const EffectEnergy& share : s.by_effect) sum += share.what == what ? share.energy : 0;
  return sum;
}

/// Half of a box whose walls approach each other, so that energies are those at rest.
void add_piston(Scene& scene, double c) {
  for (const double side : {-1., 1.}) {
    Wall wall;
    wall.point = {3 * side, 0, 0};
    wall.normal = {-side, 0, 0};
    wall.velocity = {-.1 * side, 0, 0};
    wall.c_rebound = c;
    scene.walls.push_back(wall);
  }
  Wall box;
  box.shape = Wall::Shape::box;
  box.point = {-9, -3, 0};
  box.high = {9, 3, 0};
  box.c_rebound = c;
  scene.walls.push_back(box);
}

/// Rough discs, some pushed at random and by plan, others in a bath, between walls of which two move.
Scene busy() {
  Scene scene = testing::plain_scene();
  scene.duration = 6;
  scene.seed = 7;
  const int bathed = testing::add_species(scene, "bathed", 2, .5);
  scene.species[0].random_impulses = RandomImpulses{.2, 2, .3};
  scene.species[static_cast<std::size_t>(bathed)].thermostat = Thermostat{.4, 1};
  testing::block(scene, 0, 0, .9).friction = FrictionLaw{.3, .2};
  testing::block(scene, 0, bathed, .8);
  testing::block(scene, bathed, bathed, 1);
  add_piston(scene, .7);
  for (int n = 0; n < 3; ++n) {
    add_particle(scene, 0, {1.5 * n - 1.5, 1, 0}, {.5 - n, .25, 0});
    add_particle(scene, bathed, {1.5 * n - 1.5, -1, 0}, {n - .5, .5, 0});
  }
  scene.impulses = {{1, 0, {.5, .5, 0}}, {2, 1, {-1, 0, 0}}};
  return scene;
}

/// ½ Σ m (v'² − v²) at the events of each kind, from the trace.
Shares gained_by_kind(const Scene& scene, const testing::TracedRun& run) {
  Shares gained;
  for (const testing::TracedEvent& event : run.events) {
    for (const auto& [id, after] : event.post) {
      const int species = scene.particles[static_cast<std::size_t>(id)].species;
      const double mass = scene.species[static_cast<std::size_t>(species)].mass;
      const auto& before = event.pre.at(id);
      for (std::size_t k = 0; k < 2; ++k)
        gained[event.kind] +=
            mass / 2 * (after.velocity[k] * after.velocity[k] - before.velocity[k] * before.velocity[k]);
    }
  }
  return gained;
}

TEST(EffectEnergies, AreWhatTheEventsOfTheTraceDid) {
  const Scene scene = busy();
  const testing::TracedRun run = testing::traced(scene);
  const Shares shares = shares_of(run.summary);
  const Shares gained = gained_by_kind(scene, run);
  const double bound = run.summary.energy_bound;
  EXPECT_LT(bound, 1e-9);
  EXPECT_NEAR(shares.at("random_impulses heat"), gained.at("random_impulse"), bound);
  EXPECT_NEAR(shares.at("thermostat heat"), gained.at("thermostat"), bound);
  EXPECT_NEAR(shares.at("scheduled_impulses work"), gained.at("scheduled_impulse"), bound);
  EXPECT_NEAR(shares.at("walls work") - shares.at("walls lost"), gained.at("wall"), bound);
  const double of_spins = *run.summary.spin - *run.summary.spin_at_start;
  EXPECT_NEAR(-shares.at("rebound lost") - shares.at("friction lost") - of_spins, gained.at("rebound"),
              bound);
  for (const auto& [what, energy] : shares) EXPECT_GT(std::abs(energy), .01) << what;
}

TEST(EffectEnergies, AddUpToTheLedger) {
  Scene scene = busy();
  scene.impulses.clear();  // what they do is the rest of the work
  for (const std::string& scalar : scalar_names()) {
    const RunSummary s = run_scene(scene, testing::options_for(scalar));
    // Each sum is rounded twice where it is read, and once more as a double; its terms are the ledger's.
    double size = 0;
    for (const EffectEnergy& share : s.by_effect) size += std::abs(share.energy);
    const double rounding = 8 * (scalar == "float" ? 0x1p-24 : 0x1p-53) * (size + s.lost + std::abs(s.work));
    EXPECT_NEAR(sum_of(s, "work") + sum_of(s, "heat"), s.work, rounding) << scalar;
    EXPECT_NEAR(sum_of(s, "lost"), s.lost, rounding) << scalar;
    EXPECT_NEAR(s.kinetic + *s.spin - s.kinetic_at_start - *s.spin_at_start,
                sum_of(s, "work") + sum_of(s, "heat") - sum_of(s, "lost"), s.energy_bound + rounding)
        << scalar;
  }
}

// A ball from rest: half a kick of 1 and four whole ones.
TEST(EffectEnergies, GravityDoesTheWorkOfAFall) {
  Scene scene = testing::plain_scene();
  scene.duration = .5625;
  scene.gravity = Gravity{{0, -8, 0}, .125};
  add_particle(scene, 0, {0, 10, 0});
  const RunSummary run = run_scene(scene, {});
  EXPECT_EQ(shares_of(run), (Shares{{"gravity work", (4.5 * 4.5) / 2}}));
  EXPECT_EQ(run.work, 4.5 * 4.5 / 2);
}

// Under drag a loss counts by the speeds of the scene, not of the clock s.
TEST(EffectEnergies, WallsInAFluidLoseWhatTheSceneLoses) {
  Scene scene = testing::plain_scene();
  scene.duration = 20;
  scene.drag = Drag{.05};
  add_piston(scene, .7);
  for (Wall& wall : scene.walls) wall.velocity = {};
  add_particle(scene, 0, {0, 0, 0}, {2, 1, 0});
  const RunSummary run = run_scene(scene, {});
  const Shares shares = shares_of(run);
  EXPECT_GT(run.lost, .5);
  EXPECT_NEAR(shares.at("walls lost"), run.lost, run.energy_bound);
  EXPECT_EQ(shares.at("drag taken"), *run.drag_taken);
  EXPECT_EQ(shares.at("walls work"), 0);
}

TEST(EffectEnergies, AResumedRunHasTheSame) {
  for (const char* scalar : {"double", "mp50"}) {
    RunOptions options = testing::options_for(scalar);
    options.state_every = 10;
    SCOPED_TRACE(scalar);
    Scene scene = busy();
    scene.gravity = Gravity{{0, -1, 0}, .25};
    const testing::ResumedRuns runs = testing::expect_same_when_resumed(scene, options);
    EXPECT_EQ(shares_of(runs.whole).size(), 8U);
    for (const RunSummary& resumed : runs.resumed) EXPECT_EQ(shares_of(resumed), shares_of(runs.whole));
  }
}

}  // namespace
}  // namespace tps

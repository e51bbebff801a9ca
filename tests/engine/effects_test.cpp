// Tethers that form and break, phases, scheduled impulses: semantics §3 and §5.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reference/scene/random.hpp"
#include "tests/run/traced_run.hpp"

namespace tps {
namespace {

using testing::add_particle;
using testing::add_species;
using testing::block;
using testing::options_for;
using testing::plain_scene;
using testing::traced;
using testing::TracedEvent;
using testing::TracedRun;

/// Two balls that hit each other at t = 1 with relative speed 2, and may become tethered (distance 2).
Scene meeting(FormRule form) {
  Scene scene = plain_scene();
  block(scene, 0, 0);
  testing::tether(scene, 0, 0, 2);
  scene.pairs[0].tethering->form = form;
  add_particle(scene, 0, {-1.5, 0, 0}, {1, 0, 0});
  add_particle(scene, 0, {1.5, 0, 0}, {-1, 0, 0});
  return scene;
}

TEST(Forming, NeverAndAlways) {
  const TracedRun never = traced(meeting({.when = FormRule::When::never}), "double");
  ASSERT_EQ(never.events.size(), 1U);
  EXPECT_EQ(never.events[0].tether, "");
  const TracedRun always = traced(meeting({.when = FormRule::When::always}), "double", 5);
  EXPECT_EQ(always.events[0].tether, "formed");
  EXPECT_EQ(always.events[1].kind, "retract");
  EXPECT_EQ(always.events[2].kind, "rebound");
  EXPECT_EQ(always.events[2].tether, "");                  // there already
  EXPECT_EQ(always.events[0].post.at(0).velocity[0], -1);  // forming changes no impulse
}

TEST(Forming, ByDrawThatIsRecordedAndDecides) {
  for (const double p : {.0, .25, .5, .75, 1.}) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      Scene scene = meeting({.when = FormRule::When::probability, .probability = p});
      scene.seed = seed;
      const TracedRun run = traced(scene, "double", 1);
      ASSERT_TRUE(run.events[0].draw);
      EXPECT_EQ(*run.events[0].draw, uniform(seed, Purpose::tether_form, 0, 1, 0));
      EXPECT_EQ(run.events[0].tether, *run.events[0].draw < p ? "formed" : "");
    }
  }
}

TEST(Forming, DrawsDoNotDependOnWhatElseHappens) {
  Scene scene = meeting({.when = FormRule::When::probability, .probability = .5});
  scene.seed = 3;
  const TracedRun alone = traced(scene, "double", 1);
  // Two more that meet earlier, and so draw before.
  add_particle(scene, 0, {-1.5, 9, 0}, {2, 0, 0});
  add_particle(scene, 0, {1.5, 9, 0}, {-2, 0, 0});
  const TracedRun both = traced(scene, "double", 6);
  ASSERT_EQ(both.events[0].i, 2);
  const auto same =
      std::find_if(both.events.begin(), both.events.end(), [](const TracedEvent& e) { return e.i == 0; });
  ASSERT_NE(same, both.events.end());
  EXPECT_EQ(same->draw, alone.events[0].draw);
}

TEST(Forming, StopsAtTheCapacityWithoutADraw) {
  Scene scene = meeting({.when = FormRule::When::probability, .probability = 1});
  scene.species[0].max_tethers = 1;
  add_particle(scene, 0, {4.5, 0, 0}, {-1, 0, 0});  // reaches 1 at t = 2.5, when 1 is full
  add_particle(scene, 0, {7, 0, 0}, {});            // reached by 2 later; both have room
  const TracedRun run = traced(scene, "double", 40);
  bool refused = false;
  bool formed = false;
  for (const TracedEvent& e : run.events) {
    if (e.kind != "rebound" || e.k == 1) continue;
    if (e.i == 1 && e.j == 2) {
      EXPECT_FALSE(e.draw);
      EXPECT_EQ(e.tether, "");
      refused = true;
    }
    if (e.i == 2 && e.j == 3 && !formed) {
      EXPECT_TRUE(e.draw);
      EXPECT_EQ(e.tether, "formed");
      formed = true;
    }
  }
  EXPECT_TRUE(refused);
  EXPECT_TRUE(formed);
}

/// A tethered pair that separates with relative speed 2 and is at its limit at t = .5; Δp = 2 by eq. (4).
Scene parting(BreakRule rule) {
  Scene scene = plain_scene();
  block(scene, 0, 0);
  testing::tether(scene, 0, 0, 2);
  scene.pairs[0].tethering->breaks = rule;
  add_particle(scene, 0, {-.5, 0, 0}, {-1, 0, 0});
  add_particle(scene, 0, {.5, 0, 0}, {1, 0, 0});
  scene.tethers = {{0, 1}};
  return scene;
}

void expect_broken_without_impulse(const TracedRun& run) {
  ASSERT_EQ(run.events.size(), 1U);
  const TracedEvent& e = run.events[0];
  EXPECT_EQ(e.kind, "break");
  EXPECT_EQ(e.tether, "broken");
  EXPECT_EQ(e.t, .5);
  EXPECT_TRUE(e.dp.empty());
  for (const int id : {0, 1}) EXPECT_EQ(e.pre.at(id).exact_velocity, e.post.at(id).exact_velocity);
  EXPECT_EQ(run.summary.end, "no_more_events");
  EXPECT_EQ(run.summary.kinetic, run.summary.kinetic_at_start);
}

TEST(Breaking, NeverAndAlways) {
  EXPECT_EQ(traced(parting({}), "double", 1).events[0].kind, "retract");
  expect_broken_without_impulse(traced(parting({.when = BreakRule::When::always}), "double"));
}

TEST(Breaking, ByDrawThatIsRecordedAndDecides) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Scene scene = parting({.when = BreakRule::When::probability, .probability = .5});
    scene.seed = seed;
    const TracedRun run = traced(scene, "double", 1);
    EXPECT_EQ(run.events[0].draw, uniform(seed, Purpose::tether_break, 0, 1, 0));
    EXPECT_EQ(run.events[0].kind, *run.events[0].draw < .5 ? "break" : "retract");
  }
}

TEST(Breaking, WhenTheImpulseIsAboveTheThreshold) {
  const BreakRule at{.when = BreakRule::When::impulse_above, .threshold = 2};
  EXPECT_EQ(traced(parting(at), "double", 1).events[0].kind, "retract");  // not above: equal
  const BreakRule below{.when = BreakRule::When::impulse_above, .threshold = std::nextafter(2., 0.)};
  expect_broken_without_impulse(traced(parting(below), "double"));
}

TEST(Containment, IsAPermanentTetherToAnInfiniteMass) {
  Scene scene = plain_scene(3);
  scene.species[0].max_tethers = 0;  // a permanent tether is not counted
  const int membrane = add_species(scene, "membrane", HUGE_VAL, 4);
  testing::tether(scene, 0, membrane, 3.5, 1, FormRule::When::permanent);
  block(scene, 0, 0);
  add_particle(scene, membrane, {0, 0, 0});
  add_particle(scene, 0, {1, 0, 0}, {1, .25, .5});
  add_particle(scene, 0, {-1, 0, 0}, {.5, -1, .125});
  const TracedRun run = traced(scene, "double", 400);
  EXPECT_EQ(run.summary.end, "max_events");
  EXPECT_GT(run.summary.by_kind.at("retract"), 50U);
  EXPECT_LE(run.summary.audit_outer_excess, 8);
  EXPECT_LE(run.summary.worst_outer_excess, 8);
  for (const TracedEvent& e : run.events) {
    EXPECT_EQ(e.tether, "");
    if (e.i == 0) {
      EXPECT_EQ(e.post.at(0).velocity, (std::vector<double>{0, 0, 0}));
    }
  }
}

TEST(Phases, HoldFromTheirStartUntilJustBeforeTheirEnd) {
  // The tethering collision is due at .5 exactly; the window [from, until) decides.
  struct Case {
    double from, until;
    const char* kind;
  };
  const double before = std::nextafter(.5, 0.);
  const double behind = std::nextafter(.5, 1.);
  for (const Case& c :
       {Case{.5, 1, "break"}, Case{0, .5, "retract"}, Case{0, behind, "break"}, Case{behind, 1, "retract"},
        Case{before, behind, "break"}, Case{0, HUGE_VAL, "break"}}) {
    Scene scene = parting({});
    scene.phases = {{.from = c.from,
                     .until = c.until,
                     .species_a = 0,
                     .species_b = 0,
                     .form = {},
                     .breaks = BreakRule{.when = BreakRule::When::always}}};
    const TracedRun run = traced(scene, "double", 4);
    const auto collision =
        std::find_if(run.events.begin(), run.events.end(), [](const TracedEvent& e) { return e.i == 0; });
    ASSERT_NE(collision, run.events.end());
    EXPECT_EQ(collision->kind, c.kind) << c.from << ' ' << c.until;
    EXPECT_EQ(collision->t, .5);
    const auto begin = std::find_if(run.events.begin(), run.events.end(),
                                    [](const TracedEvent& e) { return e.kind == "phase_begin"; });
    if (begin != run.events.end()) {
      EXPECT_EQ(begin->t, c.from);
      EXPECT_EQ(begin->phase, 0);
    }
  }
}

TEST(Phases, ALaterOneOfTheListWinsAndRulesReturn) {
  Scene scene = meeting({.when = FormRule::When::never});
  const FormRule always{.when = FormRule::When::always};
  scene.phases = {{.from = 0, .until = 5, .species_a = 0, .species_b = 0, .form = always, .breaks = {}},
                  {.from = .5,
                   .until = .75,
                   .species_a = 0,
                   .species_b = 0,
                   .form = FormRule{.when = FormRule::When::never},
                   .breaks = {}}};
  const auto forms = [](const Scene& s) {
    const TracedRun run = traced(s, "double", 6);
    return std::any_of(run.events.begin(), run.events.end(),
                       [](const TracedEvent& e) { return e.tether == "formed"; });
  };
  EXPECT_TRUE(forms(scene));  // 0's rule is back at t = 1
  scene.phases[1].until = 2;
  EXPECT_FALSE(forms(scene));  // 1's holds at t = 1
  scene.phases = {{.from = 0, .until = 1, .species_a = 0, .species_b = 0, .form = always, .breaks = {}}};
  EXPECT_FALSE(forms(scene));  // the scene's own is back at t = 1
}

TEST(ScheduledImpulses, ActAtTheirTimesInTheOrderOfTimeAndParticle) {
  Scene scene = plain_scene();
  for (int n = 0; n < 3; ++n) add_particle(scene, 0, {2. * n, 0, 0});
  scene.impulses = {{2, 1, {0, 1, 0}}, {1, 2, {.5, 0, 0}}, {2, 0, {0, 2, 0}}, {2, 1, {0, 3, 0}}};
  const TracedRun run = traced(scene, "double");
  std::vector<std::pair<double, int>> order;
  for (const TracedEvent& e : run.events) {
    EXPECT_EQ(e.kind, "scheduled_impulse");
    order.emplace_back(e.t, e.i);
  }
  EXPECT_EQ(order, (std::vector<std::pair<double, int>>{{1, 2}, {2, 0}, {2, 1}, {2, 1}}));
  EXPECT_EQ(run.events[2].dp[1], 1);  // of equal time and particle, the file's order
  EXPECT_EQ(run.events[3].post.at(1).velocity[1], 4);
  EXPECT_EQ(run.summary.work, .125 + 2 + 8);
  EXPECT_EQ(run.summary.momentum_drift, 0);
}

TEST(ScheduledImpulses, ComeBeforeCollisionsOfTheSameTime) {
  Scene scene = meeting({.when = FormRule::When::never});
  scene.impulses = {{1, 0, {0, 1, 0}}};
  const TracedRun run = traced(scene, "double");
  ASSERT_GE(run.events.size(), 2U);
  EXPECT_EQ(run.events[0].kind, "scheduled_impulse");
  EXPECT_EQ(run.events[1].kind, "rebound");
  EXPECT_EQ(run.events[1].t, 1);
  EXPECT_EQ(run.events[1].dt, 0);
}

}  // namespace
}  // namespace tps

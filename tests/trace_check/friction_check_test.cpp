// The check and friction: honest runs conform in every scalar and timing; a spin, an impulse or a contact
// that is not what μ and β₀ make of it is told by its rule.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "reference/text/hexfloat.hpp"
#include "tests/run/traced_run.hpp"
#include "tests/trace_check/checked_trace.hpp"
#include "verify/certified/exact_timing.hpp"
#include "verify/trace_check/check.hpp"

namespace tps {
namespace friction_check {
namespace {

using nlohmann::json;
using testing::add_particle;
using testing::checked;
using testing::first_finding;
using testing::violated;
using testing::with_line;

Scene busy(unsigned seed) {
  Scene scene = testing::plain_scene(2 + static_cast<int>(seed % 2));
  scene.duration = 20;
  const int big = testing::add_species(scene, "big", 5, .75);
  const int post = testing::add_species(scene, "post", std::numeric_limits<double>::infinity(), .5);
  const int wall = testing::add_species(scene, "wall", std::numeric_limits<double>::infinity(), 4);
  testing::block(scene, 0, 0, .9).friction = FrictionLaw{.1 * seed, .3};
  testing::block(scene, 0, big, 1).friction = FrictionLaw{2, -.5};
  testing::block(scene, 0, post, .8).friction = FrictionLaw{.5, 1};
  testing::block(scene, big, big, 1);
  for (const int ball : {0, big}) testing::tether(scene, ball, wall, 3, 1, FormRule::When::permanent);
  add_particle(scene, wall, {});
  add_particle(scene, post, {.1, 0, 0});
  for (int n = 0; n < 4; ++n) {
    const int i = add_particle(scene, 0, {-2 + 1.4 * n, 1.5, 0}, {1. - .4 * n, -.6 + .01 * seed, 0});
    set_spin(scene, static_cast<std::size_t>(i), {.5 * n, seed % 2 == 0 ? 0. : .3, 0});
  }
  add_particle(scene, big, {-1.2, -1.5, 0}, {.3, .4, 0});
  add_particle(scene, big, {1.2, -1.5, 0}, {-.2, .5, 0});
  return scene;
}

TEST(Friction, HonestRunsConform) {
  std::uint64_t sticks = 0, slides = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    for (const std::string& scalar : scalar_names()) {
      for (const Timing timing : {Timing::stable, Timing::certified}) {
        RunOptions options = testing::options_for(scalar);
        if (!can_be_timed(options.scalar, timing) || (seed > 2 && scalar != "double")) continue;
        certified::ExactTiming certifier;
        options.timing = timing;
        options.certifier = &certifier;
        const testing::TracedRun run = testing::traced(busy(seed), options);
        for (const std::string& line : run.lines) {
          sticks += line.find("\"sticks\"") != std::string::npos ? 1U : 0U;
          slides += line.find("\"slides\"") != std::string::npos ? 1U : 0U;
        }
        const check::CheckReport report = checked(run.bytes);
        ASSERT_TRUE(report.conforming()) << seed << ' ' << scalar << ": " << first_finding(report);
        ASSERT_EQ(report.undecided(), 0U) << seed << ' ' << scalar << ": " << first_finding(report);
      }
    }
  }
  EXPECT_GE(sticks, 100U);
  EXPECT_GE(slides, 100U);
}

/// Both are left at rest, or nearly: no error of a velocity is multiplied by one, and the roundings of the
/// balance itself are what is left.
TEST(Friction, HeadOnWithoutRestitutionConforms) {
  std::mt19937_64 random(11);
  const auto between = [&](double a, double b) { return std::uniform_real_distribution<>(a, b)(random); };
  for (int n = 0; n < 300; ++n) {
    Scene scene = testing::plain_scene(2 + n % 2);
    scene.duration = 200;
    const int other = testing::add_species(scene, "other", between(.1, 9), between(.2, .6));
    testing::block(scene, 0, other, n % 4 == 3 ? 1e-3 : 0).friction =
        FrictionLaw{between(0, 2), between(-1, 1)};
    const double along = between(.1, 1), across = n % 3 == 0 ? std::ldexp(along, -40) : 0;
    add_particle(scene, 0, {}, {along / 3, across, 0});
    add_particle(scene, other, {between(1.2, 3), 0, 0}, {n % 5 == 0 ? -along : 0, 0, 0});
    const testing::TracedRun run = testing::traced(scene, n % 10 == 0 ? "float" : "double");
    ASSERT_GE(run.events.size(), 1U) << n;
    const check::CheckReport report = checked(run.bytes);
    ASSERT_TRUE(report.conforming()) << n << ": " << first_finding(report);
  }
}

void add(json& hex, double by) {
  hex = to_hex(std::strtod(hex.get<std::string>().c_str(), nullptr) + by);
}

TEST(Friction, LiesAreTold) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const testing::TracedRun run = testing::traced(busy(seed));
    for (const int which : {0, 4, 9}) {
      const auto first_with_spin = [](json& side) -> json& {
        for (auto& [id, particle] : side.items())
          if (particle.contains("spin")) return particle["spin"];
        return side;
      };
      const auto faster = [&](json& event) { add(first_with_spin(event["post"])[0], 1e-11); };
      EXPECT_GT(violated(checked(with_line(run, "contact", which, faster)), check::Rule::impulse), 0U)
          << seed;
      const auto jumped = [&](json& event) { add(first_with_spin(event["pre"])[0], 1e-11); };
      EXPECT_GT(violated(checked(with_line(run, "contact", which, jumped)), check::Rule::bystanders), 0U)
          << seed;
      const auto pushed = [](json& event) { add(event["dp"][1], 1e-11); };
      EXPECT_GT(violated(checked(with_line(run, "contact", which, pushed)), check::Rule::impulse), 0U)
          << seed;
      const auto other = [](json& event) {
        event["contact"] = event["contact"] == "sticks" ? "slides" : "sticks";
      };
      EXPECT_EQ(violated(checked(with_line(run, "contact", which, other)), check::Rule::impulse), 1U) << seed;
      const auto silent = [](json& event) {
        for (const char* side : {"pre", "post"})
          for (auto& [id, particle] : event[side].items()) particle.erase("spin");
      };
      EXPECT_GT(violated(checked(with_line(run, "contact", which, silent)), check::Rule::schema), 0U) << seed;
      // All spins that friction makes are turned the other way: the balance tells, beside the law.
      const auto reversed = [](json& event) {
        for (auto& [id, particle] : event["post"].items())
          if (particle.contains("spin"))
            for (auto& x : particle["spin"])
              x = to_hex(-std::strtod(x.get<std::string>().c_str(), nullptr) + .125);
      };
      EXPECT_GT(violated(checked(with_line(run, "contact", which, reversed)), check::Rule::impulse), 0U)
          << seed;
    }
    const auto of_state = [](json& event) {
      event.erase("checksum");
      for (auto& particle : event["particles"])
        if (particle.contains("spin")) return add(particle["spin"][0], 1e-9);
    };
    EXPECT_GT(violated(checked(with_line(run, "state", 1, of_state)), check::Rule::states), 0U) << seed;
  }
}

/// The run as a program would write it that records no more than it must, with its spins or without.
std::string minimal(const testing::TracedRun& run, bool spins) {
  std::string bytes;
  for (const std::string& text : run.lines) {
    const json line = json::parse(text);
    json told;
    if (line.contains("trace")) {
      told = {{"trace", 1}, {"form", "minimal"}, {"scalar", line["scalar"]}, {"scene", line["scene"]}};
      told["positions"] = "lazy";
    } else if (line.contains("kind")) {
      for (const char* key : {"t", "kind", "i", "j", "wall", "face"})
        if (line.contains(key)) told[key] = line[key];
      for (const auto& [id, particle] : line["post"].items()) {
        told["post"][id]["velocity"] = particle["velocity"];
        if (spins && particle.contains("spin")) told["post"][id]["spin"] = particle["spin"];
      }
    } else if (line.contains("end")) {
      told = line;
    } else {
      continue;
    }
    bytes += told.dump() + "\n";
  }
  return bytes;
}

TEST(Friction, AMinimalTraceHasItsSpins) {
  const testing::TracedRun run = testing::traced(busy(1));
  const check::CheckReport with = checked(minimal(run, true));
  EXPECT_TRUE(with.conforming()) << first_finding(with);
  const check::CheckReport without = checked(minimal(run, false));
  EXPECT_GT(violated(without, check::Rule::schema), 0U);
  EXPECT_NE(first_finding(without).find("\"spin\" in \"post\" is missing"), std::string::npos)
      << first_finding(without);
}

// Spins where nothing turns them, and friction of another pair.
TEST(Friction, NothingTurnsWithoutIt) {
  const testing::TracedRun run = testing::traced(busy(2));
  const auto turned = [](json& event) {
    for (const char* side : {"pre", "post"})
      for (auto& [id, particle] : event[side].items()) particle["spin"] = json::array({"0x1p+0"});
  };
  EXPECT_GT(violated(checked(with_line(run, "tether", 0, turned)), check::Rule::bystanders) +
                violated(checked(with_line(run, "kind", 1, turned)), check::Rule::bystanders),
            0U);
}

// A pair's distance is the sum of its radii rounded in double; spins are turned at the radii themselves. In a
// scalar wider than double the two differ by many of its roundings.
TEST(Friction, RadiiWhoseSumIsNoDouble) {
  std::mt19937 random(3);
  const auto draw = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int n = 0; n < 60; ++n) {
    Scene scene = testing::plain_scene(2 + n % 2);
    scene.duration = 20;
    scene.species[0].radius = n == 0 ? .3 : draw(.05, .6);
    const int other = testing::add_species(scene, "other", draw(.1, 9), n == 0 ? .5 : draw(.05, .6));
    testing::block(scene, 0, other, draw(.5, 1)).friction = FrictionLaw{draw(0, 2), draw(-1, 1)};
    add_particle(scene, 0, {0, 0, 0}, {1, 0, 0});
    add_particle(scene, other, {2, draw(-.05, .05), 0}, {-draw(0, 1), 0, 0});
    set_spin(scene, 0, {draw(-3, 3), draw(-3, 3) * (n % 2), 0});
    for (const std::string& scalar : scalar_names()) {
      const testing::TracedRun run = testing::traced(scene, testing::options_for(scalar));
      ASSERT_EQ(run.events.size(), 1U);
      const check::CheckReport report = checked(run.bytes);
      ASSERT_TRUE(report.conforming()) << n << ' ' << scalar << ": " << first_finding(report);
    }
  }
}

}  // namespace
}  // namespace friction_check
}  // namespace tps

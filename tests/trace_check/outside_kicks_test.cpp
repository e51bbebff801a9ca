// The check and what comes from outside: gravity and kicks at random times: honest runs conform in every
// scalar and timing; a kick that comes at another time, on another particle, with another impulse or not at
// all is told by its rule.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "reference/scene/write_scene.hpp"
#include "reference/text/hexfloat.hpp"
#include "tests/run/resumed_run.hpp"
#include "tests/run/traced_run.hpp"
#include "tests/trace_check/checked_trace.hpp"
#include "verify/certified/exact_timing.hpp"
#include "verify/trace_check/check.hpp"

namespace tps {
namespace {

using nlohmann::json;
using testing::add_particle;
using testing::first_finding;
using testing::violated;
using testing::with_event;

/// Balls in a container, of two species; one is pushed at random times, the other, unless bodies are grouped,
/// is thermalised.
Scene busy(unsigned seed, bool grouped) {
  Scene scene = testing::plain_scene(2 + static_cast<int>(seed % 2));
  scene.seed = seed;
  scene.duration = 12;
  scene.species[0].random_impulses = RandomImpulses{.7, seed % 3 == 0 ? .6 : 2, .4};
  const int bath = testing::add_species(scene, "bath", 3, .4);
  if (!grouped) scene.species[1].thermostat = Thermostat{1.3, .5};
  if (grouped) scene.grouping = Grouping{.05};
  if (seed % 2 == 0) scene.gravity = Gravity{{.1, -.3, 0}, .11};
  const int wall = testing::add_species(scene, "wall", std::numeric_limits<double>::infinity(), 4);
  testing::block(scene, 0, 0, .9);
  testing::block(scene, 0, bath, 1);
  testing::block(scene, bath, bath, .5);
  testing::tether(scene, 0, bath, 1.8, .7, FormRule::When::always);
  for (const int ball : {0, bath}) testing::tether(scene, ball, wall, 3.4, 1, FormRule::When::permanent);
  add_particle(scene, wall, {});
  for (int n = 0; n < 3; ++n) {
    add_particle(scene, 0, {-2 + 2. * n, 1.1, 0}, {.3, -.1 * n, 0});
    add_particle(scene, bath, {-2 + 2. * n, -1.1, 0}, {0, .2, 0});
  }
  return scene;
}

testing::TracedRun honest(const Scene& scene, const std::string& scalar, Timing timing,
                          certified::ExactTiming& certifier) {
  RunOptions options = testing::options_for(scalar, 250);
  options.timing = can_be_timed(options.scalar, timing) ? timing : Timing::stable;
  options.certifier = &certifier;
  return testing::traced(scene, options);
}

check::CheckReport checked(const std::string& bytes, bool trust_draws = false) {
  check::CheckOptions options;
  options.trust_draws = trust_draws;
  return testing::checked(bytes, options);
}

TEST(OutsideKicks, HonestRunsConform) {
  std::uint64_t kicks = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    for (const char* scalar : {"float", "double", "long-double", "quad", "mp50"}) {
      const bool is_wide = scalar != std::string("float") && scalar != std::string("double");
      if (is_wide && seed > 2) continue;
      for (const Timing timing : {Timing::stable, Timing::certified}) {
        certified::ExactTiming certifier;
        const testing::TracedRun run = honest(busy(seed, seed % 4 == 0), scalar, timing, certifier);
        for (const char* kind : {"random_impulse", "thermostat", "gravity"}) {
          const auto found = run.summary.by_kind.find(kind);
          if (found != run.summary.by_kind.end()) kicks += found->second;
        }
        const check::CheckReport report = checked(run.bytes);
        ASSERT_TRUE(report.conforming()) << seed << ' ' << scalar << ": " << first_finding(report);
        ASSERT_EQ(report.undecided(), 0U) << seed << ' ' << scalar << ": " << first_finding(report);
        EXPECT_LE(std::abs(run.summary.energy_remainder), run.summary.energy_bound) << seed << ' ' << scalar;
        if (timing == Timing::stable && scalar != std::string("double")) break;
      }
    }
  }
  EXPECT_GE(kicks, 100U);
}

std::string next_up(const json& hex) {
  const double x = std::strtod(hex.get<std::string>().c_str(), nullptr);
  return to_hex(std::nextafter(x, x < 0 ? -HUGE_VAL : HUGE_VAL));
}

TEST(RandomKicks, LiesAreTold) {
  certified::ExactTiming certifier;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const testing::TracedRun run = honest(busy(seed, false), "double", Timing::stable, certifier);
    for (const char* kind : {"random_impulse", "thermostat"}) {
      for (const int which : {0, 3}) {
        const auto larger = [](json& event) {
          event["dp"][0] = to_hex(std::strtod(event["dp"][0].get<std::string>().c_str(), nullptr) + 1e-12);
          return true;
        };
        EXPECT_GT(violated(checked(with_event(run, kind, which, larger)), check::Rule::impulse), 0U)
            << seed << kind;
        const auto dropped = [](json&) { return false; };
        EXPECT_GT(violated(checked(with_event(run, kind, which, dropped)), check::Rule::earliest), 0U)
            << seed << kind;
        const auto renamed = [&](json& event) {
          event["kind"] = std::string(kind) == "thermostat" ? "random_impulse" : "thermostat";
          return true;
        };
        EXPECT_GT(violated(checked(with_event(run, kind, which, renamed)), check::Rule::earliest), 0U)
            << seed << kind;
        const auto late = [](json& event) {
          event["t"] = next_up(event["t"]);
          return true;
        };
        EXPECT_GT(violated(checked(with_event(run, kind, which, late)), check::Rule::earliest), 0U)
            << seed << kind;
      }
    }
  }
}

TEST(Gravity, LiesAreTold) {
  certified::ExactTiming certifier;
  for (unsigned seed = 2; seed <= 8; seed += 2) {
    const testing::TracedRun run = honest(busy(seed, seed == 4), "double", Timing::stable, certifier);
    for (const int which : {0, 2, 9}) {
      const auto larger = [](json& event) {
        event["dv"][1] = next_up(next_up(event["dv"][1]));
        return true;
      };
      EXPECT_GT(violated(checked(with_event(run, "gravity", which, larger)), check::Rule::impulse), 0U)
          << seed;
      const auto dropped = [](json&) { return false; };
      EXPECT_GT(violated(checked(with_event(run, "gravity", which, dropped)), check::Rule::earliest), 0U)
          << seed;
      const auto late = [](json& event) {
        event["t"] = next_up(event["t"]);
        return true;
      };
      EXPECT_GT(violated(checked(with_event(run, "gravity", which, late)), check::Rule::earliest), 0U)
          << seed;
    }
  }
}

// By another generator's draws times and sizes are not ours to judge; what they do to velocities is.
TEST(RandomKicks, AreTakenAsGivenWhereDrawsAreTrusted) {
  certified::ExactTiming certifier;
  const testing::TracedRun run = honest(busy(1, false), "double", Timing::stable, certifier);
  std::string other = run.bytes;
  const std::size_t at = other.find("\"seed\":1");
  ASSERT_NE(at, std::string::npos);
  other.replace(at, 8, "\"seed\":2");
  EXPECT_GT(checked(other).violated(), 0U);
  const check::CheckReport trusted = checked(run.bytes, true);
  EXPECT_TRUE(trusted.conforming()) << first_finding(trusted);
  EXPECT_TRUE(trusted.partial());
  const auto turned = [](json& event) {
    event["dp"][0] = to_hex(-std::strtod(event["dp"][0].get<std::string>().c_str(), nullptr));
    return true;
  };
  EXPECT_GT(violated(checked(with_event(run, "random_impulse", 2, turned), true), check::Rule::impulse), 0U);
}

TEST(RandomKicks, AResumedRunGoesOnToTheSameBytes) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    RunOptions options = testing::options_for("double", 200);
    options.state_every = 10;
    SCOPED_TRACE(seed);
    testing::expect_same_when_resumed(busy(seed, seed == 4), options);
  }
}

// A scene may have any number of events between two lines of a trace: so many missing ones are told, and not
// the rest of them.
TEST(Gravity, MissingImpulsesAreNotCountedForEver) {
  for (const double every : {1e-300, 1e-9}) {
    Scene scene = testing::plain_scene(2);
    scene.duration = 1;
    scene.gravity = Gravity{{0, -1, 0}, every};
    add_particle(scene, 0, {}, {1, 0, 0});
    const json head{
        {"trace", 1}, {"form", "minimal"}, {"scalar", "double"}, {"scene", json::parse(write_scene(scene))}};
    const json end{{"end", "duration"}, {"t", 1}, {"events", 0}};
    const check::CheckReport report = testing::checked(head.dump() + "\n" + end.dump() + "\n");
    EXPECT_EQ(violated(report, check::Rule::earliest), 1000U) << every;
    EXPECT_NE(report.of(check::Rule::earliest).not_judged.find("1000 in a row"), std::string::npos) << every;
  }
}

}  // namespace
}  // namespace tps

// Traces of other programs: honest ones pass, what cannot be judged is said, other readings are named.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/run/traced_run.hpp"
#include "tests/trace_check/broken_trace.hpp"
#include "tests/trace_check/checked_trace.hpp"
#include "tests/trace_check/paper_loop.hpp"
#include "tests/trace_check/scenes.hpp"
#include "verify/scenes/gas.hpp"
#include "verify/trace_check/check.hpp"

namespace tps::mutation {
namespace {

using check::CheckOptions;
using check::CheckReport;
using check::Rule;
using testing::checked;
using testing::says;

CheckReport checked_case(const std::string& name) {
  return check::check_trace(TPS_SOURCE_DIR "/tests/trace_check/cases/" + name + ".ndjson");
}

/// The minimal form of a full trace of doubles: times, kinds and velocities; `positions` as the header says
/// it.
std::string as_minimal(const std::string& bytes, const std::string& how_t,
                       const std::string& positions = "") {
  std::string text;
  std::size_t begin = 0;
  for (std::size_t end = bytes.find('\n'); end != std::string::npos;
       begin = end + 1, end = bytes.find('\n', begin)) {
    const Json line = Json::parse(bytes.substr(begin, end - begin));
    Json kept = Json::object();
    if (line.contains("trace")) {
      kept = {{"trace", 1}, {"form", "minimal"}, {"scalar", "double"}, {"scene", line.at("scene")}};
      if (!positions.empty()) kept["positions"] = positions;
    } else if (is_state(line)) {
      continue;
    } else {
      const double t = number(line.at("t"));
      Json time = how_t == "hex" ? Json(to_hex<double>(t)) : Json(std::stod(fmt::format("{:.9e}", t)));
      for (const char* key : {"kind", "i", "j", "end", "events", "tether", "draw", "phase"}) {
        if (line.contains(key)) kept[key] = line.at(key);
      }
      kept["t"] = time;
      if (line.contains("post")) {
        kept["post"] = Json::object();
        for (const auto& [id, state] : line.at("post").items())
          kept["post"][id]["velocity"] = state.at("velocity");
      }
    }
    text += kept.dump() + "\n";
  }
  return text;
}

constexpr int kRuns = 150;

TEST(Foreign, ProgramsThatAdvanceEverybodyConformAndAreRecognised) {
  int recognised = 0;
  for (int n = 0; n < kRuns; ++n) {
    const CheckReport report = checked(PaperLoop(random_chain(static_cast<std::uint64_t>(n))).trace(60));
    EXPECT_TRUE(report.conforming()) << n << '\n' << report_text(report);
    EXPECT_EQ(report.events, 60U);
    recognised += report.notes.empty() ? 0 : 1;
  }
  EXPECT_GT(recognised, 10);  // the others round so little that the narrower bounds hold
}

TEST(Foreign, ProgramsThatSaySoAreJudgedAsTheySay) {
  for (int n = 0; n < kRuns / 5; ++n) {
    const auto seed = static_cast<std::uint64_t>(n);
    EXPECT_TRUE(checked(PaperLoop(random_chain(seed)).trace(60, R"(,"positions":"eager")")).conforming())
        << n;
  }
}

// A thousandth of a velocity's 1e-9th is far beyond what advancing everybody costs.
TEST(Foreign, TheWiderBoundsOfProgramsThatAdvanceEverybodyStillSeeErrors) {
  for (int n = 0; n < kRuns; ++n) {
    std::string text = PaperLoop(random_chain(static_cast<std::uint64_t>(n))).trace(60);
    std::size_t at = 0;
    for (int line = 0; line < 20 + n % 20; ++line) at = text.find('\n', at) + 1;
    const std::size_t velocity = text.find(R"("velocity":["0x1.)", at);
    const std::size_t negative = text.find(R"("velocity":["-0x1.)", at);
    const std::size_t digit = std::min(velocity + 17, negative + 18) + 8;  // 2^-36 of it
    text[digit] = text[digit] == '8' ? '9' : '8';
    EXPECT_FALSE(checked(text).conforming()) << n;
  }
}

TEST(Foreign, APlaceOfTheFirstFlightIsRounded) {
  EXPECT_TRUE(checked_case("lazy_far_from_origin").conforming());
}

// u + v dt is rounded to a share of u, which far from the origin is a large one of the distance.
TEST(Foreign, PlacesFarFromTheOriginAreRoundedInTheFirstFlight) {
  for (int n = 0; n < 2 * kRuns; ++n) {
    Scene scene = build_gas({.particles = 6,
                             .density = .3,
                             .restitution = .9,
                             .duration = 10,
                             .seed = static_cast<std::uint64_t>(n + 1)});
    const double far = std::exp2(10 + n % 20);
    for (Particle& particle : scene.particles) {
      for (double& x : particle.position) x += far;
    }
    const std::string trace = trace_bytes(scene, "double", Timing::stable, 20);
    const CheckReport report = checked(as_minimal(trace, "hex", "lazy"));
    EXPECT_TRUE(report.conforming()) << n << '\n' << report_text(report);
  }
}

TEST(Foreign, TimesOfOneDoubleAreRoundedInEveryRule) {
  for (int n = 0; n < kRuns / 3; ++n) {
    Scene scene = build_gas({.particles = 12,
                             .density = .2,
                             .restitution = 1,
                             .duration = 100,
                             .seed = static_cast<std::uint64_t>(n + 1)});
    scene.start_time = n % 3 == 0 ? 0 : std::exp2(n % 20);
    scene.impulses = {{.at = .3, .particle = 3, .impulse = {800, 20, -1}},
                      {.at = .7, .particle = 5, .impulse = {-300, 2, 900}}};
    const CheckReport report = checked(as_minimal(trace_bytes(scene, "double", Timing::stable, 60), "hex"));
    EXPECT_TRUE(report.conforming()) << n << '\n' << report_text(report);
  }
}

TEST(Foreign, TimesOfTenDigitsAreExplainedOnce) {
  for (int n = 0; n < 20; ++n) {
    const Scene scene = build_gas({.particles = 12,
                                   .density = .2,
                                   .restitution = 1,
                                   .duration = 100,
                                   .seed = static_cast<std::uint64_t>(n + 1)});
    const std::string full = trace_bytes(scene, "double", Timing::stable, 60);
    const CheckReport report = checked(as_minimal(full, "decimal"));
    EXPECT_FALSE(report.conforming());
    ASSERT_EQ(report.notes.size(), 1U) << report_text(report);
    EXPECT_NE(report.notes[0].find("the times look like decimals of 10 digits"), std::string::npos)
        << report.notes[0];
    EXPECT_TRUE(checked(as_minimal(full, "hex")).notes.empty());
  }
}

TEST(Foreign, MembersMayBeListedAtARestitutionAndHaveTheVelocityOfTheirSide) {
  const CheckReport honest = checked_case("restitute_lists_members");
  EXPECT_TRUE(honest.conforming()) << report_text(honest);
  std::string wrong =
      testing::read_bytes(TPS_SOURCE_DIR "/tests/trace_check/cases/restitute_lists_members.ndjson");
  const std::size_t event = wrong.find(R"("i": 1, "j": 2, "post": {"0")", wrong.find("restitute"));
  wrong.replace(wrong.find("05169ae200p-11", event), 14, "05169ae201p-11");
  EXPECT_GT(checked(wrong).of(Rule::groups).violated, 0U);
}

TEST(Foreign, OtherReadingsAreNamed) {
  EXPECT_TRUE(says(checked_case("reading_wall_joins_group"), "another reading of the paper, decision D9"));
  int named = 0;
  for (int n = 0; n < 20; ++n) {
    const CheckReport report =
        checked(PaperLoop(random_chain(static_cast<std::uint64_t>(n), .5), true).trace(60));
    named += says(report, "decision D4: c_revolve") ? 1 : 0;
  }
  EXPECT_GT(named, 15);
}

TEST(NotJudged, IsSaid) {
  const CheckReport states = checked_case("states_all_missing");
  EXPECT_TRUE(says(states, "not judged states: the trace has no full states"));
  EXPECT_FALSE(says(states, "conforming: every step"));
  const CheckReport late = checked_case("minimal_start_2p53_impulse_rotated_half_radian");
  EXPECT_TRUE(says(late, "not judged impulse: 1 step")) << report_text(late);
  EXPECT_NE(report_json(late).find("where the axis of 0-1 is uncertain"), std::string::npos);
  EXPECT_NE(report_junit(late).find("<skipped message=\"1 step"), std::string::npos) << report_junit(late);
  EXPECT_THROW(checked_case("hdr_semantics_99"), std::exception);
}

// The later a minimal trace starts, the less of it is judged; whatever is wrong with an impulse is seen or
// said.
TEST(NotJudged, AWrongImpulseIsSeenOrSaidAtAnyStartTime) {
  for (int exponent = 0; exponent <= 60; ++exponent) {
    Scene scene = random_chain(7);
    scene.start_time = std::exp2(exponent);
    std::string text = PaperLoop(scene).trace(1);
    const std::size_t velocity = text.find(R"("velocity":[")", text.find('\n'));
    const std::size_t sign = velocity + 13 - 1;
    if (text[sign] == '-')
      text.erase(sign, 1);
    else
      text.insert(sign, "-");
    const CheckReport report = checked(text);
    EXPECT_TRUE(report.violated() > 0 || says(report, "not judged impulse")) << exponent << '\n'
                                                                             << report_text(report);
  }
}

TEST(Wrong, SpeedAfterARevolutionAndHeavyLoadsAreSeen) {
  EXPECT_GT(checked_case("energy_revolve_2e-16_10").of(Rule::conservation).violated, 0U);
  EXPECT_GT(checked_case("load_heavy_1e+12_1.0001").of(Rule::impulse).violated, 0U);
}

TEST(Wrong, AVelocityThatChangesByAnUlpAtABreak) {
  const NamedScene named = scene_named("dicing");
  const Trace good = trace_of(trace_bytes(named.scene, "double", Timing::stable, named.events));
  int breaks = 0;
  for (const std::size_t line : event_lines(good)) {
    if (good.lines[line].at("kind") != "break") continue;
    Trace bad = good;
    Json& event = bad.lines.change(line);
    Json& velocity = event.at("post").at(key(event.at("i"))).at("velocity");
    velocity[0] = stepped(bad, velocity[0], 1);
    EXPECT_GT(checked(text_of(bad)).of(Rule::impulse).violated, 0U);
    ++breaks;
  }
  EXPECT_GE(breaks, 3);
}

TEST(Draws, AreThoseOfTheSeedUnlessTrusted) {
  const NamedScene named = scene_named("dicing");
  Scene other = named.scene;
  other.seed += 1;
  Trace trace = trace_of(trace_bytes(named.scene, "double", Timing::stable, named.events));
  trace.lines.change(0).at("scene")["seed"] = other.seed;
  const std::string bytes = text_of(trace);
  EXPECT_GT(checked(bytes).of(Rule::tethers).violated, 0U);
  CheckOptions trusting;
  trusting.trust_draws = true;
  const CheckReport report = checked(bytes, trusting);
  EXPECT_TRUE(report.conforming()) << report_text(report);
  EXPECT_TRUE(says(report, "not judged tethers: the draws are taken as given"));
  trace.lines.change(0)["draws"] = "recorded";
  EXPECT_TRUE(checked(text_of(trace)).conforming());
}

/// Eq. (5) says how fast a pair is after a revolution, whatever its axis; a trace without Δp whose clock is
/// late leaves the axis of a pull that is nearly head-on open, and its speed passed with it.
TEST(ForeignTraces, WhoseRevolutionsHaveAnotherSpeedAreFound) {
  for (const char* name : {"revolution_at_a_tenth_of_its_speed", "revolution_of_the_speed_across_grouped"}) {
    const CheckReport report = checked_case(name);
    EXPECT_FALSE(report.conforming()) << name;
    EXPECT_TRUE(says(report, "energy")) << name << '\n' << report_text(report);
  }
}

/// Pulls that are nearly head-on, on an early and a late clock, grouped and not: no other speed after them
/// passes.
TEST(ForeignTraces, AreHeldToTheSpeedAfterAPullThatIsNearlyHeadOn) {
  for (const double start : {0., 0x1p40}) {
    for (const double across : {1e-17, 1e-6, 1e-4, 1e-3}) {
      for (const bool grouped : {false, true}) {
        Scene scene = testing::plain_scene();
        scene.start_time = start;
        if (grouped) scene.grouping = Grouping{.01};
        const int anchor = testing::add_species(scene, "anchor", HUGE_VAL, 0);
        PairLaw& law = testing::tether(scene, 0, anchor, .4, 0, FormRule::When::permanent);
        law.tethering->c_revolve = .9;
        law.tethering->theta_revolve_deg = 1;
        testing::add_particle(scene, anchor, {0, 0, 0});
        testing::add_particle(scene, 0, {.3, across, 0}, {.7, 0, 0});
        std::string bytes = as_minimal(trace_bytes(scene, "double", Timing::stable, grouped ? 2 : 1), "hex");
        const std::string what = fmt::format("start {}, across {}, grouped {}", start, across, grouped);
        ASSERT_TRUE(checked(bytes).conforming()) << what << '\n' << report_text(checked(bytes));
        const std::size_t at = bytes.rfind("{\"kind\"");
        const std::string end = bytes.substr(bytes.find('\n', at));
        const Json event = Json::parse(bytes.substr(at, bytes.find('\n', at) - at));
        ASSERT_EQ(event.at("kind"), grouped ? "restitute" : "revolve") << what;
        for (const double factor : {.001, .1, .5, .9, 1.1, 1.5, 1.9}) {
          Json lie = event;
          for (Json& component : lie["post"]["1"]["velocity"]) component = factor * number(component);
          const CheckReport report = checked(bytes.substr(0, at) + lie.dump() + end);
          EXPECT_FALSE(report.conforming()) << what << ", times " << factor << '\n' << report_text(report);
        }
      }
    }
  }
}

/// m v' − m v for m (v' − v), and v' as v + Δp/m is stored.
TEST(ForeignTraces, OfAThermostatRoundTheirImpulseInTheirWay) {
  for (const char* name : {"thermostat_dp_of_products", "thermostat_dp_of_stored_velocities"}) {
    const CheckReport report = checked_case(name);
    EXPECT_TRUE(report.conforming()) << name << '\n' << report_text(report);
  }
}

}  // namespace
}  // namespace tps::mutation

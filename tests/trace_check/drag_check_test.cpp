// The check and drag: honest runs conform in every scalar and timing; a time, a clock or an end that is not
// theirs is told. The printed time is compared with integers that share no code with it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "reference/engine/drag_clock.hpp"
#include "reference/text/hexfloat.hpp"
#include "reference/text/input_error.hpp"
#include "tests/run/traced_run.hpp"
#include "tests/trace_check/checked_trace.hpp"
#include "verify/certified/exact_timing.hpp"
#include "verify/exact/drag_time.hpp"
#include "verify/trace_check/check.hpp"

namespace tps {
namespace drag_check {
namespace {

using nlohmann::json;
using testing::add_particle;
using testing::first_finding;
using testing::violated;
using testing::with_line;

Scene busy(unsigned seed) {
  Scene scene = testing::plain_scene(2 + static_cast<int>(seed % 2));
  scene.drag = Drag{.02 * seed};
  scene.start_time = seed % 3 == 0 ? 1e6 : seed % 3 == 1 ? .1 : 0;  // .1 + 12 and + 1.3 are no doubles
  scene.duration = 12;
  const int wall = testing::add_species(scene, "wall", std::numeric_limits<double>::infinity(), 4);
  testing::block(scene, 0, 0, .9);
  testing::tether(scene, 0, 0, 1.8, .7, FormRule::When::always).tethering->breaks = {
      BreakRule::When::impulse_above, 0, .45};
  testing::tether(scene, 0, wall, 3.4, 1, FormRule::When::permanent);
  add_particle(scene, wall, {});
  for (int n = 0; n < 6; ++n)
    add_particle(scene, 0, {-2 + 1.5 * (n % 3), n < 3 ? 1. : -1., 0},
                 {1. - .3 * n, .2 * n - .5 + .01 * seed, 0});
  return scene;
}

check::CheckReport checked(const std::string& bytes) {
  check::CheckOptions options;
  options.max_reports = 1000;
  return testing::checked(bytes, options);
}

TEST(Drag, HonestRunsConform) {
  std::uint64_t events = 0, breaks = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    for (const std::string& scalar : scalar_names()) {
      for (const Timing timing : {Timing::stable, Timing::certified}) {
        RunOptions options = testing::options_for(scalar);
        if (!can_be_timed(options.scalar, timing) || (seed > 2 && scalar != "double")) continue;
        certified::ExactTiming certifier;
        options.timing = timing;
        options.certifier = &certifier;
        const testing::TracedRun run = testing::traced(busy(seed), options);
        events += run.summary.events;
        breaks += run.summary.by_kind.contains("break") ? run.summary.by_kind.at("break") : 0;
        const check::CheckReport report = checked(run.bytes);
        ASSERT_TRUE(report.conforming()) << seed << ' ' << scalar << ": " << first_finding(report);
        ASSERT_EQ(report.undecided(), 0U) << seed << ' ' << scalar << ": " << first_finding(report);
      }
    }
  }
  EXPECT_GE(events, 400U);
  EXPECT_GE(breaks, 10U);
}

void move(json& hex, double towards) {
  hex = to_hex(std::nextafter(std::strtod(hex.get<std::string>().c_str(), nullptr), towards));
}

TEST(Drag, LiesAreTold) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const testing::TracedRun run = testing::traced(busy(seed));
    for (const int which : {1, 7}) {
      for (const double towards : {0., 1e9}) {
        const auto time = [&](json& event) { move(event["t"], towards); };
        EXPECT_EQ(violated(checked(with_line(run, "ds", which, time)), check::Rule::order), 1U) << seed;
        EXPECT_GT(violated(checked(with_line(run, "state", which % 2, time)), check::Rule::states), 0U)
            << seed;
        const auto clock = [&](json& event) { move(event["s"], towards); };
        EXPECT_GT(violated(checked(with_line(run, "ds", which, clock)), check::Rule::order), 0U) << seed;
        EXPECT_GT(violated(checked(with_line(run, "end", 0, clock)), check::Rule::end), 0U) << seed;
      }
      const auto renamed = [](json& event) {
        event["dt"] = event["ds"];
        event.erase("ds");
      };
      EXPECT_GT(violated(checked(with_line(run, "ds", which, renamed)), check::Rule::schema), 0U) << seed;
      const auto without = [](json& event) { event.erase("s"); };
      EXPECT_GT(violated(checked(with_line(run, "ds", which, without)), check::Rule::schema), 0U) << seed;
    }
  }
}

// s of a long run is counted on beyond 1/γ: such an event has no time.
TEST(Drag, NothingHappensWhenTheClockHasRunOut) {
  Scene scene = testing::plain_scene();
  scene.duration = 12;
  testing::block(scene, 0, 0);
  add_particle(scene, 0, {}, {1, 0, 0});
  add_particle(scene, 0, {6, 0, 0});  // met at s = 5
  const testing::TracedRun free = testing::traced(scene);
  std::string bytes = free.bytes;
  const std::string from = "\"species\"";
  bytes.insert(bytes.find(from), "\"drag\":{\"gamma\":0.25},");
  std::string told;
  for (std::size_t n = 0; n < free.lines.size(); ++n) {
    json line = json::parse(n == 0 ? bytes.substr(0, bytes.find('\n')) : free.lines[n]);
    if (n == 0) line.erase("checksum");
    if (line.contains("state")) continue;
    if (line.contains("dt")) line["ds"] = line["dt"], line.erase("dt");
    if (n > 0) line["s"] = line["t"];
    told += line.dump() + "\n";
  }
  const check::CheckReport report = checked(told);
  bool says_so = false;
  for (const auto& finding : report.findings)
    says_so = says_so || finding.message.find("never comes to that") != std::string::npos;
  ASSERT_EQ(free.events.size(), 1U);
  EXPECT_TRUE(says_so) << first_finding(report);
}

/// The same trace, of velocities alone. `start` becomes the scene's, times are moved with it.
std::string minimal_of(const testing::TracedRun& run, double start) {
  std::string bytes;
  for (const std::string& text : run.lines) {
    json line = json::parse(text);
    if (line.contains("state")) continue;
    if (line.contains("trace")) {
      line = {{"trace", 1}, {"form", "minimal"}, {"scalar", line["scalar"]}, {"scene", line["scene"]}};
      line["scene"]["start_time"] = start;
    } else {
      const double t = std::strtod(line["t"].get<std::string>().c_str(), nullptr);
      line["t"] = start + t;
      for (const char* key : {"k", "ds", "pre", "dp"}) line.erase(key);
      if (line.contains("post")) {
        for (json& state : line["post"]) state.erase("position");
      }
    }
    bytes += line.dump() + "\n";
  }
  return bytes;
}

/// With a line of a minimal trace changed: of those with that key, the one of that number.
template <typename Edit>
std::string with_minimal_line(const std::string& bytes, const char* key, int which, Edit edit) {
  std::string changed, text;
  std::istringstream lines(bytes);
  while (std::getline(lines, text)) {
    json line = json::parse(text);
    if (line.contains(key) && which-- == 0) edit(line);
    changed += line.dump() + "\n";
  }
  return changed;
}

/// Balls that meet twice, and rebound.
Scene meeting(double gamma, double duration) {
  Scene scene = testing::plain_scene();
  scene.drag = Drag{gamma};
  scene.duration = duration;
  testing::block(scene, 0, 0);
  add_particle(scene, 0, {}, {1, 0, 0});
  add_particle(scene, 0, {2, .25, 0}, {-1, 0, 0});
  add_particle(scene, 0, {-3, 0, 0}, {.5, 0, 0});
  return scene;
}

// s counts from 0 whenever the scene starts: so does what rounding may do to it.
TEST(Drag, AMinimalTraceIsJudgedAsSharplyWhenItStartsLate) {
  const testing::TracedRun run = testing::traced(meeting(.125, 3));
  ASSERT_GE(run.events.size(), 1U);
  for (const double start : {0., -7., 0x1p40, 1e15, -1e300}) {
    const std::string bytes = minimal_of(run, start);
    const check::CheckReport report = checked(bytes);
    EXPECT_TRUE(report.conforming()) << start << ": " << first_finding(report);
    const auto later = [](json& event) {
      event["s"] = std::strtod(event["s"].get<std::string>().c_str(), nullptr) * (1 + 1e-12);
    };
    EXPECT_GT(violated(checked(with_minimal_line(bytes, "kind", 0, later)), check::Rule::contact), 0U)
        << start;
  }
}

// Any evaluation of (1 − e^{−γT})/γ is the clock of an end; another number is not.
TEST(Drag, TheClockOfTheEndOfAMinimalTraceIsThatOfItsTime) {
  for (const double gamma : {1e-6, .01, .125, 1., 3.}) {
    for (const double T : {.25, 3., 40.}) {
      const testing::TracedRun run = testing::traced(meeting(gamma, T));
      ASSERT_EQ(run.summary.end, "duration");
      for (const double start : {0., .1, -1000.}) {
        const std::string bytes = minimal_of(run, start);
        const auto with_end = [&](double s) {
          return checked(with_minimal_line(bytes, "end", 0, [&](json& end) { end["s"] = s; }));
        };
        const double naive = (1 - std::exp(-gamma * T)) / gamma, careful = -std::expm1(-gamma * T) / gamma;
        for (const double s : {naive, careful, careful * (1 - 0x1p-53)})
          EXPECT_EQ(violated(with_end(s), check::Rule::end), 0U) << gamma << ' ' << T << ' ' << start;
        EXPECT_TRUE(checked(bytes).conforming()) << first_finding(checked(bytes));
        // Twice what is allowed, and T with two roundings of |T| + |start|.
        const double off = 16 * 0x1p-53 / gamma + 4 * 0x1p-53 * (T + std::abs(start));
        for (const double s : {0., careful / 2, careful - off, careful + off})
          EXPECT_GT(violated(with_end(s), check::Rule::end), 0U)
              << gamma << ' ' << T << ' ' << start << ' ' << s;
      }
    }
  }
  const testing::TracedRun run = testing::traced(meeting(1e-20, 3));
  EXPECT_TRUE(testing::says(checked(minimal_of(run, 0)), "below its rounding"));
}

// However a program computes the time of an event from its clock, or the clock from the time, both fit;
// another time does not.
TEST(Drag, TheTimeOfAnEventOfAMinimalTraceIsThatOfItsClock) {
  for (const double gamma : {1e-9, 1e-3, .125, .9}) {
    const testing::TracedRun run = testing::traced(meeting(gamma, 3));
    ASSERT_GE(run.events.size(), 1U) << gamma;
    for (const double start : {0., .1, -1000., 1e9}) {
      const std::string bytes = minimal_of(run, start);
      const std::size_t begin = bytes.find('\n') + 1;
      const json event = json::parse(bytes.substr(begin, bytes.find('\n', begin) - begin));
      const double s = std::strtod(event["s"].get<std::string>().c_str(), nullptr);
      const auto with = [&](double t, double clock) {
        return checked(with_minimal_line(bytes, "kind", 0, [&](json& line) {
          line["t"] = t;
          line["s"] = clock;
        }));
      };
      const double naive = -std::log(1 - gamma * s) / gamma, careful = -std::log1p(-gamma * s) / gamma;
      for (const double T : {naive, careful}) {
        EXPECT_EQ(violated(with(start + T, s), check::Rule::order), 0U) << gamma << ' ' << start << ' ' << T;
        const double back = (1 - std::exp(-gamma * ((start + T) - start))) / gamma;
        EXPECT_EQ(violated(with(start + T, back), check::Rule::order), 0U) << gamma << ' ' << start;
      }
      const double off = 16 * 0x1p-53 / gamma / (1 - gamma * s) + 16 * 0x1p-53 * (careful + std::abs(start));
      for (const double T : {careful - off, careful + off, careful / 2, 2 * careful}) {
        if (std::abs(T - careful) < off) continue;
        EXPECT_GT(violated(with(start + T, s), check::Rule::order), 0U) << gamma << ' ' << start << ' ' << T;
      }
    }
  }
}

/// Every road of drag_time, to a number with no rounding in it.
TEST(DragTime, IsTheNearestDouble) {
  std::mt19937_64 random(7);
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  for (int n = 0; n < 1000; ++n) {
    const double gamma = std::ldexp(between(1, 2), static_cast<int>(between(-200, 60)));
    const double z = n % 3 == 0   ? std::ldexp(between(1, 2), static_cast<int>(between(-300, -1)))
                     : n % 3 == 1 ? between(0, 1)
                                  : 1 - std::ldexp(between(1, 2), static_cast<int>(between(-50, -2)));
    double s = z / gamma;
    while ((Dyadic{1, 0} - dyadic(gamma) * dyadic(s)).sign() <= 0) s = std::nextafter(s, 0.0);
    const double start = n % 5 == 0 ? between(-1e3, 1e6) : 0;
    const Dyadic more = n % 2 == 0 ? Dyadic{} : dyadic(s) * Dyadic{1, -53};  // a low part
    const Dyadic clock =
        (Dyadic{1, 0} - dyadic(gamma) * (dyadic(s) + more)).sign() > 0 ? dyadic(s) + more : dyadic(s);
    const double t = drag_time(gamma, clock, start);
    EXPECT_TRUE(exact::is_nearest_drag_time(gamma, clock, start, t)) << gamma << ' ' << s << ' ' << start;
  }
}

// t is 2⁻²⁰⁰ beside the middle of two doubles: long double cannot tell, 1100 bits do.
TEST(DragTime, IsTheNearestDoubleBesideMiddles) {
  for (int n = 1; n <= 40; ++n) {
    const double gamma = 1. / n;
    const Dyadic T = dyadic(1 + n * 0x1p-40) + Dyadic{1, -53};
    // s(T) to 2⁻²⁰⁰, from below and above.
    Dyadic lo{}, hi = Dyadic{n, 0};
    for (int k = 0; k < 220; ++k) {
      const Dyadic middle = (lo + hi) * Dyadic{1, -1};
      (exact::compare_drag_time(gamma, middle, T) == exact::Sign::negative ? lo : hi) = middle;
    }
    for (const Dyadic& s : {lo, hi}) {
      const double t = drag_time(gamma, s, 0);
      EXPECT_TRUE(exact::is_nearest_drag_time(gamma, s, 0, t)) << n;
    }
  }
}

TEST(DragTime, TheDurationEndsAtTheLastDoubleBeforeIt) {
  for (const double gamma : {1e-300, 1e-9, .1, 1., 3., 1e6}) {
    for (const double T : {1e-12, .1, 1., 30., 1e4}) {
      const double s = drag_clock_until(gamma, T);
      const auto comes = [&](double clock) {
        return (Dyadic{1, 0} - dyadic(gamma) * dyadic(clock)).sign() > 0 &&
               exact::compare_drag_time(gamma, dyadic(clock), dyadic(T)) != exact::Sign::positive;
      };
      EXPECT_TRUE(comes(s)) << gamma << ' ' << T;
      EXPECT_FALSE(comes(std::nextafter(s, HUGE_VAL))) << gamma << ' ' << T;
    }
    const double last = drag_clock_until(gamma, last_drag_time(0));
    EXPECT_GT((Dyadic{1, 0} - dyadic(gamma) * dyadic(last)).sign(), 0);
    EXPECT_LE((Dyadic{1, 0} - dyadic(gamma) * dyadic(std::nextafter(last, HUGE_VAL))).sign(), 0);
  }
}

// Any γ that a double has, with 1/γ and times beyond the largest double, too, and any duration down to the
// smallest one.
TEST(Drag, AnyGammaAndDurationRunsAndConforms) {
  std::mt19937 random(11);
  const auto power = [&](double low, double high) {
    return std::pow(10, std::uniform_real_distribution<double>(low, high)(random));
  };
  std::map<std::string, int> ends;
  for (int n = 0; n < 240; ++n) {
    Scene scene = testing::plain_scene();
    const double gamma = n % 3 == 0 ? power(-323, -300) : n % 3 == 1 ? power(-300, 300) : power(-2, 2);
    if (gamma == 0) continue;
    scene.drag = Drag{gamma};
    scene.duration = n % 4 == 0 ? 5e-324 : n % 4 == 1 ? power(-300, 300) : HUGE_VAL;
    constexpr double kLargest = std::numeric_limits<double>::max();
    scene.start_time = std::array{1.5e308, -7., 0., -kLargest, kLargest}[static_cast<std::size_t>(n % 5)];
    testing::block(scene, 0, 0, .75);
    // One pair meets about where 1/γ is, another one far beyond what has a time.
    const double speed = n % 2 == 0 ? std::clamp(gamma * power(-.5, .5), 1e-310, 1e300) : 1;
    add_particle(scene, 0, {}, {speed, 0, 0});
    add_particle(scene, 0, {2, 0, 0});
    if (n % 7 == 0) add_particle(scene, 0, {-8, .25, 0}, {0x1p-1073 * (1 + n), 0, 0});
    const std::string scalar = n % 6 == 0 ? "quad" : n % 6 == 1 ? "long-double" : "double";
    try {
      const testing::TracedRun run = testing::traced(scene, testing::options_for(scalar));
      ++ends[run.summary.end];
      const check::CheckReport report = checked(run.bytes);
      ASSERT_TRUE(report.conforming()) << n << ' ' << gamma << ' ' << scalar << ": " << first_finding(report);
    } catch (const InputError& refused) {
      ++ends["refused"];
    }
  }
  EXPECT_GE(ends["duration"], 60);
  EXPECT_GE(ends["no_more_events"], 30);
  EXPECT_GE(ends["out_of_range"], 5);
  EXPECT_LE(ends["refused"], 60);
}

}  // namespace
}  // namespace drag_check
}  // namespace tps

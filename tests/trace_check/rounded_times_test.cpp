// Times that are rounded: before the start, by an image of a box, and the other way than once.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "reference/scene/read_scene.hpp"
#include "reference/text/hexfloat.hpp"
#include "tests/trace_check/broken_trace.hpp"
#include "tests/trace_check/checked_trace.hpp"
#include "tests/trace_check/scenes.hpp"
#include "verify/trace_check/check.hpp"

namespace tps::mutation {
namespace {

using check::CheckReport;
using check::Rule;
using testing::checked;
using testing::says;

std::string in_lines(std::initializer_list<Json> lines) {
  std::string text;
  for (const Json& line : lines) text += line.dump() + "\n";
  return text;
}

Json discs(double duration, double start, Json particles) {
  return {{"tps", 1},
          {"dimension", 2},
          {"duration", duration},
          {"start_time", start},
          {"species", {{"a", {{"mass", 1}, {"radius", 0.5}}}}},
          {"pairs", Json::array({{{"between", {"a", "a"}}, {"blocking", {{"c_rebound", 1}}}}})},
          {"particles", std::move(particles)}};
}

Json disc(double x, double y, double v) {
  return {{"species", "a"}, {"position", {x, y}}, {"velocity", {v, 0}}};
}

// The first time is that of the start, rounded: to a float, it may lie before it.
TEST(RoundedTimes, ATimeRoundedToBeforeTheStartIsTheStart) {
  std::mt19937_64 random(3);
  int before = 0;
  for (int n = 0; n < 200; ++n) {
    const double start =
        std::ldexp(static_cast<double>(random() >> 11U) * 0x1p-53, n % 60 - 30) * (n % 3 == 0 ? -1 : 1);
    const double t = static_cast<float>(start);
    before += t < start ? 1 : 0;
    const Json post{{"0", {{"velocity", {0, 0}}}}, {"1", {{"velocity", {1, 0}}}}};
    const CheckReport report =
        checked(in_lines({{{"trace", 1},
                           {"form", "minimal"},
                           {"scalar", "float"},
                           {"scene", discs(1, start, {disc(0, 0, 1), disc(1, 0, 0)})}},
                          {{"t", t}, {"kind", "rebound"}, {"i", 0}, {"j", 1}, {"post", post}},
                          {{"end", "max_events"}, {"events", 1}, {"t", t}}}));
    EXPECT_TRUE(report.conforming()) << start << '\n' << report_text(report);
  }
  EXPECT_GT(before, 50);
}

// While a time is rounded two may fly by each other's images: which one they meet it does not say.
TEST(RoundedTimes, RoundedTimesThatAreWorthAnImageAreNotJudged) {
  for (const double v : {1., 5., 10., 20., 30., 45., 100., 1000.}) {
    const double t = static_cast<float>(1e6 + (2 - std::sqrt(1 - 0.0625)) / v);
    const Json post{{"0", {{"velocity", {v / 16, -v * std::sqrt(15.) / 16}}}},
                    {"1", {{"velocity", {v * 15 / 16, v * std::sqrt(15.) / 16}}}}};
    Json scene = discs(10, 1e6, {disc(0, 0, v), disc(2, .25, 0)});
    scene["box"] = {{"periodic", {4, 4}}};
    const CheckReport report =
        checked(in_lines({{{"trace", 1}, {"form", "minimal"}, {"scalar", "float"}, {"scene", scene}},
                          {{"t", t}, {"kind", "rebound"}, {"i", 0}, {"j", 1}, {"post", post}},
                          {{"end", "max_events"}, {"events", 1}, {"t", t}}}));
    EXPECT_TRUE(report.conforming()) << v << '\n' << report_text(report);
    EXPECT_EQ(says(report, "it may be another image"), v > 8) << report_text(report);
  }
}

// Certified in float: the exact time, rounded once. The other neighbour is less than an ulp away, too.
TEST(RoundedTimes, ATimeOfACertifiedFloatRunRoundedTheOtherWayIsSeen) {
  int seen = 0;
  for (int n = 1; n < 80; ++n) {
    const double X = 1 + n / 8.0;
    const Scene scene = read_scene_text(discs(100, 0, {disc(0, 0, 3), disc(X, 0, 0)}).dump(), "discs");
    std::istringstream lines(trace_bytes(scene, "float", Timing::certified, 1));
    std::string text;
    double t = 0;
    for (std::string each; std::getline(lines, each);) {
      Json line = Json::parse(each);
      if (line.contains("end")) continue;
      if (is_state(line) && line.at("state") > 0) continue;
      if (line.contains("kind")) {
        const double exact = (X - 1) / 3;
        const float honest = static_cast<float>(number(line.at("t")));
        if (exact == honest) break;
        t = std::nextafter(honest, honest < exact ? HUGE_VALF : -HUGE_VALF);
        line["t"] = line["dt"] = to_hex<double>(t);
        const std::string place = to_hex<double>(static_cast<float>(3.0F * static_cast<float>(t)));
        line["pre"]["0"]["position"][0] = line["post"]["0"]["position"][0] = place;
      }
      text += line.dump() + "\n";
    }
    if (t == 0) continue;
    const CheckReport report =
        checked(text + Json{{"end", "max_events"}, {"events", 1}, {"t", to_hex<double>(t)}}.dump() + "\n");
    EXPECT_GT(report.rules[static_cast<std::size_t>(Rule::contact)].violated, 0U) << X << '\n'
                                                                                  << report_text(report);
    ++seen;
  }
  EXPECT_GT(seen, 40);
}

}  // namespace
}  // namespace tps::mutation

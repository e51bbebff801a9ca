// Single lies about what was due, each of a kind that a check could take for honest.
#include <gtest/gtest.h>

#include <filesystem>

#include "reference/scene/read_scene.hpp"
#include "tests/trace_check/rows.hpp"
#include "tests/trace_check/told.hpp"

namespace tps::mutation {
namespace {

/// Traces with one lie that the check once took for honest, each another one.
TEST(Lies, OfAnEarlierCheck) {
  int count = 0;
  for (const auto& file : std::filesystem::directory_iterator(TPS_SOURCE_DIR "/tests/trace_check/lies")) {
    ++count;
    EXPECT_GT(check::check_trace(file.path()).violated(), 0U) << file.path();
  }
  EXPECT_EQ(count, 6);
}

// A long flight's moment, 2^20 + 1/3, is behind its computed time; an event that began just before is due
// between the two. The end comes at the computed time, where a first look sees that pair still clear of its
// limit.
TEST(Lies, OfMomentsBehindTheirTimes) {
  Told told;
  for (int n = 1; n <= 100; ++n) {
    Scene scene = testing::plain_scene(2);
    testing::block(scene, 0, 0);
    testing::add_particle(scene, 0, {-0x3p20 - 2, 0, 0}, {3, 0, 0});
    testing::add_particle(scene, 0, {0, 0, 0}, {0, 0, 0});
    testing::add_particle(scene, 0, {0, 8, 0}, {0, 0, 0});
    testing::add_particle(scene, 0, {2 - .0098 * n * 0x1p-32, 8, 0}, {0, 0, 0});
    scene.impulses = {{.at = 0x1p20, .particle = 2, .impulse = {3, 0, 0}}};
    RunOptions options;
    options.max_events = 3;
    const Trace run = run_of(scene, {"double", Timing::certified}, options);
    expect_honest(run, told, "both happen");
    const std::vector<std::size_t> events = event_lines(run);
    ASSERT_EQ(run.lines[events[1]].at("i"), 2) << "the one that began late is exactly first";
    Trace lie = run;
    erase_line(lie, events[1]);
    Retold before(lie);
    before.hear(lie.lines[events[0]], events[0]);
    carry_event(lie, events[1], before, 0x1p20 + 1. / 3);
    expect_lie(lie, told, "the one that began late is left out");
  }
}

// Exact misses by less than rounding, which a certified run and its check both know to be misses.
TEST(HonestRuns, LeaveNothingUndecidedUnderCertifiedTiming) {
  const Scene scene =
      read_scene_file(TPS_SOURCE_DIR "/tests/trace_check/honest/certified_undecided_inf.json");
  Told told;
  expect_honest(run_of(scene, {"double", Timing::certified}), told, "eight exact misses");
}

/// A crowd that flies apart from a lattice; one of them, if asked, flies at its neighbour.
Trace crowd_apart(int side, bool one_turns) {
  Trace trace;
  trace.scene = testing::plain_scene(3);
  testing::block(trace.scene, 0, 0);
  Json particles = Json::array();
  for (int n = 0; n < side * side * side; ++n) {
    const double x[3] = {2. * (n % side), 2. * (n / side % side), 2. * (n / side / side)};
    const double away = one_turns && n == 0 ? -1 : 1;
    const double middle = side;
    particles.push_back({{"species", "p"},
                         {"position", {x[0], x[1], x[2]}},
                         {"velocity", {away * (x[0] - middle), x[1] - middle, x[2] - middle}}});
  }
  const Json scene = {{"tps", 1},
                      {"dimension", 3},
                      {"duration", "inf"},
                      {"species", {{"p", {{"mass", 1}, {"radius", .5}}}}},
                      {"pairs", {{{"between", {"p", "p"}}, {"blocking", {{"c_rebound", 1}}}}}},
                      {"particles", particles}};
  trace.lines = {{{"trace", 1},
                  {"semantics", 1},
                  {"scalar", "double"},
                  {"options", {{"timing", "certified"}, {"state_every", 1000}}},
                  {"scene", scene}},
                 {{"end", "no_more_events"}, {"events", 0}, {"t", "0x0p+0"}}};
  return trace;
}

// That nothing more happens is judged however many particles there are.
TEST(Lies, ThatNothingMoreHappensToMany) {
  Told told;
  for (const int side : {6, 29}) {
    expect_honest(crowd_apart(side, false), told, "a crowd that flies apart");
    expect_lie(crowd_apart(side, true), told, "one of them turns");
  }
}

}  // namespace
}  // namespace tps::mutation

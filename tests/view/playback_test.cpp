// What a page plays is what the trace says: places, velocities, tethers and bodies, at any moment.
#include "verify/view/playback.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "reference/run/snapshot.hpp"
#include "reference/scene/read_scene.hpp"
#include "tests/run/traced_run.hpp"
#include "verify/view/body_trees.hpp"

namespace tps::view {
namespace {

using testing::options_for;
using testing::scratch;
using testing::traced;
using testing::traced_bytes;
using testing::write_bytes;

Scene data_scene(const std::string& name) {
  return read_scene_file(TPS_SOURCE_DIR "/data/scenes/" + name + ".json");
}

std::string trace_of(const Scene& scene, const std::string& scalar = "double", std::uint64_t events = 400) {
  const std::string path = scratch("view.ndjson");
  write_bytes(path, traced_bytes(scene, options_for(scalar, events)));
  return path;
}

Change start_change(const Scene& scene, std::size_t p) {
  return {0, static_cast<int>(p), -1, scene.particles[p].position, scene.particles[p].velocity};
}

/// The last change of each particle.
std::vector<Change> last_changes(const Playback& playback) {
  std::vector<Change> last;
  for (std::size_t p = 0; p < playback.scene.particles.size(); ++p)
    last.push_back(start_change(playback.scene, p));
  for (const Change& change : playback.changes) last[static_cast<std::size_t>(change.particle)] = change;
  return last;
}

Coordinates flown(const Change& from, double t) {
  Coordinates x = from.position;
  for (std::size_t k = 0; k < 3; ++k) x[k] += from.velocity[k] * (t - from.t);
  return x;
}

/// Of a product, a difference of times and a sum, each rounded, here and in the run: 2·3 halves of an ulp of
/// the largest part, and where both clocks are sums of two numbers one more for each.
double allowed(const Change& from, double t, std::size_t k) {
  const double size = std::fabs(from.position[k]) + std::fabs(from.velocity[k]) * (t + from.t);
  return 4 * std::numeric_limits<double>::epsilon() * size;
}

class Played : public ::testing::TestWithParam<const char*> {};

// The law (1) of Playback: from each change the flight is straight to the next.
TEST_P(Played, FlightsLeadToTheNextChange) {
  const Playback playback = read_playback(trace_of(data_scene(GetParam())));
  std::vector<Change> last;
  for (std::size_t p = 0; p < playback.scene.particles.size(); ++p)
    last.push_back(start_change(playback.scene, p));
  ASSERT_GT(playback.changes.size(), 3U);
  for (const Change& change : playback.changes) {
    Change& before = last[static_cast<std::size_t>(change.particle)];
    ASSERT_GE(change.t, before.t);
    const Coordinates there = flown(before, change.t);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(there[k], change.position[k], allowed(before, change.t, k))
          << "particle " << change.particle << " at t = " << change.t;
    }
    before = change;
  }
}

TEST_P(Played, EndsWhereTheRunEnds) {
  const testing::TracedRun run = traced(data_scene(GetParam()), options_for("double", 400));
  const std::string path = scratch("ends.ndjson");
  write_bytes(path, run.bytes);
  const Playback playback = read_playback(path);
  const Snapshot end = read_snapshot(path);
  const std::vector<Change> last = last_changes(playback);
  for (std::size_t p = 0; p < last.size(); ++p) {
    const Coordinates there = flown(last[p], end.t);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(there[k], end.positions[p][k], allowed(last[p], end.t, k)) << p;
  }
  std::set<std::pair<int, int>> tethers, expected;
  for (const TetherChange& change : playback.tethers) {
    if (change.formed)
      tethers.insert(std::minmax(change.i, change.j));
    else
      tethers.erase(std::minmax(change.i, change.j));
  }
  for (const Tether& tether : end.tethers) expected.insert(std::minmax(tether.i, tether.j));
  EXPECT_EQ(tethers, expected);
  EXPECT_DOUBLE_EQ(playback.t_end, run.summary.t);
}

INSTANTIATE_TEST_SUITE_P(View, Played,
                         ::testing::Values("terminal", "three-body", "three-body-grouped", "sheet",
                                           "sediment", "brownian", "two-anchors-grouped"));

TEST(Playback, GroupsAreWhoMovesTogether) {
  const Playback playback = read_playback(trace_of(data_scene("three-body-grouped")));
  ASSERT_EQ(playback.events.size(), 4U);
  std::vector<int> body(3, -1);
  const std::vector<std::vector<int>> expected = {{0, 0, -1}, {1, 1, 1}, {0, 0, -1}, {-1, -1, -1}};
  for (std::size_t n = 0; n < 4; ++n) {
    const std::size_t end = n < 3 ? playback.events[n + 1].first_change : playback.changes.size();
    for (std::size_t c = playback.events[n].first_change; c < end; ++c)
      body[static_cast<std::size_t>(playback.changes[c].particle)] = playback.changes[c].body;
    EXPECT_EQ(body, expected[n]) << "after event " << n + 1;
    EXPECT_EQ(playback.events[n].load, n < 2);
  }
}

TEST(Playback, InfiniteMassesMoveWithNobody) {
  Scene scene = testing::plain_scene();
  const int wall = testing::add_species(scene, "wall", std::numeric_limits<double>::infinity(), 1);
  testing::add_particle(scene, wall, {0, 0, 0});
  testing::add_particle(scene, 0, {3, 0, 0});
  BodyTrees bodies(scene);
  bodies.load(0, 1, {1});
  EXPECT_EQ(bodies.number(0), -1);
  EXPECT_EQ(bodies.number(1), 0);
  EXPECT_TRUE(bodies.grounded(1));
  const auto sides = bodies.part(0, 1);
  EXPECT_TRUE(sides[0].empty());
  EXPECT_EQ(sides[1], std::vector<int>{1});
  EXPECT_FALSE(bodies.grounded(1));
}

TEST(Playback, WideScalarsAreShownAsTheNearestDoubles) {
  const Playback wide = read_playback(trace_of(data_scene("three-body"), "mp50"));
  const Playback doubles = read_playback(trace_of(data_scene("three-body")));
  ASSERT_EQ(wide.events.size(), doubles.events.size());
  EXPECT_EQ(wide.events[0].t, doubles.events[0].t);
  ASSERT_EQ(wide.notes.size(), 1U);
  EXPECT_NE(wide.notes[0].find("mp50"), std::string::npos);
}

TEST(Playback, ThinsEvenlyAndLosesNoLastChange) {
  const std::string path = trace_of(data_scene("terminal"));
  PlaybackOptions few;
  few.most_events = 60;
  few.lines = {102};  // event 101: its line counts the header
  const Playback all = read_playback(path), thinned = read_playback(path, few);
  EXPECT_EQ(thinned.all_events, all.events.size());
  EXPECT_EQ(thinned.one_of, 8U);
  std::size_t beside = 0;
  for (const Event& event : thinned.events) {
    const bool wanted = event.line >= 100 && event.line <= 104;
    beside += wanted ? 1 : 0;
    EXPECT_TRUE(wanted || event.number % 8 == 0 || event.number == all.all_events) << event.number;
  }
  EXPECT_EQ(beside, 5U);
  EXPECT_GE(thinned.events.size(), all.events.size() / 8);
  const std::vector<Change> last = last_changes(thinned), expected = last_changes(all);
  for (std::size_t p = 0; p < last.size(); ++p) {
    EXPECT_EQ(last[p].t, expected[p].t);
    EXPECT_EQ(last[p].position, expected[p].position);
    EXPECT_EQ(last[p].velocity, expected[p].velocity);
  }
}

TEST(Playback, DamagedLinesAreLeftOutAndNamed) {
  std::string bytes = traced_bytes(data_scene("three-body"), options_for("double", 5));
  const std::size_t line_4 = bytes.find("{\"k\":2");
  bytes.insert(line_4 + 1, "oops");
  const std::string path = scratch("damaged.ndjson");
  write_bytes(path, bytes.substr(0, bytes.rfind("{\"end\"")));
  const Playback playback = read_playback(path);
  EXPECT_EQ(playback.events.size(), 4U);
  ASSERT_EQ(playback.notes.size(), 2U);
  EXPECT_NE(playback.notes[0].find("1 line could not be read and is left out; the first is line 4"),
            std::string::npos)
      << playback.notes[0];
  EXPECT_NE(playback.notes[1].find("no last line"), std::string::npos);
}

}  // namespace
}  // namespace tps::view

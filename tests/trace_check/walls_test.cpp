// The check and walls: honest runs conform in every scalar and timing; who rebounds at another time, from
// another wall, with another impulse, or flies through one, is told by its rule.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "reference/text/hexfloat.hpp"
#include "reference/text/input_error.hpp"
#include "tests/run/resumed_run.hpp"
#include "tests/run/traced_run.hpp"
#include "tests/trace_check/checked_trace.hpp"
#include "verify/certified/exact_timing.hpp"
#include "verify/trace_check/check.hpp"

namespace tps {
namespace walls_in_traces {

using nlohmann::json;
using testing::checked;
using testing::first_finding;
using testing::violated;
using testing::with_event;

/// Balls of two kinds in a box with a round obstacle and a block, a leaning plane and a hollow that moves;
/// with gravity at times.
Scene walled(unsigned seed) {
  Scene scene = testing::plain_scene(2 + static_cast<int>(seed % 2));
  scene.seed = seed;
  scene.duration = 12;
  scene.species[0].random_impulses = RandomImpulses{1.7, 2, .3};
  const int small = testing::add_species(scene, "small", .25, .2);
  testing::block(scene, 0, 0, .9);
  testing::block(scene, 0, small, 1);
  testing::tether(scene, 0, small, 1.8, .7, FormRule::When::always);
  if (seed % 3 == 0) scene.gravity = Gravity{{.1, -.3, 0}, .11};
  Wall box;
  box.shape = Wall::Shape::box;
  box.point = {-3, -3, -2};
  box.high = {3, 3, 2};
  box.c_rebound = seed % 4 == 1 ? .8 : 1;
  Wall obstacle;
  obstacle.shape = Wall::Shape::sphere;
  obstacle.inside = false;
  obstacle.radius = .4;
  obstacle.c_rebound = .9;
  Wall hollow = obstacle;
  hollow.inside = true;
  hollow.radius = 3.6;
  hollow.c_rebound = 1;
  if (seed % 4 == 2) hollow.velocity = {.01, -.02, 0};
  Wall plane;
  plane.point = {0, 3.5, 0};
  plane.normal = {.6, -.8, 0};
  Wall block = box;
  block.inside = false;
  block.point = {.3, 1.3, -.4};
  block.high = {1.1, 1.6, .3};
  scene.walls = {box, obstacle, plane, hollow, block};
  for (int n = 0; n < 3; ++n) {
    testing::add_particle(scene, 0, {-1.2 + 1.2 * n, -1.5, 0}, {.8, .3 - .2 * n, 0});
    testing::add_particle(scene, small, {-1.2 + 1.2 * n, .8 - .2 * n, 0}, {-.3, .9, seed % 2 == 1 ? .2 : 0});
  }
  return scene;
}

testing::TracedRun honest(const Scene& scene, const std::string& scalar, Timing timing) {
  certified::ExactTiming certifier;
  RunOptions options = testing::options_for(scalar, 200);
  options.timing = timing;
  options.certifier = &certifier;
  return testing::traced(scene, options);
}

TEST(CheckOfWalls, HonestRunsConform) {
  std::uint64_t rebounds = 0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    for (const char* scalar : {"float", "double", "long-double", "quad", "mp50"}) {
      const bool certifiable = scalar == std::string("float") || scalar == std::string("double");
      if (!certifiable && seed > 1) continue;
      for (const Timing timing : {Timing::stable, Timing::paper, Timing::certified}) {
        if (timing == Timing::certified && !certifiable) continue;
        const testing::TracedRun run = honest(walled(seed), scalar, timing);
        rebounds += run.summary.by_kind.at("wall");
        const check::CheckReport report = checked(run.bytes);
        ASSERT_TRUE(report.conforming()) << seed << ' ' << scalar << ": " << first_finding(report);
        EXPECT_LE(std::abs(run.summary.energy_remainder), run.summary.energy_bound) << seed << ' ' << scalar;
        EXPECT_LE(run.summary.momentum_drift, run.summary.momentum_bound) << seed << ' ' << scalar;
      }
    }
  }
  EXPECT_GE(rebounds, 500U);
}

// Walls at rest are met in the clock of drag, in which paths are straight.
/// A mote is pressed against a post by a ball a thousand times as heavy, far from the origin, where its place
/// has few digits: rounding leaves it behind the surface again and again, and then it is due at once.
TEST(CheckOfWalls, WhoIsWedgedMayBeBehindTheSurface) {
  Scene scene = testing::plain_scene(2);
  scene.duration = 3;
  scene.species[0].radius = .375;
  const int mote = testing::add_species(scene, "mote", .001, .375);
  testing::block(scene, 0, mote, 0);
  Wall post;
  post.shape = Wall::Shape::sphere;
  post.inside = false;
  post.radius = .09375;
  post.c_rebound = .5;
  std::uint64_t at_once = 0;
  for (int n = 0; n < 20; ++n) {
    const double x = 1000 + n * 17.3, y = -1000 + n * .7;
    post.point = {x, y, 0};
    scene.walls = {post};
    scene.particles.clear();
    testing::add_particle(scene, 0, {x - 1.2, y - 1.1 - n * .003, 0}, {1, 1 - n * .01, 0});
    testing::add_particle(scene, mote, {x - .45, y - .42, 0}, {0, 0, 0});
    for (const Timing timing : {Timing::stable, Timing::certified}) {
      certified::ExactTiming certifier;
      RunOptions options = testing::options_for("double", 60);
      options.timing = timing;
      options.certifier = &certifier;
      const testing::TracedRun run = testing::traced(scene, options);
      for (const std::string& line : run.lines)
        at_once += line.find("\"dt\":\"0x0p+0\",\"kind\":\"wall\"") != std::string::npos ? 1U : 0U;
      const check::CheckReport report = checked(run.bytes);
      ASSERT_TRUE(report.conforming()) << n << ": " << first_finding(report);
    }
  }
  EXPECT_GT(at_once, 10U);
}

TEST(CheckOfWalls, HonestRunsWithDragConform) {
  for (const Timing timing : {Timing::stable, Timing::certified}) {
    Scene scene = walled(4);
    scene.species[0].random_impulses.reset();
    scene.drag = Drag{.1};
    const testing::TracedRun run = honest(scene, "double", timing);
    EXPECT_GE(run.summary.by_kind.at("wall"), 5U);
    const check::CheckReport report = checked(run.bytes);
    EXPECT_TRUE(report.conforming()) << first_finding(report);
  }
}

double number(const json& hex) {
  return std::strtod(hex.get<std::string>().c_str(), nullptr);
}

TEST(CheckOfWalls, LiesAreTold) {
  for (unsigned seed = 1; seed <= 2; ++seed) {
    for (const Timing timing : {Timing::stable, Timing::certified}) {
      const testing::TracedRun run = honest(walled(seed), "double", timing);
      for (const int which : {0, 3, 8}) {
        const auto of = [&](check::Rule rule, auto edit) {
          return violated(checked(with_event(run, "wall", which, edit)), rule);
        };
        const std::string where = std::to_string(seed) + ' ' + std::to_string(which);
        EXPECT_GT(of(check::Rule::earliest, [](json&) { return false; }), 0U) << where;
        const auto elsewhere = [](json& event) {
          event["wall"] = (event["wall"].get<int>() + 1) % 4;
          event.erase("face");
          if (event["wall"] == 0) event["face"] = 0;
          return true;
        };
        EXPECT_GT(of(check::Rule::contact, elsewhere), 0U) << where;
        const auto unknown = [](json& event) {
          event["wall"] = 9;
          return true;
        };
        EXPECT_GT(of(check::Rule::contact, unknown), 0U) << where;
        const auto pushed = [](json& event) {
          event["dp"][0] = to_hex(number(event["dp"][0]) + 1e-13);
          return true;
        };
        EXPECT_GT(of(check::Rule::impulse, pushed), 0U) << where;
        const auto slower = [](json& event) {
          for (json& state : event["post"]) {
            for (json& v : state["velocity"]) v = to_hex(number(v) * (1 - 1e-13));
          }
          return true;
        };
        EXPECT_GT(of(check::Rule::impulse, slower), 0U) << where;
        EXPECT_GT(of(check::Rule::conservation, slower), 0U) << where;
        const auto straight_on = [](json& event) {
          event["post"] = event["pre"];
          for (json& component : event["dp"]) component = "0x0p+0";
          return true;
        };
        EXPECT_GT(of(check::Rule::impulse, straight_on), 0U) << where;
      }
    }
  }
}

/// What is said of the first event at a face whose wall and face are these.
std::string said_of(const testing::TracedRun& run, std::optional<int> wall, std::optional<int> face) {
  const auto edit = [&](json& event) {
    event.erase("wall");
    event.erase("face");
    if (wall) event["wall"] = *wall;
    if (face) event["face"] = *face;
    return true;
  };
  for (const check::Finding& finding : checked(with_event(run, "wall", 0, edit)).findings) {
    if (finding.rule == check::Rule::contact) return finding.message;
  }
  return "nothing";
}

TEST(CheckOfWalls, AWallThatThereIsNotIsNamedWithThoseThatThereAre) {
  const testing::TracedRun run = honest(walled(1), "double", Timing::stable);
  EXPECT_EQ(said_of(run, 9, {}), "the scene has no wall 9; they are 0 to 4");
  EXPECT_EQ(said_of(run, 0, {}), "wall 0 is a box, whose face the event has to name: from 0 to 5");
  EXPECT_EQ(said_of(run, 0, 6), "wall 0 is a box, whose face the event has to name: from 0 to 5, not 6");
  EXPECT_EQ(said_of(run, 1, 2), "wall 1 is no box and has no faces; leave face out");
}

// The events of a run without the block, under the header of one with it: nothing happens, and that is wrong.
TEST(CheckOfWalls, WhoFliesThroughABlockIsTold) {
  const std::pair<Coordinates, Coordinates> flights[] = {
      {{-3, 1, 0}, {1, .01, 0}},     // a face
      {{-3, -4.1, 0}, {.75, 1, 0}},  // a corner
      {{-3, 2.4, 0}, {1, .02, 0}}};  // one, from beside a face
  for (const auto& [position, velocity] : flights) {
    for (const Timing timing : {Timing::stable, Timing::certified}) {
      Scene free = testing::plain_scene();
      free.duration = 20;
      testing::add_particle(free, 0, position, velocity);
      Scene blocked = free;
      Wall block;
      block.shape = Wall::Shape::box;
      block.inside = false;
      block.high = {4, 2, 0};
      blocked.walls = {block};
      const testing::TracedRun through = honest(free, "double", timing),
                               right = honest(blocked, "double", timing);
      EXPECT_EQ(right.events.size(), 1U);
      EXPECT_TRUE(checked(right.bytes).conforming());
      const std::string lie =
          right.bytes.substr(0, right.bytes.find('\n')) + through.bytes.substr(through.bytes.find('\n'));
      EXPECT_GT(violated(checked(lie), check::Rule::earliest), 0U) << position[1];
    }
  }
}

/// Balls whose flights end at the borders between the parts of a block, or slide along its faces, or come on
/// a slope as slight as 2⁻⁴⁰.
class Borders {
 public:
  Scene next() {
    const int dimension = 2 + pick(2);
    Scene scene = testing::plain_scene(dimension);
    scene.duration = 10;
    scene.species[0].radius = pick(2) == 1 ? .25 : number(.1, .5);
    Wall block;
    block.shape = Wall::Shape::box;
    block.inside = false;
    block.c_rebound = pick(3) * .5;
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
      block.point[k] = number(-1, 1);
      block.high[k] = block.point[k] + .5 * (1 + pick(3));
      if (pick(2) == 1) block.velocity[k] = .25 * pick(3);
    }
    scene.walls = {block};
    for (int n = 0; n < 6; ++n) add_ball(scene);
    return scene;
  }

 private:
  int pick(int n) { return static_cast<int>(draw_() % static_cast<unsigned>(n)); }
  double number(double low, double high) {
    return low + (high - low) * (static_cast<double>(draw_()) * 0x1p-32);
  }

  void add_ball(Scene& scene) {
    const Wall& block = scene.walls[0];
    const auto dimension = static_cast<std::size_t>(scene.dimension);
    const std::size_t across = draw_() % dimension;
    const double side = pick(2) == 1 ? 1 : -1, radius = scene.species[0].radius, before = number(.1, 2);
    const double slope = std::ldexp(1., std::array{0, -20, -26, -40, -1074}[draw_() % 5]);
    Coordinates position{}, velocity{};
    for (std::size_t k = 0; k < dimension; ++k) {
      const double ends[] = {block.point[k], block.high[k], number(block.point[k], block.high[k])};
      const double target = k == across ? ends[side > 0 ? 1 : 0] + side * radius : ends[pick(3)];
      const double speed = k == across ? -side * number(.1, 1) * slope : pick(4) == 0 ? 0 : number(-1, 1);
      position[k] = target - before * speed;
      velocity[k] = speed + block.velocity[k];
    }
    // A start that is nearer than the radius is refused.
    const double face = side > 0 ? block.high[across] : block.point[across];
    while (side * (position[across] - face) < radius)
      position[across] = std::nextafter(position[across], side * HUGE_VAL);
    testing::add_particle(scene, 0, position, velocity);
  }

  std::mt19937 draw_{5};
};

TEST(CheckOfWalls, HonestRunsAtTheBordersOfABlockConform) {
  Borders borders;
  std::uint64_t rebounds = 0;
  for (int n = 0; n < 96; ++n) {
    const Scene scene = borders.next();
    for (const char* scalar : {"double", "float", "long-double", "quad", "mp100"}) {
      const bool certifiable = scalar == std::string("float") || scalar == std::string("double");
      if (!certifiable && n % 8 > 0) continue;
      for (const Timing timing : {Timing::stable, Timing::paper, Timing::certified}) {
        if (timing == Timing::certified && !certifiable) continue;
        testing::TracedRun run;
        try {
          run = honest(scene, scalar, timing);
        } catch (const InputError&) {
          continue;  // in float it starts nearer
        }
        rebounds += run.events.size();
        const check::CheckReport report = checked(run.bytes);
        ASSERT_TRUE(report.conforming()) << n << ' ' << scalar << ": " << first_finding(report) << run.bytes;
      }
    }
  }
  EXPECT_GE(rebounds, 300U);
}

// A program that computes the discriminant of a slide in doubles sees the corner, √u before the edge.
TEST(CheckOfWalls, AReboundOfATangentIsRounding) {
  Scene scene = testing::plain_scene();
  scene.duration = 2;
  scene.species[0].radius = .25;
  Wall block;
  block.shape = Wall::Shape::box;
  block.inside = false;
  block.high = {1, 1, 0};
  scene.walls = {block};
  testing::add_particle(scene, 0, {.9, 1.25, 0}, {.3, 0, 0});
  const testing::TracedRun run = honest(scene, "double", Timing::stable);
  EXPECT_TRUE(run.events.empty());
  const auto claimed = [&](double before, double dp) {
    const double t = (1 - .9) / .3 - before / .3;
    const json state = {{"position", {to_hex(.9 + t * .3), to_hex(1.25)}},
                        {"velocity", {to_hex(.3), to_hex(0.)}}};
    json after = state;
    after["velocity"][1] = to_hex(dp);
    const json event = {{"k", 1},
                        {"t", to_hex(t)},
                        {"dt", to_hex(t)},
                        {"kind", "wall"},
                        {"wall", 0},
                        {"face", 7},
                        {"i", 0},
                        {"pre", {{"0", state}}},
                        {"post", {{"0", after}}},
                        {"dp", {to_hex(0.), to_hex(dp)}}};
    json end = json::parse(run.lines.back());
    end["events"] = 1;
    return run.lines.front() + "\n" + event.dump() + "\n" + end.dump() + "\n";
  };
  const check::CheckReport report = checked(claimed(4e-9, 0x1p-27));
  EXPECT_EQ(violated(report, check::Rule::contact), 0U) << first_finding(report);
  EXPECT_GT(violated(checked(claimed(4e-7, 0x1p-27)), check::Rule::contact), 0U);
}

// Within a rounding of the border in time, but not in place: who flies straight at a face beside its edge
// does not meet the corner, which is as near there.
TEST(CheckOfWalls, WhoTakesTheOtherPartIsTold) {
  for (const double beside : {1e-9, 1e-6}) {
    Scene scene = testing::plain_scene();
    scene.duration = 8;
    Wall block;
    block.shape = Wall::Shape::box;
    block.inside = false;
    block.high = {4, 2, 0};
    scene.walls = {block};
    testing::add_particle(scene, 0, {4 - beside, 5, 0}, {0, -1, 0});
    const testing::TracedRun run = honest(scene, "double", Timing::stable);
    const auto corner = [](json& event) {
      event["face"] = 7;
      return true;
    };
    ASSERT_EQ(run.events.size(), 1U);
    EXPECT_GT(violated(checked(with_event(run, "wall", 0, corner)), check::Rule::contact), 0U) << beside;
  }
}

TEST(CheckOfWalls, AResumedRunGoesOnToTheSameBytes) {
  for (const Timing timing : {Timing::stable, Timing::certified}) {
    certified::ExactTiming certifier;
    RunOptions options = testing::options_for("double", 150);
    options.state_every = 10;
    options.timing = timing;
    options.certifier = &certifier;
    testing::expect_same_when_resumed(walled(3), options);
  }
}

}  // namespace walls_in_traces
}  // namespace tps

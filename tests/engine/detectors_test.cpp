// Cells against all pairs, event by event, in scenes that are hard for cells: sizes 1:100, moving containers,
// particles that fly off, runs that never end.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "reference/engine/simulation.hpp"
#include "reference/scene/read_scene.hpp"

namespace tps {
namespace {

struct Step {
  Time<double> time;
  std::string kind;
  int i, j;
  std::vector<double> numbers;
  bool operator==(const Step&) const = default;
};

template <int D>
std::vector<Step> course(const Scene& scene, DetectorKind detector, std::size_t most) {
  Simulation<double, D> simulation(scene, {}, detector);
  const Time<double> end{scene.duration, 0};
  simulation.set_horizon(end);
  std::vector<Step> steps;
  simulation.world().sink = [&](const Record<double, D>& record) {
    Step step{record.t, std::string(record.kind), record.i, record.j, {}};
    for (const ParticleChange<double, D>& change : record.involved) {
      step.numbers.insert(step.numbers.end(), change.position.begin(), change.position.end());
      step.numbers.insert(step.numbers.end(), change.velocity_after.begin(), change.velocity_after.end());
    }
    steps.push_back(step);
  };
  for (;;) {
    const Time<double> next = simulation.next_time();
    if (steps.size() >= most || end < next || next == Time<double>::never()) return steps;
    simulation.step();
  }
}

/// Both courses, and that something happened.
template <int D>
void expect_one_course(const Scene& scene, std::size_t least, std::size_t most = 400) {
  const std::vector<Step> expected = course<D>(scene, DetectorKind::all_pairs, most);
  EXPECT_GE(expected.size(), least);
  const std::vector<Step> by_cells = course<D>(scene, DetectorKind::cells, most);
  const auto parted = std::mismatch(by_cells.begin(), by_cells.end(), expected.begin(), expected.end()).first;
  EXPECT_TRUE(by_cells == expected) << "from event " << parted - by_cells.begin() << " on, of "
                                    << by_cells.size() << " and " << expected.size();
}

class SceneText {
 public:
  explicit SceneText(std::uint64_t seed) : bits_(seed) {}

  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
  }
  void particle(const std::string& species, std::initializer_list<double> position,
                std::initializer_list<double> velocity) {
    particles_ << (next_ == 0 ? "" : ",") << R"({"id":)" << next_ << R"(,"species":")" << species
               << R"(","position":)" << list(position) << R"(,"velocity":)" << list(velocity) << "}";
    ++next_;
  }
  Scene scene(const std::string& start) const {
    return read_scene_text("{\"tps\":1," + start + ",\"particles\":[" + particles_.str() + "]}", "test");
  }

 private:
  static std::string list(std::initializer_list<double> numbers) {
    std::ostringstream text;
    text.precision(17);
    for (const double x : numbers) text << (text.tellp() == 0 ? "[" : ",") << x;
    return text.str() + "]";
  }
  std::mt19937_64 bits_;
  std::ostringstream particles_;
  int next_ = 0;
};

/// Small ones on a lattice around large ones of a hundred times their radius, in a moving container.
TEST(Detectors, LargeAmongSmallInAMovingContainer) {
  SceneText text(1);
  text.particle("wall", {0, 0}, {0.25, 0.125});
  text.particle("large", {-60, 0}, {1, 0.5});
  text.particle("large", {60, 10}, {-1, 0});
  for (int x = -70; x <= 70; x += 20) {
    for (const double y : {-90.0, -84.0, 84.0, 90.0})
      text.particle("small", {x + text.between(-1, 1), y}, {text.between(-3, 3), text.between(-3, 3)});
  }
  const Scene scene = text.scene(
      R"("dimension":2,"duration":1e6,
         "species":{"wall":{"mass":"inf","radius":150},"large":{"mass":50,"radius":50},"small":{"mass":1,"radius":0.5}},
         "pairs":[{"between":["wall","large"],"tethering":{"distance":100,"c_retract":1,"c_revolve":1,
                   "theta_revolve_deg":10,"form":"permanent","break":"never"}},
                  {"between":["wall","small"],"tethering":{"distance":149.5,"c_retract":1,"c_revolve":1,
                   "theta_revolve_deg":10,"form":"permanent","break":"never"}},
                  {"between":["large","large"],"blocking":{"c_rebound":1}},
                  {"between":["large","small"],"blocking":{"c_rebound":0.9}},
                  {"between":["small","small"],"blocking":{"c_rebound":0.9}}])");
  expect_one_course<2>(scene, 400);
}

SceneText cloud(std::uint64_t seed, double speed) {
  SceneText text(seed);
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 4; ++y) {
      for (int z = 0; z < 4; ++z) {
        const auto random = [&] { return text.between(-speed, speed); };
        text.particle("ball", {1.25 * x, 1.25 * y, 1.25 * z}, {random(), random(), random()});
      }
    }
  }
  return text;
}
constexpr const char* kBalls =
    R"(,"species":{"ball":{"mass":1,"radius":0.5}},"pairs":[{"between":["ball","ball"],"blocking":{"c_rebound":1}}])";

/// More than a particle keeps of what is ahead, all at one instant: whatever is asked first, the others are
/// not behind it.
TEST(Detectors, SixAtOnceMeetOneThatKeepsThree) {
  SceneText text(3);
  text.particle("ball", {0, 0, 0}, {0, 0, 0});
  for (const double side : {-2., 2.}) {
    text.particle("ball", {side, 0, 0}, {-side / 2, 0, 0});
    text.particle("ball", {0, side, 0}, {0, -side / 2, 0});
    text.particle("ball", {0, 0, side}, {0, 0, -side / 2});
  }
  const Scene scene = text.scene(R"("dimension":3,"duration":20,"species":{"ball":{"mass":1,"radius":0.5}},
                    "pairs":[{"between":["ball","ball"],"blocking":{"c_rebound":1}}])");
  expect_one_course<3>(scene, 6);
}

/// The last events of a gas in free space are far apart in time and space, and then there are none: a run
/// without an end comes to know that.
TEST(Detectors, AGasThatExpandsForEver) {
  expect_one_course<3>(cloud(2, 1).scene(R"("dimension":3,"duration":"inf")" + std::string(kBalls)), 60,
                       100000);
  expect_one_course<3>(cloud(3, 1).scene(R"("dimension":3,"duration":1e9)" + std::string(kBalls)), 60,
                       100000);
}

/// So many that bins of time wait: a dense gas in a periodic box, and one that flies apart, whose times
/// spread over decades.
TEST(Detectors, ManyBinsOfTime) {
  SceneText text(5);
  for (int x = 0; x < 24; ++x) {
    for (int y = 0; y < 24; ++y)
      text.particle("ball", {1.25 * x, 1.25 * y}, {text.between(-1, 1), text.between(-1, 1)});
  }
  const std::string balls = kBalls;
  expect_one_course<2>(text.scene(R"("dimension":2,"duration":2,"box":{"periodic":[30,30]})" + balls), 1000,
                       1500);
  expect_one_course<2>(text.scene(R"("dimension":2,"duration":1e9)" + balls), 800, 1500);
}

/// So narrow that a particle has the same neighbours on both sides, by different images.
TEST(Detectors, NarrowBoxes) {
  for (int n = 0; n < 6; ++n) {
    SceneText text(20 + static_cast<std::uint64_t>(n));
    const double width = 2.5 + 0.5 * n;
    for (int y = 0; y < 40; ++y) {
      const double x = text.between(0, width), v = text.between(-1, 1);
      text.particle("ball", {x, 1.25 * y}, {3 * v, text.between(-1, 1)});
    }
    std::ostringstream start;
    start << R"("dimension":2,"duration":20,"box":{"periodic":[)" << width << ",50]}";
    expect_one_course<2>(text.scene(start.str() + kBalls), 300, 1000);
  }
}

/// Few in a large box, most of whose time passes with crossing regions: those get wider. Where all meet in
/// the middle in the end, they get narrow again.
TEST(Detectors, RegionsThatGrowAndShrink) {
  for (int n = 0; n < 24; ++n) {
    SceneText text(400 + static_cast<std::uint64_t>(n));
    const double edge = n % 4 == 3 ? 4000 : 300;
    const int side = n % 4 == 3 ? 16 : 5;
    for (int x = 0; x < side; ++x) {
      for (int y = 0; y < side; ++y) {
        const double px = (x + text.between(.1, .9)) * edge / side,
                     py = (y + text.between(.1, .9)) * edge / side;
        const double speed = n % 4 == 2 ? std::exp2(text.between(-10, 10)) : 1;
        if (n % 4 == 3) {  // they meet at 100, and nothing is lost of how near they come
          text.particle("ball", {px, py}, {(edge / 2 - px) / 100, (edge / 2 - py) / 100});
        } else {
          text.particle("ball", {px, py}, {speed * text.between(-1, 1), speed * text.between(-1, 1)});
        }
      }
    }
    std::ostringstream start;
    start << R"("dimension":2,"duration":)" << (n % 4 == 3 ? 200 : 1e5);
    if (n % 4 != 1) start << R"(,"box":{"periodic":[)" << edge << "," << 1.25 * edge << "]}";
    expect_one_course<2>(text.scene(start.str() + kBalls), n % 4 == 1 ? 0 : 150, n % 4 == 3 ? 1500 : 150);
  }
}

/// Regions between far ones are more than a table has entries, and than an integer counts.
TEST(Detectors, OneThatLiesFarAway) {
  for (int n = 0; n < 320; ++n) {
    SceneText text(40 + static_cast<std::uint64_t>(n));
    const double far = std::exp2(n % 40) * text.between(1, 2);
    const double turned = n % 3 == 0 ? 0 : n % 3 == 1 ? -far : far / 3;
    for (int x = 0; x < 8; ++x)
      text.particle("ball", {1.5 * x, text.between(-.2, .2), 0}, {text.between(-1, 1), 0, 0});
    if (n % 2 == 0) {
      text.particle("ball", {far, far, turned}, {0, 0, 0});
    } else {
      text.particle("ball", {0, 0, 10}, {far, far, turned});
    }
    expect_one_course<3>(text.scene(R"("dimension":3,"duration":3)" + std::string(kBalls)), 0, 60);
  }
}

/// Regions would be crossed faster than a time can be told from the next.
TEST(Detectors, SpeedsThatNoRegionHolds) {
  SceneText text = cloud(4, 1);
  text.particle("ball", {-1e9, 0, 0.3}, {1e9, 0, 0});
  text.particle("ball", {1e15, 0.2, 0}, {-1e15, 0, 0});
  text.particle("ball", {0, 1e60, 0.2}, {0, -1e60, 0});
  expect_one_course<3>(text.scene(R"("dimension":3,"duration":1e3)" + std::string(kBalls)), 60);
}

}  // namespace
}  // namespace tps

// There and back over a hundred events: how fast errors grow, and that more digits bring a run home.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "properties/runs/reversal.hpp"
#include "properties/runs/simulator.hpp"

namespace tps::properties::runs {
namespace {

/// Eight discs in an enclosure, c = 1, at angles that leave no revolution.
Scene gas() {
  Scene scene;
  scene.dimension = 2;
  scene.duration = 15;
  scene.species = {{"disc", 1, 0.5, {}}, {"enclosure", std::numeric_limits<double>::infinity(), 4, {}}};
  scene.pairs = {{0, 0, BlockingLaw{1, 1}, {}}, {0, 1, {}, TetheringLaw{}}};
  scene.pairs[1].tethering->distance = 3.5;
  scene.pairs[1].tethering->theta_revolve_deg = 1e-6;
  scene.pairs[1].tethering->form = {FormRule::When::permanent, 1};
  for (int n = 0; n < 8; ++n) {
    const double angle = n * 2.3;
    scene.particles.push_back({n,
                               0,
                               {1.25 * (n % 3) - 1.2, 1.25 * (n / 3) - 1.1, 0},
                               {2 * std::cos(angle), 2 * std::sin(angle), 0}});
  }
  scene.particles.push_back({8, 1, {}, {}});
  return scene;
}

struct Return {
  std::size_t events;
  Real error, growth;  ///< error in units of u
};

Return there_and_back(const Scene& scene, const std::string& scalar) {
  const Extent extent{.max_events = 10000, .state_every = 0};
  const auto simulator = reference_simulator(scalar, "stable");
  const RunTrace there = simulator->run(scene, extent);
  const RunTrace back = read_trace(*simulator->go_on(turned_round(there, scene, scalar), extent));
  const Real error = away_from_start(back, scene);
  return {there.events.size(), error, error / roundoff_of(scalar)};
}

// Errors grow by what the scene does to neighbours, whatever their size: the digits lost are the same in
// every scalar, give or take those of one unlucky rounding.
TEST(TimeReversal, LosesTheSameDigitsInEveryScalar) {
  const Scene scene = gas();
  Real digits_in_double = 0;
  for (const char* scalar : {"double", "mp50", "mp100"}) {
    const Return r = there_and_back(scene, scalar);
    const Real lost = std::log10(r.growth);
    std::cout << scalar << ": " << r.events << " events and back, " << static_cast<double>(r.error)
              << " from the start, " << static_cast<double>(lost) << " digits lost, one in "
              << static_cast<double>(2 * Real(r.events) / lost) << " events\n";
    EXPECT_GE(r.events, 100U);
    if (digits_in_double == 0) {
      digits_in_double = lost;
      continue;
    }
    EXPECT_LT(r.error, 1e-20L);
    EXPECT_NEAR(static_cast<double>(lost), static_cast<double>(digits_in_double), 3);
  }
}

}  // namespace
}  // namespace tps::properties::runs

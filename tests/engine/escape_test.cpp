// A tether holds whatever rounding does to a pair that starts taut and perpendicular.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/run/traced_run.hpp"

namespace tps {
namespace {

using testing::add_particle;
using testing::options_for;

/// A pair at distance 1 = its limit but for rounding, moving perpendicularly but for rounding, turned by an
/// angle and put away from the origin so that coordinates are coarse.
Scene perpendicular_pair(double angle, double away, double theta_deg, double c_retract) {
  Scene scene = testing::plain_scene();
  scene.duration = 20;
  testing::tether(scene, 0, 0, 1, c_retract);
  scene.pairs[0].tethering->theta_revolve_deg = theta_deg;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  add_particle(scene, 0, {.5 * c + away, .5 * s - away, 0}, {-s / 2, c / 2, 0});
  add_particle(scene, 0, {-.5 * c + away, -.5 * s - away, 0}, {s / 2, -c / 2, 0});
  scene.tethers = {{0, 1}};
  return scene;
}

// Found with Δp = 0 for every v_n < 0 (semantics §1): 34 of these 200 pairs met `turning`, responded with
// Δp = 0 and flew apart, 1e16 ulps beyond the limit, never to be predicted again.
TEST(TautPair, IsNeverLost) {
  for (const double theta : {30., 1e-3}) {
    for (const double c_retract : {1., .5, 0.}) {
      for (int n = 0; n < 100; ++n) {
        const Scene scene = perpendicular_pair(.01 + .062 * n, 3.3 * (n % 7), theta, c_retract);
        const RunSummary s = run_scene(scene, options_for("double", 300));
        EXPECT_NE(s.end, "stalled") << n << ' ' << theta;
        EXPECT_GE(s.events, 20U) << n;
        // Landing: two coordinates of each particle, each within one ulp, make at most 2√2 of distance; c and
        // the root's own error add as much again.
        EXPECT_LE(s.worst_outer_excess, 8) << n << ' ' << theta << ' ' << c_retract;
        EXPECT_LE(s.audit_outer_excess, 8) << n << ' ' << theta << ' ' << c_retract;
      }
    }
  }
}

// With a chord this shallow (depth θ²/2 = 1.5e-16 of the tether) rounding leaves many pairs where they cannot
// come back inside; they are held all the same. Nothing draws such a pair in, so that its excess walks at
// random: after n events it is of the order of √n landings of up to 2√2 ulps, and 4 times that is exceeded by
// none.
TEST(TautPair, IsNeverLostAtTheSmallestAngle) {
  for (int n = 0; n < 100; ++n) {
    const Scene scene = perpendicular_pair(.01 + .062 * n, 3.3 * (n % 7), 1e-6, .5);
    const RunSummary s = run_scene(scene, options_for("double", 2000));
    EXPECT_EQ(s.events, 2000U) << n;
    EXPECT_LE(s.audit_outer_excess, 4 * std::sqrt(2000.) * 2 * std::sqrt(2.)) << n;
  }
}

}  // namespace
}  // namespace tps

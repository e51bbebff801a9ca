// Runs of our own that the check once refused, though each step was right.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/scene/read_scene.hpp"
#include "tests/run/traced_run.hpp"
#include "tests/trace_check/checked_trace.hpp"
#include "tests/trace_check/scenes.hpp"
#include "verify/trace_check/check.hpp"

namespace tps::mutation {
namespace {

using check::CheckReport;
using testing::checked;

TEST(HonestRuns, ThatWereRefusedOnceConform) {
  const auto conforms = [](const char* name, const char* scalar, Timing timing,
                           std::uint64_t events = 24'000) {
    const Scene scene =
        read_scene_file(TPS_SOURCE_DIR "/tests/trace_check/cases/" + std::string(name) + ".json");
    const CheckReport report = checked(trace_bytes(scene, scalar, timing, events));
    EXPECT_TRUE(report.conforming()) << name << '\n' << report_text(report);
  };
  conforms("bias_circle_billiard", "double", Timing::stable);
  conforms("false_alarm_conservation_moving_wall", "double", Timing::stable);
  conforms("false_alarm_float_certified_ring", "float", Timing::certified);
  // From one side of a limit to the other, where every rounding of the time counts.
  conforms("false_alarm_chord_of_a_tether", "double", Timing::stable);
  conforms("false_alarm_chord_of_a_sphere", "double", Timing::stable);
  // These left their container, or a tether, for ever.
  conforms("pulled_without_restitution", "double", Timing::stable, 100);
  conforms("tether_beside_a_break_float", "float", Timing::stable, 100);
  conforms("tether_beside_a_break", "double", Timing::certified, 100);
}

/// A feather that touches a bead just after it was pulled changes no bit of its velocity, and where it is is
/// rounded anew: beyond its limit and separating, the bead is pulled at once (D23).
TEST(HonestRuns, OfATautPairWhosePositionIsRoundedAnewConform) {
  int pulled = 0;
  for (int n = 0; n < 60; ++n) {
    Scene scene = testing::plain_scene();
    const int anchor = testing::add_species(scene, "anchor", HUGE_VAL, 0);
    const int feather = testing::add_species(scene, "feather", 1e-30, 0);
    testing::tether(scene, 0, anchor, 1, .5, FormRule::When::permanent).tethering->theta_revolve_deg = .001;
    testing::block(scene, 0, feather, 1).blocking->distance = .5;
    const double far = std::ldexp(1.0, 24 + n % 8);
    testing::add_particle(scene, anchor, {far, 0, 0});
    testing::add_particle(scene, 0, {far + 1, 0, 0}, {0, 1, 0});
    testing::add_particle(scene, feather, {far + 1, .5 + 1.8e-5 + 2.5e-7 * n, 0});
    const Timing timing = n % 2 == 0 ? Timing::stable : Timing::paper;
    const std::string bytes = trace_bytes(scene, "double", timing, 20);
    const CheckReport report = checked(bytes);
    ASSERT_TRUE(report.conforming()) << n << '\n' << report_text(report);
    pulled += bytes.find("\"revolve\"") != std::string::npos ? 1 : 0;
  }
  EXPECT_GE(pulled, 30);
}

}  // namespace
}  // namespace tps::mutation

// The trace check accepts the runs of generated scenes. Apart from the laws, which share no code with it.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "properties/runs/scenes.hpp"
#include "properties/runs/simulator.hpp"
#include "properties/runs/trace_check_instead.hpp"

namespace tps::properties::runs {
namespace {

/// Whether the scalar tells places of the scene apart that the limits do: coordinates beyond 2^10 leave a
/// float 2^-14.
bool is_resolved(const Scene& scene, const std::string& scalar) {
  if (scalar != "float") return true;
  return std::all_of(scene.particles.begin(), scene.particles.end(), [](const Particle& p) {
    return std::all_of(p.position.begin(), p.position.end(), [](double x) { return std::fabs(x) <= 1024; });
  });
}

void accept(const std::string& scalar, const std::string& timing) {
  const SmallScene small = *rc::gen::suchThat(
      small_scene(), [&](const SmallScene& drawn) { return is_resolved(drawn.scene, scalar); });
  const auto simulator = reference_simulator(scalar, timing);
  const std::string trace = simulator->simulate(small.scene, {.max_events = 60, .state_every = 13});
  if (const auto fault = check_instead().fault_in(trace)) RC_FAIL(*fault);
}

RC_GTEST_PROP(CheckedRuns, ConformInDouble, ()) {
  accept("double", "stable");
}
RC_GTEST_PROP(CheckedRuns, ConformCertified, ()) {
  accept("double", "certified");
}
RC_GTEST_PROP(CheckedRuns, ConformInFloat, ()) {
  accept("float", "stable");
}

}  // namespace
}  // namespace tps::properties::runs

// Runs of generated scenes with each effect of the paper's outlook: the trace check, which shares no code
// with the engine, accepts them; they go on from any full state; and nothing depends on how collisions are
// found.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>

#include "properties/runs/laws.hpp"
#include "properties/runs/outlook_scenes.hpp"
#include "properties/runs/trace_check_instead.hpp"
#include "reference/scene/read_scene.hpp"
#include "reference/scene/write_scene.hpp"

#ifndef TPS_OUTLOOK_DIMENSION
#define TPS_OUTLOOK_DIMENSION 0
#endif

namespace tps::properties::runs {
namespace {

/// A law of runs by its number, for scenes that it does not draw itself.
void obey(int number, const Scene& scene, Simulator& simulator) {
  const auto law = std::ranges::find(run_laws(), number, &RunLaw::number);
  const RunVerdict verdict = law->judge(scene, simulator);
  if (verdict.kind == RunVerdict::Kind::broken) RC_FAIL("law " + std::to_string(number) + ": " + verdict.why);
}

class OutlookRuns : public ::testing::TestWithParam<Outlook> {
 protected:
  static SmallScene drawn() {
    Wanted wanted;
    wanted.dimension = TPS_OUTLOOK_DIMENSION;
    const bool combined = *rc::gen::arbitrary<bool>();
    return *outlook_scene(GetParam(), wanted,
                          combined ? std::vector(kOutlook.begin(), kOutlook.end()) : std::vector<Outlook>());
  }

  void ask(const std::string& scalar, const std::string& timing) const {
    SmallScene small = drawn();
    small.scene.start_time = *rc::gen::element(0., .1, -1. / 3, 1e6);  // sums with it are no doubles
    const auto simulator = reference_simulator(scalar, timing);
    const std::string trace = simulator->simulate(small.scene, {.max_events = 60, .state_every = 13});
    if (const auto fault = check_instead().fault_in(trace)) RC_FAIL(*fault);
    obey(23, small.scene, *simulator);
  }
};

TEST_P(OutlookRuns, HoldInDouble) {
  rc::detail::checkGTest([&] { ask("double", "stable"); });
}

TEST_P(OutlookRuns, HoldCertified) {
  rc::detail::checkGTest([&] { ask("double", "certified"); });
}

TEST_P(OutlookRuns, AreOfValidScenes) {
  rc::detail::checkGTest([&] {
    const Scene scene = drawn().scene;
    RC_ASSERT(read_scene_text(write_scene(scene), "it") == scene);
  });
}

INSTANTIATE_TEST_SUITE_P(Effects, OutlookRuns, ::testing::ValuesIn(kOutlook),
                         [](const auto& test) { return std::string(name_of(test.param)); });

}  // namespace
}  // namespace tps::properties::runs

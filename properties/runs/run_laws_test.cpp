// The laws of runs, asked of the reference in the scalars and ways of timing that they are about.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <ostream>

#include "properties/runs/laws.hpp"
#include "reference/scene/read_scene.hpp"
#include "reference/scene/write_scene.hpp"

namespace tps::properties {

void PrintTo(const RunLaw& law, std::ostream* out) {
  *out << law.number << " " << law.name;
}

namespace {

struct Model {
  const char *scalar, *timing, *name;
};

void PrintTo(const Model& model, std::ostream* out) {
  *out << model.name;
}

class RunLaws : public ::testing::TestWithParam<std::tuple<RunLaw, Model>> {};

TEST_P(RunLaws, Hold) {
  const auto& [law, model] = GetParam();
  const auto simulator = reference_simulator(model.scalar, model.timing);
  rc::detail::checkGTest([&, &law = law] { check_law(law, *simulator); });
}

std::string name_of(const ::testing::TestParamInfo<std::tuple<RunLaw, Model>>& test) {
  const auto& [law, model] = test.param;
  return "Law" + std::to_string(law.number) + law.name + model.name;
}

INSTANTIATE_TEST_SUITE_P(Double, RunLaws,
                         ::testing::Combine(::testing::ValuesIn(run_laws()),
                                            ::testing::Values(Model{"double", "stable", "Double"})),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Float, RunLaws,
                         ::testing::Combine(::testing::ValuesIn(run_laws()),
                                            ::testing::Values(Model{"float", "stable", "Float"})),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Certified, RunLaws,
                         ::testing::Combine(::testing::ValuesIn(run_laws()),
                                            ::testing::Values(Model{"double", "certified", "Certified"})),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Paper, RunLaws,
                         ::testing::Combine(::testing::ValuesIn(run_laws()),
                                            ::testing::Values(Model{"double", "paper", "Paper"})),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Quad, RunLaws,
                         ::testing::Combine(::testing::ValuesIn(run_laws()),
                                            ::testing::Values(Model{"quad", "stable", "Quad"},
                                            Model{"long-double", "stable", "LongDouble"},Model{"mp50", "stable", "Mp50"})),
                         name_of);

RC_GTEST_PROP(SmallScenes, AreValid, ()) {
  const Scene scene = (*small_scene()).scene;
  RC_ASSERT(read_scene_text(write_scene(scene), "generated") == scene);
}

}  // namespace
}  // namespace tps::properties

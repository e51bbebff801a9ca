// Every law of runs, in double and in the plane: what a mutant has to survive.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "properties/runs/laws.hpp"

namespace tps::properties::runs {
namespace {

class Mutant : public ::testing::TestWithParam<RunLaw> {};

TEST_P(Mutant, Obeys) {
  const auto simulator = reference_simulator("double", "stable");
  rc::detail::checkGTest([&] { check_law(GetParam(), *simulator, 2); });
}

INSTANTIATE_TEST_SUITE_P(Run, Mutant, ::testing::ValuesIn(run_laws()), [](const auto& test) {
  return "Law" + std::to_string(test.param.number) + test.param.name;
});

}  // namespace
}  // namespace tps::properties::runs

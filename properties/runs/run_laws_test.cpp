// The laws of runs, asked of the reference in the scalars and ways of timing that they are about, and of a
// command.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <ostream>
#include <random>

#include "properties/runs/laws.hpp"
#include "reference/scene/read_scene.hpp"

namespace tps::properties::runs {

void PrintTo(const RunLaw& law, std::ostream* out) {
  *out << law.number << " " << law.name;
}

namespace {

std::string name_of(const ::testing::TestParamInfo<RunLaw>& test) {
  return "Law" + std::to_string(test.param.number) + test.param.name;
}

std::vector<RunLaw> chosen(bool (*wanted)(const RunLaw&)) {
  std::vector<RunLaw> some;
  for (const RunLaw& law : run_laws()) {
    if (wanted(law)) some.push_back(law);
  }
  return some;
}

void expect_to_hold(const RunLaw& law, const std::string& scalar, const std::string& timing) {
  const auto simulator = reference_simulator(scalar, timing);
  rc::detail::checkGTest([&] { check_law(law, *simulator); });
}

/// Every law, in double.
class RunLaws : public ::testing::TestWithParam<RunLaw> {};
TEST_P(RunLaws, Holds) {
  expect_to_hold(GetParam(), "double", "stable");
}
INSTANTIATE_TEST_SUITE_P(Double, RunLaws, ::testing::ValuesIn(run_laws()), name_of);

class CertifiedRunLaws : public ::testing::TestWithParam<RunLaw> {};
TEST_P(CertifiedRunLaws, Holds) {
  expect_to_hold(GetParam(), "double", "certified");
}
INSTANTIATE_TEST_SUITE_P(Double, CertifiedRunLaws, ::testing::ValuesIn(run_laws()), name_of);

class PaperRunLaws : public ::testing::TestWithParam<RunLaw> {};
TEST_P(PaperRunLaws, Holds) {
  expect_to_hold(GetParam(), "double", "paper");
}
INSTANTIATE_TEST_SUITE_P(Double, PaperRunLaws, ::testing::ValuesIn(chosen([](const RunLaw& law) {
                           return !law.needs_exact_timing;
                         })),
                         name_of);

/// Float is what shows absolute tolerances; long double is the widest type whose numbers a judge holds.
/// Neither can be turned round (reversal.hpp).
bool is_for_hardware(const RunLaw& law) {
  return law.name != "Reversal";
}
class HardwareRunLaws : public ::testing::TestWithParam<RunLaw> {};
TEST_P(HardwareRunLaws, HoldsInFloat) {
  expect_to_hold(GetParam(), "float", "stable");
}
TEST_P(HardwareRunLaws, HoldsInLongDouble) {
  expect_to_hold(GetParam(), "long-double", "stable");
}
INSTANTIATE_TEST_SUITE_P(All, HardwareRunLaws, ::testing::ValuesIn(chosen(is_for_hardware)), name_of);

/// What compares runs with runs needs no judge's numbers.
class WideRunLaws : public ::testing::TestWithParam<RunLaw> {};
TEST_P(WideRunLaws, HoldsInFiftyDigits) {
  expect_to_hold(GetParam(), "mp50", "stable");
}
INSTANTIATE_TEST_SUITE_P(All, WideRunLaws,
                         ::testing::ValuesIn(chosen([](const RunLaw& law) { return law.compares_runs; })),
                         name_of);

/// A row of balls of which the first drifts towards the others, far from a wall. All speeds are far below the
/// wall's: then rounding a velocity counts in the wall's frame by much more than in the scene's.
Scene slow_row(int seed) {
  std::mt19937 engine(static_cast<unsigned>(seed));
  std::uniform_real_distribution<double> unit(0, 1);
  const double speed = std::ldexp(1 + unit(engine), -10 - seed % 45);
  const double wall = std::ldexp(1 + unit(engine), seed % 12);
  std::string particles;
  for (int i = 0; i < 4; ++i) {
    const double side = i == 0 ? 0 : 0.3 * unit(engine);
    particles += fmt::format(R"({{"id":{},"species":"ball","position":[{},{}],"velocity":[{},{}]}},)", i,
                             1.0625 * i, side, i == 0 ? speed : 0, i == 0 ? speed * unit(engine) / 16 : 0);
  }
  particles +=
      fmt::format(R"({{"id":9,"species":"wall","position":[0,1e6],"velocity":[{},{}]}})", wall, -wall);
  return read_scene_text(
      fmt::format(R"({{"tps":1,"dimension":2,"duration":{},"species":{{"ball":{{"mass":1,"radius":0.5}},)"
                  R"("wall":{{"mass":"inf","radius":0.5}}}},"pairs":[{{"between":["ball","ball"],"blocking":)"
                  R"({{"distance":1,"c_rebound":0.5}}}}],"particles":[{}]}})",
                  2 / speed, particles),
      "row " + std::to_string(seed));
}

TEST(RunLaws, EnergyHoldsOfSlowBodiesBeforeFastWalls) {
  const auto simulator = reference_simulator("double", "stable");
  const std::vector<RunLaw> energy = chosen([](const RunLaw& law) { return law.name == "Energy"; });
  ASSERT_EQ(energy.size(), 1U);
  std::uint64_t events = 0;
  for (int seed = 0; seed < 300; ++seed) {
    const Scene scene = slow_row(seed);
    const RunVerdict verdict = energy[0].judge(scene, *simulator);
    EXPECT_EQ(verdict.kind, RunVerdict::Kind::holds) << "row " << seed << ": " << verdict.why;
    events += simulator->run(scene).events.size();
  }
  EXPECT_GE(events, 300U);
}

/// The way in which other implementations are asked.
TEST(RunLawsOfACommand, Hold) {
  const auto simulator = command_simulator({TPS_PROGRAM, "run"}, "double", "stable");
  for (const RunLaw& law : chosen([](const RunLaw& l) { return l.name == "Momentum" || l.name == "Resume"; }))
    rc::detail::checkGTest([&] { check_law(law, *simulator); });
}

TEST(RunLawsOfACommand, ACommandThatFailsIsNamed) {
  const auto simulator = command_simulator({"false"}, "double", "stable");
  try {
    simulator->run(Scene{});
    FAIL() << "the failure went unnoticed";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("ended with exit code 1"), std::string::npos) << error.what();
  }
}

TEST(RunLawsOfACommand, ACommandThatHangsIsNamedInTime) {
  const auto simulator = command_simulator({"sh", "-c", "sleep 1000 & sleep 1000", "sh"}, "double", "stable",
                                           std::chrono::milliseconds(200));
  try {
    simulator->run(Scene{});
    FAIL() << "the hang went unnoticed";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("did not end within 200 ms"), std::string::npos) << error.what();
  }
}

TEST(RunLawsOfACommand, NoShellReadsTheWords) {
  const auto simulator = command_simulator({"true; exit 3"}, "double", "stable");
  try {
    simulator->run(Scene{});
    FAIL() << "a shell read it";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("exit code 127"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace tps::properties::runs

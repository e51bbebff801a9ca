// Rule bias: times that are each within the bound, and a tenth of an ulp too long on the whole.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include "tests/run/traced_run.hpp"
#include "tests/trace_check/scenes.hpp"
#include "verify/certified/exact_timing.hpp"
#include "verify/trace_check/check.hpp"

namespace tps::mutation {
namespace {

using check::CheckReport;
using check::Rule;

constexpr std::uint64_t kEvents = 12'000;

/// Exact timing, but three times in ten, chosen by their digits, it is the next double in a direction.
class ShiftedTiming final : public CertifiedTiming {
 public:
  enum class Shift { later, earlier, either };
  explicit ShiftedTiming(Shift shift) : shift_(shift) {}

  CollisionTime<double> answer(const TimingQuery& query) override {
    CollisionTime<double> result = exact_.answer(query);
    if (!result.t || *result.t == 0) return result;
    const std::uint64_t scrambled = std::bit_cast<std::uint64_t>(*result.t) * 0x9e3779b97f4a7c15U;
    if (scrambled >> 32U >= (std::uint64_t{3} << 32U) / 10) return result;
    const bool later = shift_ == Shift::later || (shift_ == Shift::either && (scrambled & (1U << 20U)) != 0);
    result.t = std::nextafter(*result.t, later ? HUGE_VAL : 0.);
    return result;
  }
  std::weak_ordering order(const Moment& first, const Moment& second) override {
    return exact_.order(first, second);
  }
  const TimingCounters& counters() const override { return exact_.counters(); }

 private:
  certified::ExactTiming exact_;
  Shift shift_;
};

/// The check of a run whose times are shifted, which passes as one of stable formulas.
CheckReport checked_with(ShiftedTiming::Shift shift) {
  ShiftedTiming timing(shift);
  RunOptions options = testing::options_for("double", kEvents);
  options.timing = Timing::certified;
  options.certifier = &timing;
  std::string bytes = testing::traced_bytes(long_gas(), options);
  const std::string name = R"("timing":"certified")";
  bytes.replace(bytes.find(name), name.size(), R"("timing":"stable")");
  const std::size_t checksum = bytes.find(",\"checksum\"");  // an edited header leaves it out
  bytes.erase(checksum, bytes.find('}', checksum) - checksum);
  const std::string path = testing::scratch("shifted.ndjson");
  testing::write_bytes(path, bytes);
  return check::check_trace(path);
}

std::uint64_t violated_but_bias(const CheckReport& report) {
  return report.violated() - report.of(Rule::bias).violated;
}

TEST(Bias, OfThreeTenthsOfAnUlpLaterIsSeenAlthoughEveryStepPasses) {
  const CheckReport report = checked_with(ShiftedTiming::Shift::later);
  EXPECT_EQ(report.of(Rule::bias).violated, 1U) << report_text(report);
  EXPECT_EQ(violated_but_bias(report), 0U) << report_text(report);
}

TEST(Bias, OfThreeTenthsOfAnUlpEarlierIsSeenAlthoughEveryStepPasses) {
  const CheckReport report = checked_with(ShiftedTiming::Shift::earlier);
  EXPECT_EQ(report.of(Rule::bias).violated, 1U) << report_text(report);
  EXPECT_EQ(violated_but_bias(report), 0U) << report_text(report);
}

TEST(Bias, IsNotSeenInErrorsOfEitherSign) {
  const CheckReport report = checked_with(ShiftedTiming::Shift::either);
  EXPECT_TRUE(report.conforming()) << report_text(report);
  EXPECT_GT(report.of(Rule::bias).passed, 0U);
}

TEST(Bias, IsNotSeenInRunsOfAnyTiming) {
  for (const Timing timing : {Timing::paper, Timing::stable, Timing::certified}) {
    const std::string path = testing::scratch("long.ndjson");
    testing::write_bytes(path, trace_bytes(long_gas(), "double", timing, kEvents));
    const CheckReport report = check::check_trace(path);
    EXPECT_TRUE(report.conforming()) << report_text(report);
    EXPECT_GT(report.of(Rule::bias).passed, 0U) << report_text(report);
  }
}

/// The report of an elastic ball that flies in a circle, from anywhere in any direction.
CheckReport of_billiard(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const double near = std::uniform_real_distribution<double>(.5, .9)(random);
  const double angle = std::uniform_real_distribution<double>(0, 6.28)(random);
  Scene scene = testing::plain_scene(2);
  scene.particles.clear();
  const int circle = testing::add_species(scene, "circle", HUGE_VAL, 1);
  PairLaw& pair = testing::tether(scene, 0, circle, 1, 1, FormRule::When::permanent);
  pair.tethering->theta_revolve_deg = 1e-6;
  testing::add_particle(scene, circle, {0, 0, 0});
  testing::add_particle(scene, 0, {near * std::cos(angle), near * std::sin(angle), 0},
                        {-std::sin(angle), std::cos(angle), 0});
  const std::string path = testing::scratch("billiard.ndjson");
  testing::write_bytes(path,
                       trace_bytes(scene, "double", seed % 2 == 0 ? Timing::stable : Timing::paper, 40'000));
  return check::check_trace(path);
}

// Regular motion: all chords are one chord, turned. With residuals taken for independent a third of these
// runs was called biased.
TEST(Bias, IsNotSeenInRegularMotion) {
  int would_be_called = 0, repeating = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const CheckReport report = of_billiard(seed);
    EXPECT_TRUE(report.conforming()) << seed << '\n' << report_text(report);
    for (const check::ResidualSum& sum : report.sums)
      would_be_called += sum.count >= 10'000 && std::fabs(sum.mean) > .25 ? 1 : 0;
    repeating += report.of(Rule::bias).not_judged.find("repeats itself") != std::string::npos ? 1 : 0;
  }
  EXPECT_GE(repeating, 3);
  EXPECT_GE(would_be_called, 3) << "the runs no longer show what the clusters are for";
}

// Two tethered particles that revolve at whatever angle, without loss.
TEST(Bias, IsNotSeenInRevolutionsAtAnyAngle) {
  for (double theta = 4; theta < 85; theta += 12) {
    Scene scene = testing::plain_scene(2);
    testing::tether(scene, 0, 0, 1).tethering->theta_revolve_deg = theta;
    testing::add_particle(scene, 0, {0, 0, 0}, {0, -.5, 0});
    testing::add_particle(scene, 0, {1, 0, 0}, {0, .5, 0});
    scene.tethers.push_back({0, 1});
    const std::string path = testing::scratch("revolving.ndjson");
    testing::write_bytes(path, trace_bytes(scene, "double", Timing::stable, 15'000));
    const CheckReport report = check::check_trace(path);
    EXPECT_TRUE(report.conforming()) << theta << '\n' << report_text(report);
  }
}

}  // namespace
}  // namespace tps::mutation

// The checker is checked: it accepts every good trace, and every mutation is reported by the rule that owns
// it. Run as a whole, this program prints the kill matrix.
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "tests/run/traced_run.hpp"
#include "tests/trace_check/checked_trace.hpp"
#include "tests/trace_check/matrix.hpp"
#include "tests/trace_check/mutation.hpp"
#include "tests/trace_check/scenes.hpp"
#include "verify/trace_check/check.hpp"

namespace tps::mutation {
namespace {

using check::CheckReport;
using check::Finding;
using check::Rule;
using testing::checked;

std::string findings_of(const CheckReport& report) {
  std::string text;
  for (const Finding& f : report.findings) {
    text += std::string(name(f.rule)) + (f.outcome == check::Outcome::undecided ? "? " : ": ") + "line " +
            std::to_string(f.line) + ", event " + std::to_string(f.event) + ": " + f.message + "\n";
  }
  return text;
}

std::string as_test_name(std::string text) {
  std::erase(text, '-');
  return text;
}

class GoodTraces : public ::testing::TestWithParam<std::string> {
 protected:
  static void expect_conforming(const std::string& scalar, Timing timing, std::uint64_t events) {
    const NamedScene named = scene_named(GetParam());
    const CheckReport report =
        checked(trace_bytes(named.scene, scalar, timing, std::min(events, named.events)));
    const std::string what = scalar + ' ' + timing_names()[static_cast<std::size_t>(timing)];
    EXPECT_EQ(report.violated(), 0U) << what << '\n' << findings_of(report);
    EXPECT_FALSE(report.inconclusive()) << what << '\n' << findings_of(report);
    if (timing == Timing::certified) {
      EXPECT_EQ(report.undecided(), 0U) << what << '\n' << findings_of(report);
    }
  }
  static constexpr std::uint64_t kAll = 1'000'000;
};

TEST_P(GoodTraces, OfDoublesConform) {
  for (const Timing timing : {Timing::paper, Timing::stable, Timing::certified}) {
    expect_conforming("double", timing, kAll);
  }
}

TEST_P(GoodTraces, OfFloatsConform) {
  for (const Timing timing : {Timing::paper, Timing::stable, Timing::certified}) {
    expect_conforming("float", timing, kAll);
  }
}

TEST_P(GoodTraces, OfWideScalarsConform) {
  for (const char* scalar : {"long-double", "quad", "mp50", "mp100"}) {
    expect_conforming(scalar, Timing::stable, 40);
  }
  expect_conforming("quad", Timing::paper, 20);
}

TEST_P(GoodTraces, StayGoodUnderLegalChanges) {
  const NamedScene named = scene_named(GetParam());
  if (named.stands_still) GTEST_SKIP() << "nothing but its end is of interest";
  for (const Timing timing : {Timing::stable, Timing::certified}) {
    const Trace good = trace_of(trace_bytes(named.scene, "double", timing, named.events));
    for (const Legal& change : legal_changes()) {
      for (std::uint64_t number = 0; number < 3; ++number) {
        Trace trace = good;
        if (!change.apply(trace, number)) continue;
        const CheckReport report = checked(text_of(trace));
        EXPECT_TRUE(report.conforming()) << change.name << ' ' << number << '\n' << findings_of(report);
        matrix().note(change.name, named.name, Cell::legal);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, GoodTraces, ::testing::ValuesIn(scene_names()),
                         [](const auto& scene) { return as_test_name(scene.param); });

using SceneAndRun = std::tuple<std::string, std::string, Timing>;
class KillMatrix : public ::testing::TestWithParam<SceneAndRun> {};

/// Whether nobody is accused of anything before the first event that is wrong. A full state that lacks that
/// event is counted as of the event before.
bool starts_there(const CheckReport& report, std::uint64_t first_wrong) {
  const std::uint64_t broken =
      std::min(first_wrong, report.events);  // an event missing at the end has no number
  return std::ranges::none_of(report.findings, [broken](const Finding& f) {
    const std::uint64_t at = f.event + (f.rule == Rule::states ? 1 : 0);
    return f.outcome == check::Outcome::violated && f.event > 0 && at < broken;
  });
}

TEST_P(KillMatrix, EveryMutationIsReportedByItsOwner) {
  const auto& [scene, scalar, timing] = GetParam();
  const NamedScene named = scene_named(scene);
  const Trace good = trace_of(trace_bytes(named.scene, scalar, timing, named.events));
  const std::string column = scene + ' ' + scalar + ' ' + timing_names()[static_cast<std::size_t>(timing)];
  for (const Mutation& m : named.stands_still ? broken_standstills() : mutations()) {
    Trace trace = good;
    const Broken broken = m.apply(trace, 0);
    if (!broken) {
      matrix().note(m.name, column, Cell::not_applicable);
      continue;
    }
    const CheckReport report = checked(text_of(trace));
    const bool killed = report.of(m.owner).violated > 0;
    matrix().note(m.name, column, killed ? Cell::killed : Cell::survived);
    EXPECT_TRUE(killed) << m.name << " (" << m.sentence << "), first wrong event " << *broken << ": rule "
                        << name(m.owner) << " is silent\n"
                        << findings_of(report);
    EXPECT_TRUE(starts_there(report, *broken)) << m.name << ", first wrong event " << *broken << '\n'
                                               << findings_of(report);
  }
}

std::vector<SceneAndRun> runs() {
  std::vector<SceneAndRun> all;
  for (const std::string& scene : scene_names()) {
    all.emplace_back(scene, "double", Timing::stable);
    all.emplace_back(scene, "double", Timing::certified);
  }
  for (const char* scene : {"crowded", "nested", "planned", "three-body", "ring"}) {
    all.emplace_back(scene, "float", Timing::stable);
  }
  return all;
}

std::string name_of(const ::testing::TestParamInfo<SceneAndRun>& info) {
  const auto& [scene, scalar, timing] = info.param;
  return as_test_name(scene) + '_' + scalar + '_' + timing_names()[static_cast<std::size_t>(timing)];
}

INSTANTIATE_TEST_SUITE_P(Over, KillMatrix, ::testing::ValuesIn(runs()), name_of);

TEST(KillMatrixAsAWhole, HasAPlaceForEveryMutation) {
  std::vector<Mutation> unused = mutations();
  std::vector<Legal> unused_changes = legal_changes();
  for (const std::string& scene : scene_names()) {
    const NamedScene named = scene_named(scene);
    const Trace good = trace_of(trace_bytes(named.scene, "double", Timing::stable, named.events));
    const auto applies = [&](const auto& change) {
      Trace trace = good;
      return static_cast<bool>(change.apply(trace, 0));
    };
    std::erase_if(unused, applies);
    std::erase_if(unused_changes, applies);
  }
  for (const Mutation& m : unused) ADD_FAILURE() << m.name << " applies to no scene";
  for (const Legal& change : unused_changes) ADD_FAILURE() << change.name << " applies to no scene";
}

}  // namespace
}  // namespace tps::mutation

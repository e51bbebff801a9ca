// A trace that is judged in segments, on however many threads, has one report; faults near the borders are
// found as elsewhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>

#include "tests/run/traced_run.hpp"
#include "tests/trace_check/checked_trace.hpp"
#include "tests/trace_check/mutation.hpp"
#include "tests/trace_check/scenes.hpp"
#include "verify/trace_check/check.hpp"

namespace tps::mutation {
namespace {

using check::CheckOptions;
using check::CheckReport;
using testing::checked;

/// All that a report says, but how long it took.
std::string told(CheckReport report) {
  report.seconds = 0;
  return report_text(report) + report_json(report);
}

CheckReport in_segments(const std::string& bytes, unsigned jobs, std::size_t kept_bytes = 1U << 20U) {
  CheckOptions options;
  options.jobs = jobs;
  options.segment_lines = 8;
  options.segment_bytes = kept_bytes;
  return checked(bytes, options);
}

/// The report, the same from one thread and from three, whether lines are kept or read a second time.
CheckReport expect_one_report(const std::string& bytes) {
  const CheckReport alone = in_segments(bytes, 1);
  const std::string expected = told(alone);
  EXPECT_EQ(told(in_segments(bytes, 3)), expected);
  EXPECT_EQ(told(in_segments(bytes, 3, 100)), expected);
  return alone;
}

/// Full states every few events, so that there are many borders and each fault is near one.
std::string trace_of_scene(const NamedScene& named, const std::string& scalar, Timing timing) {
  return trace_bytes(named.scene, scalar, timing, std::min<std::uint64_t>(named.events, 300), 11);
}

class Segments : public ::testing::TestWithParam<std::string> {};

TEST_P(Segments, OfAGoodTraceConform) {
  const NamedScene named = scene_named(GetParam());
  if (named.stands_still) GTEST_SKIP() << "nothing but its end is of interest";
  for (const auto& [scalar, timing] :
       {std::pair{"double", Timing::certified}, std::pair{"double", Timing::paper},
        std::pair{"float", Timing::stable}}) {
    const CheckReport report = expect_one_report(trace_of_scene(named, scalar, timing));
    EXPECT_EQ(report.violated(), 0U) << told(report);
    EXPECT_FALSE(report.inconclusive()) << told(report);
  }
  constexpr std::size_t kFew = 20;  // wide scalars are slow
  if (named.scene.particles.size() > kFew) return;
  const CheckReport wide = expect_one_report(trace_bytes(named.scene, "quad", Timing::stable, 40, 11));
  EXPECT_EQ(wide.violated(), 0U) << told(wide);
}

/// Each mutation that applies: at its first place and at a later one.
void expect_all_caught(const std::string& scene, Timing timing,
                       const std::function<bool(std::size_t)>& is_chosen) {
  const NamedScene named = scene_named(scene);
  if (named.stands_still) return;
  const Trace good = trace_of(trace_of_scene(named, "double", timing));
  const std::vector<Mutation> all = mutations();
  for (std::size_t n = 0; n < all.size(); ++n) {
    if (!is_chosen(n)) continue;
    for (const std::uint64_t place : {0U, 7U}) {
      Trace trace = good;
      if (!all[n].apply(trace, place)) continue;
      const CheckReport report = expect_one_report(text_of(trace));
      EXPECT_GT(report.of(all[n].owner).violated, 0U)
          << all[n].name << " at place " << place << ": rule " << name(all[n].owner) << " is silent\n"
          << told(report);
    }
  }
}

/// A few for each scene, others for each.
TEST_P(Segments, HideNoMutation) {
  const std::size_t scene = std::hash<std::string>()(GetParam());
  expect_all_caught(GetParam(), Timing::certified, [&](std::size_t n) { return (n + scene) % 17 == 0; });
}

/// All of them: minutes. tests/trace_check/test_segments --gtest_also_run_disabled_tests
TEST_P(Segments, DISABLED_HideNoMutationAtAll) {
  for (const Timing timing : {Timing::stable, Timing::certified})
    expect_all_caught(GetParam(), timing, [](std::size_t) { return true; });
}

INSTANTIATE_TEST_SUITE_P(Of, Segments, ::testing::ValuesIn(scene_names()), [](const auto& scene) {
  std::string name = scene.param;
  std::erase(name, '-');
  return name;
});

std::string gas_trace(std::uint64_t state_every) {
  return trace_bytes(long_gas(), "double", Timing::certified, 400, state_every);
}

TEST(SegmentsOfATrace, AreManyWhereStatesAreMany) {
  EXPECT_GT(expect_one_report(gas_trace(10)).segments, 20U);
}

TEST(SegmentsOfATrace, AreOneWithoutStates) {
  EXPECT_EQ(expect_one_report(gas_trace(1000)).segments, 1U);
}

/// Particles 0-1 and 2-3 meet head on at the same moment, side by side: two rows that differ in y alone.
Scene two_rows() {
  Scene scene = testing::plain_scene();
  const int ball = testing::add_species(scene, "ball", 1, 0.5);
  for (const double y : {1.25, 12.0}) {
    testing::add_particle(scene, ball, {0, y, 0}, {1, 0, 0});
    testing::add_particle(scene, ball, {4, y, 0}, {-1, 0, 0});
  }
  testing::block(scene, ball, ball);
  return scene;
}

/// The rows told the other way round: what 0-1 do is told of 2-3, in the place of these.
Json with_rows_exchanged(Json line) {
  const auto other = [](int id) { return (id + 2) % 4; };
  const auto moved = [](Json& position) {
    position[1] = position[1] == "0x1.4p+0" ? "0x1.8p+3" : "0x1.4p+0";
  };
  if (is_event(line)) {
    for (const char* key : {"i", "j"}) line[key] = other(line[key]);
    for (const char* key : {"pre", "post"}) {
      Json exchanged = Json::object();
      for (auto& [id, state] : line[key].items()) {
        moved(state["position"]);
        exchanged[std::to_string(other(std::stoi(id)))] = state;
      }
      line[key] = exchanged;
    }
    return line;
  }
  Json particles = Json::array({{}, {}, {}, {}});
  for (Json& particle : line["particles"]) {
    const int id = other(particle["id"]);
    particle["id"] = id;
    moved(particle["position"]);
    particles[static_cast<std::size_t>(id)] = particle;
  }
  line["particles"] = particles;
  for (Json& pair : line["responded"])
    for (const std::size_t n : {0U, 1U}) pair[n] = other(pair[n]);
  line.erase("checksum");
  return line;
}

/// A state stands between two events of one moment. Told in the wrong order they break no rule but that of
/// their turns, and the second one is judged behind a border.
TEST(SegmentsOfATrace, KeepExactOrderAcrossTheirBorders) {
  const Trace right = trace_of(trace_bytes(two_rows(), "double", Timing::certified, 2, 1));
  const std::vector<std::size_t> events = event_lines(right);
  ASSERT_EQ(events.size(), 2U);
  ASSERT_EQ(events[1], events[0] + 2);
  Trace wrong = right;
  for (const std::size_t line : {events[0], events[0] + 1, events[1]})
    wrong.lines.change(line) = with_rows_exchanged(right.lines[line]);
  for (const char* key : {"k", "t", "dt"})
    ASSERT_EQ(wrong.lines[events[1]][key], right.lines[events[1]][key]);

  const auto judged = [](const Trace& trace, unsigned jobs) {
    CheckOptions options;
    options.jobs = jobs;
    options.segment_lines = 1;
    return checked(text_of(trace), options);
  };
  EXPECT_EQ(judged(right, 1).violated(), 0U) << told(judged(right, 1));
  EXPECT_GT(judged(right, 1).segments, 2U);
  EXPECT_EQ(told(judged(right, 1)), told(judged(right, 3)));
  const CheckReport report = judged(wrong, 1);
  EXPECT_GT(report.of(check::Rule::order).violated, 0U) << told(report);
  EXPECT_GT(report.of(check::Rule::earliest).violated, 0U) << told(report);  // of whom the state left waiting
  EXPECT_EQ(report.violated(), 2U) << told(report);
  EXPECT_EQ(told(judged(wrong, 3)), told(report));
}

/// From a pipe nothing can be read twice: a segment that is too long to be kept is judged as it comes.
TEST(SegmentsOfATrace, ComeFromAPipeAsFromAFile) {
  const std::string path = testing::scratch("piped.ndjson");
  testing::write_bytes(path, gas_trace(50));
  const std::string tps = TPS_PROGRAM;
  for (const char* rest : {"", " | head -n 200", " | sed '90s/rebound/retract/'"}) {
    std::string reports[2];
    for (const int jobs : {1, 2}) {
      const std::string out = testing::scratch("report.txt");
      const std::string command = "cat " + path + rest + " | " + tps + " check -q --jobs " +
                                  std::to_string(jobs) + " -o " + out + " -";
      static_cast<void>(std::system(command.c_str()));
      reports[jobs - 1] = testing::read_bytes(out);
    }
    EXPECT_FALSE(reports[0].empty());
    EXPECT_EQ(reports[0], reports[1]);
  }
}

}  // namespace
}  // namespace tps::mutation

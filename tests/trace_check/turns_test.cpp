// Lies about what was due and in which order, by the hundred: of every honest trace the same trace told
// otherwise, wrong exactly where it says so (docs/check.md, "Whose turn it is").
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "reference/text/hexfloat.hpp"
#include "tests/trace_check/rows.hpp"
#include "tests/trace_check/told.hpp"

namespace tps::mutation {
namespace {

constexpr std::uint64_t kScenes = 12;  // of every kind

std::string time_of(const Trace& trace, std::size_t line) {
  return trace.lines[line].at("t");
}

using RowsAndMaking = std::tuple<Rows, std::string, Timing>;
class ToldOtherwise : public ::testing::TestWithParam<RowsAndMaking> {
 protected:
  Rows rows() const { return std::get<0>(GetParam()); }
  Making making() const { return {std::get<1>(GetParam()), std::get<2>(GetParam())}; }
  bool certified() const { return making().timing == Timing::certified; }
  /// Whether something by the first time is clearly not due at the second: without certified timing a trace
  /// is judged by an interval of computed times.
  bool clearly_before(const Json& t, const Json& other) const {
    return certified() ? elapsed(t, other) >= 0 : elapsed(t, other) > 1e-12 * number(other);
  }

  Trace whole_run(std::uint64_t seed) const {
    RunOptions options;
    options.max_events = 24;
    return run_of(scene_of_rows(rows(), seed), making(), options);
  }
};

TEST_P(ToldOtherwise, EndsThatComeTooLate) {
  Told told;
  for (std::uint64_t seed = 0; seed < kScenes; ++seed) {
    const Trace whole = whole_run(seed);
    expect_honest(whole, told, "the run itself");
    const std::vector<std::size_t> events = event_lines(whole);
    for (std::size_t n = 0; n < events.size(); ++n) {
      const std::string what = "behind " + std::to_string(n) + " events, seed " + std::to_string(seed);
      const std::string last = n == 0 ? "0x0p+0" : time_of(whole, events[n - 1]);
      const std::string next = time_of(whole, events[n]);
      const bool in_a_step = whole.lines[events[n]].at("kind") == "restitute" && last == next && n > 0 &&
                             whole.lines[events[n - 1]].at("kind") == "restitute" &&
                             rows() != Rows::bodies;  // of more than two: its nodes are one step
      if (in_a_step) continue;
      expect_honest(ended_behind(whole, n, "max_events", last), told, what + ", max_events");
      expect_lie(ended_behind(whole, n, "no_more_events", last), told, what + ", no_more_events");
      const std::string kind = whole.lines[events[n]].at("kind");
      const bool is_known = kind == "restitute" || kind == "scheduled_impulse" || kind.starts_with("phase");
      if (!certified() && !is_known) continue;
      expect_lie(ended_behind(whole, n, "duration", next), told, what + ", at the next");
    }
  }
  EXPECT_GT(told.lies, 50);
}

/// Runs that end at an event's time, at the numbers beside it, and between two.
TEST_P(ToldOtherwise, DurationsAtEvents) {
  Told told;
  for (std::uint64_t seed = 0; seed < kScenes; ++seed) {
    const Scene scene = scene_of_rows(rows(), seed);
    const Trace whole = whole_run(seed);
    std::set<double> times;
    for (const std::size_t line : event_lines(whole)) {
      const double t = number(whole.lines[line].at("t"));
      for (const double beside : {std::nextafter(t, 0.), t, std::nextafter(t, HUGE_VAL), t * 1.125})
        times.insert(making().scalar == "float" ? static_cast<double>(static_cast<float>(beside)) : beside);
      if (times.size() > 16) break;
    }
    for (const double until : times) {
      if (!(until > 0)) continue;
      RunOptions options;
      options.until = until;
      const Trace run = run_of(scene, making(), options);
      const std::string what = "until " + std::to_string(until) + ", seed " + std::to_string(seed);
      expect_honest(run, told, what);
      const std::vector<std::size_t> events = event_lines(run);
      for (std::size_t dropped = 1; dropped <= std::min<std::size_t>(3, events.size()); ++dropped) {
        const std::size_t kept = events.size() - dropped;
        if (!clearly_before(run.lines[events[kept]].at("t"), to_hex(until))) continue;
        if (run.lines.back().at("end") != "duration") continue;
        expect_lie(ended_behind(run, kept, "duration", to_hex(until)), told, what);
      }
    }
  }
  EXPECT_GT(told.lies, 25);
}

std::set<int> particles_of(const Json& event) {
  std::set<int> ids;
  if (!event.contains("pre")) return ids;
  for (const auto& [id, state] : event.at("pre").items()) ids.insert(std::stoi(id));
  return ids;
}

bool share_nobody(const Json& a, const Json& b) {
  for (const int id : particles_of(a)) {
    if (particles_of(b).contains(id)) return false;
  }
  return true;
}

/// An event that is missing while its particles have no other.
TEST_P(ToldOtherwise, EventsThatNeverCame) {
  Told told;
  for (std::uint64_t seed = 0; seed < kScenes; ++seed) {
    const Trace whole = whole_run(seed);
    const std::vector<std::size_t> events = event_lines(whole);
    for (std::size_t n = 0; n + 1 < events.size(); ++n) {
      const Json& gone = whole.lines[events[n]];
      const bool is_last_of_its =
          std::all_of(events.begin() + static_cast<std::ptrdiff_t>(n) + 1, events.end(),
                      [&](std::size_t m) { return share_nobody(gone, whole.lines[m]); });
      const bool is_in_time = clearly_before(gone.at("t"), whole.lines[events.back()].at("t"));
      if (!is_last_of_its || !is_in_time || !gone.contains("i")) continue;
      Trace lie = whole;
      erase_line(lie, events[n]);
      settle(lie);
      expect_lie(lie, told, "without event " + std::to_string(n + 1) + ", seed " + std::to_string(seed));
    }
  }
  const bool has_gaps = rows() == Rows::ties || rows() == Rows::bodies || rows() == Rows::planned;
  EXPECT_TRUE(told.lies > 5 || !has_gaps) << told.lies;
}

/// Two neighbours that share nobody come in the other order, the one that is now second at the clock's time.
TEST_P(ToldOtherwise, NeighboursExchanged) {
  Told told;
  for (std::uint64_t seed = 0; seed < 3 * kScenes; ++seed) {
    const Trace whole = whole_run(seed);
    Retold before(whole);
    const std::vector<std::size_t> events = event_lines(whole);
    for (std::size_t n = 0; n + 1 < events.size(); ++n) {
      const Json& first = whole.lines[events[n]];
      const Json& second = whole.lines[events[n + 1]];
      const double apart = elapsed(first.at("t"), second.at("t"));
      const bool near = certified() ? apart <= epsilon(whole) * number(second.at("t")) : apart == 0;
      if (near && first.contains("i") && share_nobody(first, second)) {
        Trace lie = whole;
        lie.lines.change(events[n])["t"] = second.at("t");
        for (const char* when : {"pre", "post"}) {
          for (const auto& [id, state] : lie.lines.change(events[n])[when].items())
            state["position"] = spelt(lie, before.position(std::stoi(id), second.at("t")));
        }
        lie.lines.swap(events[n], events[n + 1]);
        settle(lie);
        expect_lie(lie, told, "event " + std::to_string(n + 1) + ", seed " + std::to_string(seed));
      }
      before.hear(whole.lines[events[n]], events[n]);
    }
  }
  const bool has_ties =
      rows() == Rows::ties || rows() == Rows::bodies || (certified() && rows() == Rows::near_ties);
  EXPECT_TRUE(told.lies > 10 || !has_ties) << told.lies;
}

/// Powers of two for units change no verdict, up to the ends of the range.
TEST_P(ToldOtherwise, AreLiesInAnyUnits) {
  if (making().scalar == "float") GTEST_SKIP() << "floats have no such range";
  Told told;
  for (const auto& [length, speed] : {std::pair(-900, -880), std::pair(-300, 20), std::pair(300, 290),
                                      std::pair(-280, -282), std::pair(980, 900), std::pair(0, -900)}) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      const Trace whole = whole_run(seed);
      const std::string what = "lengths 2^" + std::to_string(length) + ", seed " + std::to_string(seed);
      const std::vector<std::size_t> events = event_lines(whole);
      expect_honest(in_units(whole, length, speed), told, what);
      for (std::size_t n = 0; n < events.size(); n += 2) {
        const std::string last = n == 0 ? "0x0p+0" : time_of(whole, events[n - 1]);
        expect_lie(in_units(ended_behind(whole, n, "no_more_events", last), length, speed), told, what);
        const std::string later = to_hex(number(whole.lines[events[n]].at("t")) * 1.5 + .25);
        expect_lie(in_units(ended_behind(whole, n, "duration", later), length, speed), told, what);
      }
    }
  }
  EXPECT_GT(told.lies, 30);
}

std::vector<RowsAndMaking> all() {
  std::vector<RowsAndMaking> list;
  for (const Rows rows : kRows) {
    list.emplace_back(rows, "double", Timing::certified);
    list.emplace_back(rows, "float", Timing::certified);
    // Grazes are undecided then.
    if (rows != Rows::grazes) list.emplace_back(rows, "double", Timing::stable);
  }
  return list;
}

std::string name_of(const ::testing::TestParamInfo<RowsAndMaking>& info) {
  constexpr const char* kNames[] = {"Ties", "NearTies", "Grazes", "Bodies", "Planned", "Tethered"};
  const auto& [rows, scalar, timing] = info.param;
  return std::string(kNames[static_cast<int>(rows)]) + '_' + scalar + '_' +
         timing_names()[static_cast<std::size_t>(timing)];
}

INSTANTIATE_TEST_SUITE_P(Of, ToldOtherwise, ::testing::ValuesIn(all()), name_of);

}  // namespace
}  // namespace tps::mutation

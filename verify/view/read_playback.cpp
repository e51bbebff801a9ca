#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "reference/run/run.hpp"
#include "verify/trace_check/read_line.hpp"
#include "verify/trace_check/trace_input.hpp"
#include "verify/trace_check/wide.hpp"
#include "verify/view/playback.hpp"
#include "verify/view/recorder.hpp"

namespace tps::view {
namespace {

/// Lines that are none of a trace: how many, and the first.
struct PassedOver {
  std::uint64_t count = 0, first = 0;
  std::string why;
};

/// Whether an event is at a line that matters, or beside one.
bool is_beside(const std::vector<std::uint64_t>& lines, std::uint64_t line) {
  const std::uint64_t from = line > 2 ? line - 2 : 0;
  const auto next = std::lower_bound(lines.begin(), lines.end(), from);
  return next != lines.end() && *next <= line + 2;
}

/// Thins as little as makes it fit. What came since the last time is dense, so that this may be enough.
void fit(Playback& playback, std::uint64_t most_events, const std::function<bool(const Event&)>& keep) {
  thin(playback, keep);
  if (playback.events.size() <= most_events) return;
  playback.one_of *= 2;
  thin(playback, keep);
}

template <typename Number>
void read_lines(check::TraceInput& input, int digits, const PlaybackOptions& options, Playback& playback) {
  const check::TraceFileHead& head = input.head();
  check::LineReading<Number> reading(head.scene, head.minimal, digits);
  Recorder recorder(playback);
  PassedOver passed;
  const auto keep = [&](const Event& event) { return is_beside(options.lines, event.line); };
  check::LineText line;
  while (input.next(line)) {
    // Full states repeat what the events say; their verdict is the check's.
    if (line.text.starts_with("{\"state\":")) continue;
    try {
      const check::Line<Number>& read = reading.read(line.text);
      if (const auto* event = std::get_if<check::EventLine<Number>>(&read)) {
        recorder.event(*event, input.lines());
      } else if (const auto* end = std::get_if<check::EndLine<Number>>(&read)) {
        playback.end = end->reason;
        playback.t_end = std::max(playback.t_end, static_cast<double>(end->t.hi));
      }
    } catch (const check::LineProblem& problem) {
      if (passed.count++ == 0) {
        passed.first = input.lines();
        passed.why = fmt::format("{} {}", problem.pointer, problem.what());
      }
    }
    if (playback.events.size() >= 2 * options.most_events) fit(playback, options.most_events, keep);
  }
  if (playback.events.size() > options.most_events) fit(playback, options.most_events, keep);
  if (passed.count > 0) {
    playback.notes.push_back(fmt::format(
        "{} line{} could not be read and {} left out; the first is line {}: {}", passed.count,
        passed.count == 1 ? "" : "s", passed.count == 1 ? "is" : "are", passed.first, passed.why));
  }
  if (playback.end.empty())
    playback.notes.emplace_back("the trace has no last line: its run was killed, or could not write");
}

int digits_of(const std::string& scalar) {
  return scalar == "float" ? 24 : scalar == "double" ? 53 : 833;
}

}  // namespace

Playback start_of(Scene scene) {
  Playback playback;
  for (const Tether& tether : scene.tethers) playback.tethers.push_back({0, tether.i, tether.j, true});
  playback.scene = std::move(scene);
  return playback;
}

Playback read_playback(const std::string& trace, const PlaybackOptions& options) {
  check::TraceInput input(trace, options.scene, options.stop);
  Playback playback = start_of(input.head().scene);
  if (input.head().has_another_scene)
    playback.notes.push_back("the trace has a scene of its own, which is not that of " + options.scene +
                             "; its own is shown");
  playback.scalar = input.head().scalar;
  playback.timing = timing_names()[static_cast<std::size_t>(input.head().timing)];
  const int digits = digits_of(playback.scalar);
  if (digits <= 53) {
    read_lines<double>(input, digits, options, playback);
  } else {
    read_lines<check::Wide>(input, digits, options, playback);
    playback.notes.push_back(
        fmt::format("numbers of the trace are {}, those shown here doubles", playback.scalar));
  }
  if (playback.scene.drag)
    playback.notes.emplace_back(
        "drag: time here is the clock s of the run, in which paths are straight, and velocities are du/ds");
  return playback;
}

void thin(Playback& playback, const std::function<bool(const Event&)>& keep) {
  std::vector<Event> events;
  std::vector<Change> changes;
  std::vector<Change> carried;
  std::vector<int> place(playback.scene.particles.size(), -1);  // in `carried`
  for (std::size_t n = 0; n < playback.events.size(); ++n) {
    Event event = playback.events[n];
    const std::size_t end =
        n + 1 < playback.events.size() ? playback.events[n + 1].first_change : playback.changes.size();
    for (std::size_t c = event.first_change; c < end; ++c) {
      const Change& change = playback.changes[c];
      int& at = place[static_cast<std::size_t>(change.particle)];
      if (at < 0) {
        at = static_cast<int>(carried.size());
        carried.push_back(change);
      } else {
        carried[static_cast<std::size_t>(at)] = change;
      }
    }
    const bool last = n + 1 == playback.events.size();
    if (event.number % playback.one_of != 0 && !last && !keep(event)) continue;
    event.first_change = changes.size();
    for (const Change& change : carried) {
      place[static_cast<std::size_t>(change.particle)] = -1;
      changes.push_back(change);
    }
    carried.clear();
    events.push_back(event);
  }
  playback.events = std::move(events);
  playback.changes = std::move(changes);
}

}  // namespace tps::view

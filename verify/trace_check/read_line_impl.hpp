// LineReading, included by the instantiating source only (simdjson is a heavy header).
#pragma once

#include <algorithm>
#include <set>

#include "reference/text/input_error.hpp"
#include "verify/trace_check/event_reading.hpp"
#include "verify/trace_check/own_spelling.hpp"
#include "verify/trace_check/read_line.hpp"

namespace tps::check {

template <typename Number>
class LineReading<Number>::Json : private EventReading<Number> {
 public:
  using Values = EventReading<Number>;

  using EventReading<Number>::EventReading;

  Line<Number>& read(std::string_view line_text) {
    if (line_text.starts_with("{\"k\":")) {
      EventLine<Number>& event = fresh_event();
      if (OwnSpelling<Number, LineValues<Number>>(*this, line_text).read(event)) {
        EventDemands<Number>(event, minimal(), has_drag()).demand();
        return line_;
      }
    }
    return line_ = of_any_spelling(line_text);
  }

 private:
  using Values::clock;
  using Values::count;
  using Values::has_drag;
  using Values::instant;
  using Values::minimal;
  using Values::text;
  using Values::time;

  EventLine<Number>& fresh_event() {
    auto* const event = std::get_if<EventLine<Number>>(&line_);
    if (event == nullptr) return line_.template emplace<EventLine<Number>>();
    event->restart();
    return *event;
  }

  Line<Number> of_any_spelling(std::string_view line_text) {
    // The parser skips a byte order mark, which no line of ours has.
    if (line_text.starts_with("\xEF\xBB\xBF")) problem(kLine, "starts with a byte order mark");
    dom::element root;
    const simdjson::error_code error = parser_.parse(line_text.data(), line_text.size()).get(root);
    if (error != simdjson::SUCCESS) {
      problem(kLine,
              fmt::format("is not JSON ({}); a trace has one object a line", simdjson::error_message(error)));
    }
    dom::object line;
    if (root.get(line) != simdjson::SUCCESS)
      problem(kLine, "is not an object; a trace has one object a line");
    dom::element ignored;
    if (line["state"].get(ignored) == simdjson::SUCCESS) return state(line, line_text);
    if (line["end"].get(ignored) == simdjson::SUCCESS) return end_of(line);
    return this->event(line);
  }

  StateLine<Number> state(const dom::object& line, std::string_view line_text) const {
    dom::element t;
    StateLine<Number> state;
    try {
      state.data = read_state(line_text);
    } catch (const InputError& error) {
      const InputProblem& first = error.problems().front();
      throw LineProblem(first.pointer, first.message);
    }
    if (has_drag()) {
      state.time = number_of<double>(state.data.t);
      if (!state.time) problem("t", "is no double, which the time of a scene with \"drag\" is");
      state.t = {Number(0), Number(0)};  // rule states takes "now"
    } else if (line["t"].get(t) == simdjson::SUCCESS) {
      state.t = instant(t, Pointer{&kLine, "t"});
    }
    return state;
  }

  EndLine<Number> end_of(const dom::object& line) const try {
    return end(line);
  } catch (const LineProblem& problem) {
    throw EndProblem(problem);
  }

  EndLine<Number> end(const dom::object& line) const {
    static const std::vector<std::string> keys = {"end", "events", "t", "s"};
    static const std::vector<std::string> reasons = {"duration", "max_events",  "no_more_events",
                                                     "stalled",  "interrupted", "out_of_range"};
    std::set<std::string_view> seen;
    for (const auto [key, ignored] : line) {
      if (std::find(keys.begin(), keys.end(), key) == keys.end())
        unknown_key(Pointer{&kLine, key}, key, keys);
      if (!seen.insert(key).second) problem(Pointer{&kLine, key}, "stands twice in the line");
    }
    dom::element reason, events, t, s;
    if (line["end"].get(reason) != simdjson::SUCCESS || line["events"].get(events) != simdjson::SUCCESS ||
        line["t"].get(t) != simdjson::SUCCESS) {
      problem(kLine, "is no complete end: {\"end\":reason,\"events\":n,\"t\":…}");
    }
    const bool has_s = line["s"].get(s) == simdjson::SUCCESS;
    if (has_s && !has_drag()) problem("s", "is for scenes with \"drag\"");
    if (!has_s && has_drag())
      problem(kLine, "lacks \"s\", the clock at the end, which a trace of a scene with \"drag\" has");
    EndLine<Number> end{std::string(text(reason, Pointer{&kLine, "end"})),
                        count(events, Pointer{&kLine, "events"}),
                        has_s ? clock(s, Pointer{&kLine, "s"}) : instant(t, Pointer{&kLine, "t"}),
                        {},
                        {}};
    // The end of a duration is start_time + duration exactly, which a double may not hold.
    if (has_s && end.reason == "duration") end.duration = instant(t, Pointer{&kLine, "t"});
    if (has_s && end.reason != "duration") end.time = time(t, Pointer{&kLine, "t"});
    if (std::find(reasons.begin(), reasons.end(), end.reason) == reasons.end()) {
      problem("end", fmt::format("\"{}\" is no reason; allowed are {}", end.reason.substr(0, 60),
                                 fmt::join(reasons, ", ")));
    }
    return end;
  }

  dom::parser parser_;
  Line<Number> line_;
};

template <typename Number>
LineReading<Number>::LineReading(const Scene& scene, bool minimal, int digits)
    : json_(std::make_unique<Json>(scene, minimal, digits)) {}
template <typename Number>
LineReading<Number>::~LineReading() = default;

template <typename Number>
Line<Number>& LineReading<Number>::read(std::string_view text) {
  return json_->read(text);
}

}  // namespace tps::check

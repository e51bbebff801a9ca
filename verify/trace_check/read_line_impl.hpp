// LineReading, included by the instantiating source only (simdjson is a heavy header).
#pragma once

#include <algorithm>
#include <set>

#include "reference/text/input_error.hpp"
#include "verify/trace_check/event_demands.hpp"
#include "verify/trace_check/line_values.hpp"
#include "verify/trace_check/own_spelling.hpp"
#include "verify/trace_check/read_line.hpp"

namespace tps::check {

inline const std::vector<std::string>& event_keys() {
  static const std::vector<std::string> keys = {
      "k",         "t",  "dt",     "kind", "i",       "j", "phase", "pre",  "post", "dp",
      "dp_stored", "dv", "tether", "draw", "members", "s", "ds",    "wall", "face", "contact"};
  return keys;
}

template <typename Number>
class LineReading<Number>::Json : private LineValues<Number> {
 public:
  using Values = LineValues<Number>;

  using Values::LineValues;

  Line<Number> read(std::string_view line_text) {
    if (line_text.starts_with("{\"k\":")) {
      EventLine<Number> event;
      if (OwnSpelling<Number, Values>(*this, line_text).read(event)) {
        EventDemands<Number>(event, minimal(), has_drag()).demand();
        return event;
      }
    }
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
    if (line["end"].get(ignored) == simdjson::SUCCESS) return end(line);
    return event(line);
  }

 private:
  using Values::clock;
  using Values::count;
  using Values::has_drag;
  using Values::instant;
  using Values::minimal;
  using Values::number;
  using Values::particle;
  using Values::particle_named;
  using Values::spin;
  using Values::text;
  using Values::time;
  using Values::vector;

  static Kind kind_of(std::string_view text) {
    std::vector<std::string_view> names;
    for (const KindRow& known : kKinds) {
      if (known.name == text) return known.kind;
      names.push_back(known.name);
    }
    problem("kind", fmt::format("\"{}\" is not a kind of event; allowed are {}", text.substr(0, 60),
                                fmt::join(names, ", ")));
  }

  EventLine<Number> event(const dom::object& line) {
    EventLine<Number> event;
    bool has_kind = false, has_t = false, has_s = false;
    std::uint32_t seen = 0;
    for (const auto [key, value] : line) {
      const Pointer at{&kLine, key};
      const auto known = std::find(event_keys().begin(), event_keys().end(), key);
      if (known == event_keys().end()) unknown_key(at, key, event_keys());
      const std::uint32_t bit = 1U << static_cast<unsigned>(known - event_keys().begin());
      if ((seen & bit) != 0) problem(at, "stands twice in the line");
      seen |= bit;
      if (key == "k") event.k = count(value, at);
      if ((key == "s" || key == "ds") && !has_drag()) problem(at, "is for scenes with \"drag\"");
      if (key == "s") event.t = clock(value, at);
      has_s = has_s || key == "s";
      if (key == "t") {
        if (has_drag()) {
          event.time = time(value, at);
        } else {
          event.t = instant(value, at);
        }
        event.t_text =
            value.is_string() ? std::string(text(value, at)) : fmt::format("{}", simdjson::minify(value));
        has_t = true;
      }
      if (key == "dt" && has_drag()) problem(at, "is \"ds\" in scenes with \"drag\"");
      if (key == "dt" || key == "ds") event.dt = number(value, at);
      if (key == "kind") {
        event.kind = kind_of(text(value, at));
        has_kind = true;
      }
      if (key == "i") event.i = particle(value, at);
      if (key == "j") event.j = particle(value, at);
      if (key == "phase") event.phase = place(value, at);
      if (key == "wall") event.wall = place(value, at);
      if (key == "face") event.face = place(value, at);
      if (key == "dp") event.dp = vector(value, at);
      if (key == "dv") event.dv = vector(value, at);
      if (key == "dp_stored") event.dp_stored = vector(value, at);
      if (key == "contact") event.sticks = sticks(text(value, at));
      if (key == "tether") event.formed = formed(text(value, at));
      if (key == "draw") event.draw = draw(value, at);
      if (key == "members") event.members = members(value, at);
    }
    if (!has_t) problem(kLine, "has no \"t\": every event has one, or the line is no event");
    if (has_drag() && !has_s)
      problem(kLine,
              "has no \"s\": with \"drag\" every event has one, the clock in which paths are straight");
    if (!has_kind) problem(kLine, "has no \"kind\": every event has one");
    states(line, event);
    EventDemands<Number>(event, minimal(), has_drag()).demand();
    return event;
  }

  /// A place in a list of the scene.
  int place(dom::element value, const Pointer& at) const {
    return static_cast<int>(std::min<std::uint64_t>(count(value, at), 1U << 30U));
  }

  static bool formed(std::string_view text) {
    if (text != "formed" && text != "broken") problem("tether", "is neither \"formed\" nor \"broken\"");
    return text == "formed";
  }

  static bool sticks(std::string_view text) {
    if (text != "sticks" && text != "slides") problem("contact", "is neither \"sticks\" nor \"slides\"");
    return text == "sticks";
  }

  double draw(dom::element value, const Pointer& at) const {
    std::optional<double> result;
    double plain = 0;
    std::string_view hex;
    if (minimal() && value.get(plain) == simdjson::SUCCESS) result = plain;
    if (value.get(hex) == simdjson::SUCCESS) result = number_of<double>(hex);
    if (!result || !(*result >= 0 && *result < 1)) {
      problem(at, "is not a draw: a double in [0, 1) as a hexadecimal float in a string, \"0x1.8p-1\"");
    }
    return *result;
  }

  std::vector<int> members(dom::element value, const Pointer& at) const {
    dom::array ids;
    if (value.get(ids) != simdjson::SUCCESS || ids.size() == 0) problem(at, "is not a list of particles");
    std::vector<int> result;
    for (const dom::element id : ids) result.push_back(particle(id, at));
    for (std::size_t n = 1; n < result.size(); ++n) {
      if (result[n - 1] >= result[n]) problem(at, "is not ascending");
    }
    return result;
  }

  void states(const dom::object& line, EventLine<Number>& event) const {
    dom::object before, after;
    dom::element pre, post;
    const bool has_post = line["post"].get(post) == simdjson::SUCCESS;
    const bool has_pre = line["pre"].get(pre) == simdjson::SUCCESS;
    if (has_post && post.get(after) != simdjson::SUCCESS) problem("post", "is not an object");
    if (has_pre && pre.get(before) != simdjson::SUCCESS) problem("pre", "is not an object");
    if (has_post) {
      for (const auto [key, value] : after) {
        const Pointer at{&kPost, key};
        InvolvedParticle<Number> p{};
        p.particle = particle_named(key, at);
        if (event.of(p.particle) != nullptr) problem(at, "stands twice in the line");
        dom::element velocity, position;
        check_keys(value, at);
        if (value["velocity"].get(velocity) != simdjson::SUCCESS) problem(at, "has no \"velocity\"");
        p.velocity_after = vector(velocity, Pointer{&at, "velocity"});
        if (value["position"].get(position) == simdjson::SUCCESS) {
          p.position_after = vector(position, Pointer{&at, "position"});
        } else if (!minimal()) {
          problem(at, "has no \"position\"");
        }
        if (value["spin"].get(velocity) == simdjson::SUCCESS)
          p.spin_after = spin(velocity, Pointer{&at, "spin"});
        event.involved.push_back(std::move(p));
      }
    }
    if (has_pre) read_before(before, event);
  }

  void read_before(const dom::object& before, EventLine<Number>& event) const {
    std::size_t found = 0;
    for (const auto [key, value] : before) {
      const Pointer at{&kPre, key};
      const int index = particle_named(key, at);
      InvolvedParticle<Number>* p = event.of(index);
      if (p == nullptr) problem(at, "is not in \"post\"");
      if (p->velocity_before || p->position_before) problem(at, "stands twice in the line");
      dom::element velocity, position;
      check_keys(value, at);
      if (value["velocity"].get(velocity) == simdjson::SUCCESS)
        p->velocity_before = vector(velocity, Pointer{&at, "velocity"});
      dom::element turning;
      if (value["spin"].get(turning) == simdjson::SUCCESS)
        p->spin_before = spin(turning, Pointer{&at, "spin"});
      if (value["position"].get(position) == simdjson::SUCCESS)
        p->position_before = vector(position, Pointer{&at, "position"});
      if (!minimal() && (!p->velocity_before || !p->position_before))
        problem(at, "lacks \"position\" or \"velocity\"");
      ++found;
    }
    if (!minimal() && found != event.involved.size())
      problem("pre", "does not have the particles of \"post\"");
  }

  static void check_keys(dom::element value, const Pointer& at) {
    static const std::vector<std::string> keys = {"position", "velocity", "spin"};
    dom::object object;
    if (value.get(object) != simdjson::SUCCESS) problem(at, "is not an object");
    int positions = 0, velocities = 0, spins = 0;
    for (const auto [key, ignored] : object) {
      positions += key == "position" ? 1 : 0;
      velocities += key == "velocity" ? 1 : 0;
      spins += key == "spin" ? 1 : 0;
      if (key != "position" && key != "velocity" && key != "spin") unknown_key(Pointer{&at, key}, key, keys);
    }
    if (positions > 1 || velocities > 1 || spins > 1) problem(at, "has a key twice");
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
    if (has_s != has_drag())
      problem(has_s ? "s" : "", has_s ? "is for scenes with \"drag\"" : "has no \"s\", as with \"drag\"");
    EndLine<Number> end{std::string(text(reason, Pointer{&kLine, "end"})),
                        count(events, Pointer{&kLine, "events"}),
                        has_s ? clock(s, Pointer{&kLine, "s"}) : instant(t, Pointer{&kLine, "t"}),
                        {}};
    if (has_s) end.time = time(t, Pointer{&kLine, "t"});
    if (std::find(reasons.begin(), reasons.end(), end.reason) == reasons.end()) {
      problem("end", fmt::format("\"{}\" is no reason; allowed are {}", end.reason.substr(0, 60),
                                 fmt::join(reasons, ", ")));
    }
    return end;
  }

  dom::parser parser_;
};

template <typename Number>
LineReading<Number>::LineReading(const Scene& scene, bool minimal, int digits)
    : json_(std::make_unique<Json>(scene, minimal, digits)) {}
template <typename Number>
LineReading<Number>::~LineReading() = default;

template <typename Number>
Line<Number> LineReading<Number>::read(std::string_view text) {
  return json_->read(text);
}

}  // namespace tps::check

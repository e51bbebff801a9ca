// An event in any JSON that means it. Included by read_line_impl.hpp only (simdjson is a heavy header).
#pragma once

#include <algorithm>
#include <set>

#include "verify/trace_check/event_demands.hpp"
#include "verify/trace_check/line_values.hpp"

namespace tps::check {

template <typename Number>
class EventReading : protected LineValues<Number> {
 public:
  using Values = LineValues<Number>;

  using Values::LineValues;

  /// Throws LineProblem.
  EventLine<Number> event(const dom::object& line) {
    EventLine<Number> event;
    bool has_kind = false, has_t = false, has_s = false;
    std::uint32_t seen = 0;
    for (const auto [key, value] : line) {
      const Pointer at{&kLine, key};
      const auto known = std::find(event_keys().begin(), event_keys().end(), key);
      if (known == event_keys().end()) {
        add_own(event, key, value, at);
        continue;
      }
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

 protected:
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

 private:
  static Kind kind_of(std::string_view text) {
    std::vector<std::string_view> names;
    for (const KindRow& known : kinds()) {
      if (known.name == text) return known.kind;
      names.push_back(known.name);
    }
    problem("kind", fmt::format("\"{}\" is not a kind of event; allowed are {}", text.substr(0, 60),
                                fmt::join(names, ", ")));
  }

  /// A key that events of some effect have to themselves; whether those of this kind do, is asked when the
  /// kind is known.
  void add_own(EventLine<Number>& event, std::string_view key, dom::element value, const Pointer& at) const {
    std::vector<std::string> allowed = event_keys();
    for (const KindRow& kind : kinds())
      allowed.insert(allowed.end(), kind.own_keys.begin(), kind.own_keys.end());
    if (std::find(allowed.begin(), allowed.end(), key) == allowed.end()) unknown_key(at, key, allowed);
    if (event.value_of(key) != nullptr) problem(at, "stands twice in the line");
    std::int64_t whole = 0;
    std::string_view word;
    dom::array list;
    event.own.push_back({std::string(key), {}});
    OwnValue<Number>& own = event.own.back();
    if (value.get(whole) == simdjson::SUCCESS) {
      own.value = whole;
    } else if (value.get(word) == simdjson::SUCCESS) {
      own.value = std::string(word);
    } else if (value.get(list) == simdjson::SUCCESS) {
      std::vector<Number>& numbers = own.value.template emplace<std::vector<Number>>();
      for (const dom::element each : list) numbers.push_back(number(each, at));
    } else {
      problem(at, "is no whole number, no word and no list of numbers");
    }
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
      if (!event.index_involved()) refuse_one_that_stands_twice(after);
    }
    if (has_pre) read_before(before, event);
  }

  void refuse_one_that_stands_twice(const dom::object& particles) const {
    std::set<int> seen;
    for (const auto [key, value] : particles) {
      const Pointer at{&kPost, key};
      if (!seen.insert(particle_named(key, at)).second) problem(at, "stands twice in the line");
    }
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
};

}  // namespace tps::check

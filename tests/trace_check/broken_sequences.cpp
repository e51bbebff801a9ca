// Events that are missing, or that happen again.
#include <algorithm>

#include "tests/trace_check/edits.hpp"

namespace tps::mutation {
namespace {

bool involves(const Json& event, const Place& place) {
  const auto there = [&](int id) { return !place.before.fixed(id) && event.at("pre").contains(key(id)); };
  return event.contains("pre") && (there(place.i()) || there(place.j()));
}

/// Whether the next thing that happens to one of the two is an event of both at the same limit: then it is
/// that one which is not at its root.
bool same_again(const Place& place) {
  for (std::size_t n = place.line + 1; n < place.trace.lines.size(); ++n) {
    const Json& next = place.trace.lines[n];
    if (!is_event(next) || !involves(next, place)) continue;
    return is_collision(next) && next.at("i") == place.i() && next.at("j") == place.j() &&
           is_pull(next) == is_pull(place.event);
  }
  return false;
}

/// Whether going without this event leads far beyond the limit before the next one.
bool is_missed(const Place& place) {
  return is_collision(place.event) && place.next != nullptr && !same_again(place) &&
         place.visible(place.until_next() * place.normal_speed());
}

Broken event_dropped(Trace& trace, std::uint64_t number) {
  return at_event(trace, number, is_missed, [&](std::size_t n, const Retold&) {
    erase_line(trace, n);
    settle(trace);
  });
}

bool changes_velocity(const Place& place) {
  return place.event.contains("j") && place.event.at("pre") != place.event.at("post");
}

Broken event_repeated(Trace& trace, std::uint64_t number) {
  const Broken k = at_event(trace, number, changes_velocity, [&](std::size_t n, const Retold&) {
    insert_line(trace, n + 1, Json(trace.lines[n]));
    settle(trace);
  });
  return k ? Broken(*k + 1) : k;
}

/// The pair meets again although it parts: an event with Δp = 0, which would be right if v_n had the wrong
/// sign.
Broken meeting_repeated(Trace& trace, std::uint64_t number) {
  const auto parts = [](const Place& p) {
    if (p.event.at("kind") != "rebound" || is_load(p.event)) return false;
    const Vec v = p.post(p.j(), "velocity") - p.post(p.i(), "velocity");
    return p.visible(dot(v, p.axis()));
  };
  const Broken k = at_event(trace, number, parts, [&](std::size_t n, const Retold&) {
    Json again = trace.lines[n];
    again["pre"] = again["post"];
    for (Json& x : again["dp"]) x = "0x0p+0";
    again.erase("tether");
    again.erase("draw");
    insert_line(trace, n + 1, std::move(again));
    settle(trace);
  });
  return k ? Broken(*k + 1) : k;
}

/// The last event before one of the bodies of i and j has to do with anything else; the first one if none.
std::size_t last_undisturbed(const Place& place) {
  std::vector<int> concerned = place.before.body(place.i());
  const std::vector<int> others = place.before.body(place.j());
  concerned.insert(concerned.end(), others.begin(), others.end());
  std::erase_if(concerned, [&](int id) { return place.before.fixed(id); });
  const auto disturbs = [&](const Json& event) {
    return event.contains("pre") && std::any_of(concerned.begin(), concerned.end(),
                                                [&](int id) { return event.at("pre").contains(key(id)); });
  };
  std::size_t last = place.line;
  for (std::size_t n = place.line + 1; n < place.trace.lines.size(); ++n) {
    const Json& line = place.trace.lines[n];
    if (!is_event(line)) continue;
    if (disturbs(line)) break;
    last = n;
  }
  return last;
}

/// The pair does not notice its limit and flies on; the trace ends before anything else happens to it.
template <typename Kind>
Broken flown_through(Trace& trace, std::uint64_t number, Kind of_kind) {
  const auto far_beyond = [&](const Place& p) {
    if (!is_collision(p.event) || !of_kind(p)) return false;
    if (p.trace.scene.grouping) return false;  // bodies' states are no matter of single flights
    const double time = elapsed(p.event.at("t"), p.trace.lines[last_undisturbed(p)].at("t"));
    return p.visible(time * p.normal_speed());
  };
  const auto found = find_event(trace, number, far_beyond);
  if (!found) return {};
  const std::uint64_t k = number_of(trace, found->line);
  const std::size_t last = last_undisturbed(place_of(trace, *found));
  erase_line(trace, found->line);
  cut_behind(trace, last - 1);
  return k;
}

Broken passed_through(Trace& trace, std::uint64_t number) {
  return flown_through(trace, number, [](const Place& p) { return p.event.at("kind") == "rebound"; });
}

Broken flown_off(Trace& trace, std::uint64_t number) {
  return flown_through(trace, number, [](const Place& p) { return is_pull(p.event); });
}

/// A collision, and another at the same time of two others: both were waiting, so that exact order or, in a
/// tie, ids decide.
bool collides_with_a_tie(const Place& place) {
  if (!place.next_follows_at_once() || place.until_next() > 0) return false;
  if (!is_collision(place.event) || !is_collision(*place.next)) return false;
  for (const char* one : {"i", "j"}) {
    const std::vector<int> body = place.before.body(place.event.at(one));
    for (const char* other : {"i", "j"}) {
      if (std::ranges::count(body, place.next->at(other).get<int>()) > 0) return false;
      if (place.next->at(other) == place.event.at(one)) return false;
    }
  }
  return true;
}

Broken ties_exchanged(Trace& trace, std::uint64_t number) {
  return at_event(trace, number, collides_with_a_tie, [&](std::size_t n, const Retold&) {
    trace.lines.swap(n, n + 1);
    settle(trace);
  });
}

}  // namespace

const std::vector<Mutation>& broken_sequences() {
  using enum check::Rule;
  static const std::vector<Mutation> list = {
      {"event_dropped", "a collision is missing; the rest is counted and timed again", earliest,
       event_dropped},
      {"ties_exchanged", "two events at one time that share nobody come in the other order", order,
       ties_exchanged},
      {"event_repeated", "an event happens twice", bystanders, event_repeated},
      {"meeting_repeated", "a pair that parts meets again, without an impulse", contact, meeting_repeated},
      {"passed_through", "a pair passes through each other, and nothing else is wrong", bounds,
       passed_through},
      {"flown_off", "a tether breaks without a record: the pair flies beyond its outer limit", bounds,
       flown_off},
  };
  return list;
}

}  // namespace tps::mutation

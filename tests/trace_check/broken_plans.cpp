// Events that the scene plans: impulses from outside, phases.
#include <algorithm>

#include "tests/trace_check/edits.hpp"

namespace tps::mutation {
namespace {

bool is_push(const Place& place) {
  return place.event.at("kind") == "scheduled_impulse";
}

bool is_phase(const Place& place) {
  return place.event.contains("phase");
}

bool is_planned(const Place& place) {
  return is_push(place) || is_phase(place);
}

template <typename Condition>
Broken skipped(Trace& trace, std::uint64_t number, Condition condition) {
  const auto followed = [&](const Place& p) {
    return condition(p) && p.next != nullptr && p.until_next() > 0;
  };
  return at_event(trace, number, followed, [&](std::size_t n, const Retold&) {
    erase_line(trace, n);
    settle(trace);
  });
}

Broken push_forgotten(Trace& trace, std::uint64_t number) {
  return skipped(trace, number, is_push);
}

Broken phase_forgotten(Trace& trace, std::uint64_t number) {
  return skipped(trace, number, is_phase);
}

/// At half of the way to the event behind or before.
Broken planned_at(Trace& trace, std::uint64_t number, bool late) {
  const auto has_gap = [late](const Place& p) {
    if (!is_planned(p)) return false;
    return late ? p.next != nullptr && p.until_next() > 0 : p.since_previous() > 0;
  };
  const auto found = find_event(trace, number, has_gap);
  if (!found) return {};
  const Place place = place_of(trace, *found);
  const double way = late ? place.until_next() / 2 : -place.since_previous() / 2;
  const double since = since_start(trace, place.event.at("t")) + way;
  if (place.event.contains("pre")) {
    carry_event(trace, found->line, found->before, since);
  } else {
    move_event(trace, found->line, since);
  }
  return number_of(trace, found->line);
}

Broken planned_late(Trace& trace, std::uint64_t number) {
  return planned_at(trace, number, true);
}

Broken planned_early(Trace& trace, std::uint64_t number) {
  return planned_at(trace, number, false);
}

/// All members of the body that is pushed take J/m.
void push_with(Trace& trace, std::size_t line, const Retold& before, const Vec& J) {
  Json& event = trace.lines.change(line);
  const double mass = before.body_mass(event.at("i"));
  for (const auto& [id, state] : event["post"].items()) {
    state["velocity"] = spelt(trace, Vec(numbers(event["pre"][id]["velocity"]) + J / mass));
  }
  event["dp"] = spelt(trace, J);
}

Broken push_too_strong(Trace& trace, std::uint64_t number) {
  return at_event(trace, number, is_push, [&](std::size_t n, const Retold& before) {
    push_with(trace, n, before,
              numbers(trace.lines[n].at("dp")) * (1 + std::max(1e-9, 4096 * epsilon(trace))));
  });
}

/// J is recorded right, and does something else.
Broken push_without_mass(Trace& trace, std::uint64_t number) {
  const auto heavy = [](const Place& p) {
    const double mass = is_push(p) ? p.before.body_mass(p.i()) : 1;
    return mass != 1 && mass < 1e300;
  };
  return at_event(trace, number, heavy, [&](std::size_t n, const Retold& before) {
    Json& event = trace.lines.change(n);
    const Json J = event.at("dp");
    push_with(trace, n, before, numbers(J) * before.body_mass(event.at("i")));
    event["dp"] = J;
  });
}

Broken other_phase(Trace& trace, std::uint64_t number) {
  return at_event(trace, number, is_phase, [&](std::size_t n, const Retold&) {
    Json& kind = trace.lines.change(n)["kind"];
    kind = kind == "phase_begin" ? "phase_end" : "phase_begin";
    settle(trace);
  });
}

Broken phase_that_is_none(Trace& trace, std::uint64_t number) {
  return at_event(trace, number, is_phase, [&](std::size_t n, const Retold&) {
    trace.lines.change(n)["phase"] = trace.scene.phases.size();
  });
}

/// An impulse from outside that the scene does not plan: the one before once more.
Broken push_repeated(Trace& trace, std::uint64_t number) {
  const Broken k = at_event(trace, number, is_push, [&](std::size_t n, const Retold& before) {
    Json again = trace.lines[n];
    again["pre"] = again["post"];
    insert_line(trace, n + 1, std::move(again));
    push_with(trace, n + 1, before, numbers(trace.lines[n].at("dp")));
    settle(trace);
  });
  return k ? Broken(*k + 1) : k;
}

}  // namespace

const std::vector<Mutation>& broken_plans() {
  using enum check::Rule;
  static const std::vector<Mutation> list = {
      {"push_forgotten", "a scheduled impulse is missing", earliest, push_forgotten},
      {"phase_forgotten", "a phase does not begin or end", earliest, phase_forgotten},
      {"planned_late", "a scheduled impulse or a phase comes late", earliest, planned_late},
      {"planned_early", "a scheduled impulse or a phase comes early", earliest, planned_early},
      {"push_too_strong", "J is 1e-9 of itself too large", impulse, push_too_strong},
      {"push_without_mass", "J is added to the velocity", impulse, push_without_mass},
      {"push_repeated", "a scheduled impulse comes twice", earliest, push_repeated},
      {"other_phase", "a phase ends where it begins", earliest, other_phase},
      {"phase_that_is_none", "a phase that the scene does not have", earliest, phase_that_is_none},
  };
  return list;
}

}  // namespace tps::mutation

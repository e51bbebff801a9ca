// Times that are not those of the events, and the order of lines.
#include <algorithm>

#include "tests/trace_check/edits.hpp"

namespace tps::mutation {
namespace {

/// By how much a moved time is moved: 1e-9 of it, and no less than a thousand roundings of a float.
double shift(const Place& place) {
  return since_start(place.trace, place.event.at("t")) * std::max(1e-9, 4096 * epsilon(place.trace));
}

bool has_room(const Place& place) {
  return shift(place) > 0 && place.since_previous() > 4 * shift(place) &&
         place.until_next() > 4 * shift(place);
}

double moved(const Place& place, std::uint64_t number) {
  const double sign = number % 2 == 0 ? 1 : -1;
  return since_start(place.trace, place.event.at("t")) + sign * shift(place);
}

Broken time_moved(Trace& trace, std::uint64_t number) {
  const auto found = find_event(trace, number, [](const Place& p) {
    return is_collision(p.event) && has_room(p) &&
           p.visible(shift(p) * std::max(length(p.pre(p.i(), "velocity")), length(p.pre(p.j(), "velocity"))));
  });
  if (!found) return {};
  move_event(trace, found->line, moved(place_of(trace, *found), number));
  return number_of(trace, found->line);
}

Broken time_moved_with_positions(Trace& trace, std::uint64_t number) {
  const auto found = find_event(trace, number, [](const Place& p) {
    return is_collision(p.event) && has_room(p) && p.visible(shift(p) * p.normal_speed());
  });
  if (!found) return {};
  carry_event(trace, found->line, found->before, moved(place_of(trace, *found), number));
  return number_of(trace, found->line);
}

bool apart(const Json& a, const Json& b) {
  const auto involves = [](const Json& event, int id) { return event.at("pre").contains(key(id)); };
  return std::none_of(a.at("pre").items().begin(), a.at("pre").items().end(),
                      [&](const auto& item) { return involves(b, std::stoi(item.key())); });
}

Broken times_exchanged(Trace& trace, std::uint64_t number) {
  const auto found = find_event(trace, number, [](const Place& p) {
    return is_collision(p.event) && p.next != nullptr && is_collision(*p.next) && apart(p.event, *p.next) &&
           p.visible(p.until_next() * p.normal_speed());
  });
  if (!found) return {};
  const Place place = place_of(trace, *found);
  const std::size_t next = place.next_line;
  const double first = since_start(trace, place.event.at("t"));
  const double second = since_start(trace, place.next->at("t"));
  carry_event(trace, found->line, found->before, second);
  carry_event(trace, next, found->before, first);
  trace.lines.swap(found->line, next);
  settle(trace);
  return number_of(trace, found->line);
}

/// Far more than an ulp of the times: nearer ones have a dt that is rounded twice. Two ulps are wrong also
/// where the exact difference is half-way between two numbers.
bool is_apart(const Place& place) {
  const double ulp_of_time = epsilon(place.trace) * since_start(place.trace, place.event.at("t"));
  return mutation::number(place.event.at("dt")) > 1024 * ulp_of_time;
}

Broken dt_off_by_two_ulps(Trace& trace, std::uint64_t number) {
  return at_event(trace, number, is_apart, [&](std::size_t n, const Retold&) {
    trace.lines.change(n)["dt"] = stepped(trace, trace.lines[n].at("dt"), 2);
  });
}

Broken time_without_dt(Trace& trace, std::uint64_t number) {
  return at_event(trace, number, has_room, [&](std::size_t n, const Retold&) {
    Json& t = trace.lines.change(n)["t"];
    t = clock_time(trace, since_start(trace, t) * (1 + std::max(1e-9, 4096 * epsilon(trace))));
  });
}

bool next_is_later(const Place& place) {
  return place.next != nullptr && place.until_next() > 0;
}

Broken lines_swapped(Trace& trace, std::uint64_t number) {
  return at_event(trace, number, next_is_later, [&](std::size_t n, const Retold&) {
    std::size_t next = n + 1;
    while (!is_event(trace.lines[next])) ++next;
    trace.lines.swap(n, next);
  });
}

Broken time_goes_back(Trace& trace, std::uint64_t number) {
  const Broken k = lines_swapped(trace, number);
  if (k) settle(trace);
  return k;
}

/// Gives the events behind `line`, itself included, other numbers.
void count_on(Trace& trace, std::size_t line, int more) {
  for (std::size_t n = line; n < trace.lines.size(); ++n) {
    for (const char* count : {"k", "state", "events"}) {
      if (trace.lines[n].contains(count))
        trace.lines.change(n)[count] = trace.lines[n].at(count).get<int>() + more;
    }
  }
}

Broken number_skipped(Trace& trace, std::uint64_t number) {
  return at_event(
      trace, number, [](const Place&) { return true; },
      [&](std::size_t n, const Retold&) { count_on(trace, n, 1); });
}

Broken number_given_twice(Trace& trace, std::uint64_t number) {
  const Broken k = at_event(
      trace, number, [](const Place& p) { return p.previous != nullptr; },
      [&](std::size_t n, const Retold&) { count_on(trace, n, -1); });
  return k ? Broken(*k - 1) : k;
}

Broken line_lost(Trace& trace, std::uint64_t number) {
  return at_event(
      trace, number, [](const Place& p) { return p.next != nullptr; },
      [&](std::size_t n, const Retold&) { erase_line(trace, n); });
}

Broken line_twice(Trace& trace, std::uint64_t number) {
  return at_event(
      trace, number, [](const Place&) { return true; },
      [&](std::size_t n, const Retold&) { insert_line(trace, n + 1, Json(trace.lines[n])); });
}

}  // namespace

const std::vector<Mutation>& broken_times() {
  using enum check::Rule;
  static const std::vector<Mutation> list = {
      {"time_moved", "a time is moved by 1e-9 of itself, with its dt and the next one; positions stay",
       flight, time_moved},
      {"time_moved_with_positions", "the same, and the particles are where they fly by then", contact,
       time_moved_with_positions},
      {"times_exchanged", "two events of different particles happen each at the other's time", contact,
       times_exchanged},
      {"dt_off_by_two_ulps", "dt is two ulps too long", order, dt_off_by_two_ulps},
      {"time_without_dt", "a time is moved, dt is not", order, time_without_dt},
      {"lines_swapped", "two lines have changed places", order, lines_swapped},
      {"time_goes_back", "two events have changed places and are counted again", order, time_goes_back},
      {"number_skipped", "k leaves out a number", order, number_skipped},
      {"number_given_twice", "k gives a number twice", order, number_given_twice},
      {"line_lost", "a line is missing, the others are as they were", order, line_lost},
      {"line_twice", "a line is there twice, the others are as they were", order, line_twice},
  };
  return list;
}

}  // namespace tps::mutation

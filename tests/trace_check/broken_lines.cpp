// Lines that are no lines of a trace.
#include "tests/trace_check/edits.hpp"

namespace tps::mutation {
namespace {

bool has_pair(const Place& place) {
  return place.event.contains("j");
}

Broken unknown_key(Trace& trace, std::uint64_t number) {
  return at_event(
      trace, number, [](const Place&) { return true; },
      [&](std::size_t n, const Retold&) { trace.lines.change(n)["weight"] = "0x1p+0"; });
}

Broken decimal_number(Trace& trace, std::uint64_t number) {
  return at_event(
      trace, number, [](const Place&) { return true; },
      [&](std::size_t n, const Retold&) { trace.lines.change(n)["dt"] = 0.5; });
}

Broken not_a_number(Trace& trace, std::uint64_t number) {
  return at_event(trace, number, has_pair, [&](std::size_t n, const Retold&) {
    Json& event = trace.lines.change(n);
    event["pre"][key(event.at("i"))]["velocity"][0] = "nan";
  });
}

Broken digits_beyond_the_scalar(Trace& trace, std::uint64_t number) {
  return at_event(trace, number, has_pair, [&](std::size_t n, const Retold&) {
    Json& event = trace.lines.change(n);
    event["post"][key(event.at("i"))]["velocity"][0] = "0x1.00000000000000000000000000000000000001p+0";
  });
}

Broken no_such_particle(Trace& trace, std::uint64_t number) {
  return at_event(trace, number, has_pair, [&](std::size_t n, const Retold&) {
    Json& event = trace.lines.change(n);
    constexpr int kNobody = 2'000'000'000;
    for (const char* when : {"pre", "post"}) {
      Json states = Json::object();
      for (const auto& [id, state] : event[when].items()) {
        states[id == key(event.at("j")) ? key(kNobody) : id] = state;
      }
      event[when] = states;
    }
    event["j"] = kNobody;
  });
}

Broken pair_turned_round(Trace& trace, std::uint64_t number) {
  return at_event(trace, number, has_pair, [&](std::size_t n, const Retold&) {
    Json& event = trace.lines.change(n);
    std::swap(event["i"], event["j"]);
  });
}

Broken collision_without_impulse(Trace& trace, std::uint64_t number) {
  return at_event(
      trace, number, [](const Place& p) { return is_collision(p.event); },
      [&](std::size_t n, const Retold&) { trace.lines.change(n).erase("dp"); });
}

Broken unknown_kind(Trace& trace, std::uint64_t number) {
  return at_event(trace, number, has_pair,
                  [&](std::size_t n, const Retold&) { trace.lines.change(n)["kind"] = "bounce"; });
}

Broken wrong_dimension(Trace& trace, std::uint64_t number) {
  return at_event(trace, number, has_pair, [&](std::size_t n, const Retold&) {
    Json& position = trace.lines.change(n)["pre"][key(trace.lines[n].at("i"))]["position"];
    if (position.size() == 3) {
      position.erase(2);
    } else {
      position.push_back("0x0p+0");
    }
  });
}

Broken break_without_saying_so(Trace& trace, std::uint64_t number) {
  return at_event(
      trace, number, [](const Place& p) { return p.event.at("kind") == "break"; },
      [&](std::size_t n, const Retold&) { trace.lines.change(n).erase("tether"); });
}

Broken partner_missing(Trace& trace, std::uint64_t number) {
  return at_event(trace, number, has_pair, [&](std::size_t n, const Retold&) {
    Json& event = trace.lines.change(n);
    event["post"].erase(key(event.at("j")));
  });
}

Broken draw_out_of_range(Trace& trace, std::uint64_t number) {
  return at_event(
      trace, number, [](const Place& p) { return p.event.contains("draw"); },
      [&](std::size_t n, const Retold&) { trace.lines.change(n)["draw"] = "0x1p+0"; });
}

Broken second_header(Trace& trace, std::uint64_t number) {
  return at_event(
      trace, number, [](const Place&) { return true; },
      [&](std::size_t n, const Retold&) { insert_line(trace, n, trace.lines.front()); });
}

Broken torn_in_the_middle(Trace& trace, std::uint64_t number) {
  return at_event(
      trace, number, [](const Place&) { return true; },
      [&](std::size_t n, const Retold&) { trace.lines.change(n) = Json::array({trace.lines[n].at("k")}); });
}

}  // namespace

const std::vector<Mutation>& broken_lines() {
  using enum check::Rule;
  static const std::vector<Mutation> list = {
      {"unknown_key", "an event has a key that no event has", schema, unknown_key},
      {"decimal_number", "dt is a decimal, not a hexadecimal float", schema, decimal_number},
      {"not_a_number", "a velocity is NaN", schema, not_a_number},
      {"digits_beyond_the_scalar", "a velocity has more digits than the run's scalar", schema,
       digits_beyond_the_scalar},
      {"no_such_particle", "j is nobody's id", schema, no_such_particle},
      {"pair_turned_round", "i > j", schema, pair_turned_round},
      {"collision_without_impulse", "a collision has no dp", schema, collision_without_impulse},
      {"unknown_kind", "an event is of a kind that does not exist", schema, unknown_kind},
      {"wrong_dimension", "a position has a coordinate too many or too few", schema, wrong_dimension},
      {"break_without_saying_so", "a break does not say that the tether is broken", schema,
       break_without_saying_so},
      {"partner_missing", "post does not hold j", schema, partner_missing},
      {"draw_out_of_range", "a draw of 1; draws are below", schema, draw_out_of_range},
      {"second_header", "the header comes again among the events", schema, second_header},
      {"torn_in_the_middle", "a line is JSON, but no event", schema, torn_in_the_middle},
  };
  return list;
}

}  // namespace tps::mutation

// Tethers that form or break against the rules of their pair (semantics §3).
#include "tests/trace_check/edits.hpp"

namespace tps::mutation {
namespace {

bool forms(const Place& place) {
  return place.event.value("tether", "") == "formed";
}

bool meets(const Place& place) {
  return place.event.at("kind") == "rebound";
}

/// A rebound of a pair whose tethers form and break, if it is one.
bool meets_with_law(const Place& place) {
  if (!meets(place)) return false;
  const PairLaw& law = *place.before.law(place.i(), place.j());
  return law.tethering && law.tethering->form.when != FormRule::When::permanent;
}

bool is_full(const Retold& before, int id) {
  const auto& capacity = before.species(id).max_tethers;
  return capacity && before.tethers_of(id) >= *capacity;
}

bool has_room_for_one(const Place& place) {
  return !place.before.tethered(place.i(), place.j()) && !is_full(place.before, place.i()) &&
         !is_full(place.before, place.j());
}

FormRule::When form_of(const Place& place) {
  return place.before.form_rule(place.i(), place.j()).when;
}

BreakRule::When break_of(const Place& place) {
  return place.before.break_rule(place.i(), place.j()).when;
}

/// Pulls by a tether that can break at all.
bool pulls(const Place& place) {
  return is_pull(place.event) && !place.before.is_permanent(place.i(), place.j());
}

bool breaks(const Place& place) {
  return place.event.at("kind") == "break";
}

template <typename Condition>
Broken formed_where(Trace& trace, std::uint64_t number, Condition condition) {
  return at_event(trace, number, condition,
                  [&](std::size_t n, const Retold&) { trace.lines.change(n)["tether"] = "formed"; });
}

Broken formed_without_law(Trace& trace, std::uint64_t number) {
  return formed_where(trace, number,
                      [](const Place& p) { return meets(p) && !p.before.law(p.i(), p.j())->tethering; });
}

Broken formed_twice(Trace& trace, std::uint64_t number) {
  return formed_where(trace, number,
                      [](const Place& p) { return meets_with_law(p) && p.before.tethered(p.i(), p.j()); });
}

Broken formed_beyond_capacity(Trace& trace, std::uint64_t number) {
  return formed_where(trace, number, [](const Place& p) {
    return meets_with_law(p) && !p.before.tethered(p.i(), p.j()) &&
           (is_full(p.before, p.i()) || is_full(p.before, p.j()));
  });
}

Broken formed_against_the_rule(Trace& trace, std::uint64_t number) {
  return formed_where(trace, number, [](const Place& p) {
    return meets_with_law(p) && has_room_for_one(p) && form_of(p) == FormRule::When::never;
  });
}

Broken not_formed(Trace& trace, std::uint64_t number) {
  return at_event(
      trace, number, [](const Place& p) { return forms(p) && form_of(p) == FormRule::When::always; },
      [&](std::size_t n, const Retold&) { trace.lines.change(n).erase("tether"); });
}

bool forms_by_chance(const Place& place) {
  return place.event.contains("draw") && meets(place);
}

Broken formed_against_the_draw(Trace& trace, std::uint64_t number) {
  return formed_where(trace, number, [](const Place& p) { return forms_by_chance(p) && !forms(p); });
}

Broken not_formed_against_the_draw(Trace& trace, std::uint64_t number) {
  return at_event(
      trace, number, [](const Place& p) { return forms_by_chance(p) && forms(p); },
      [&](std::size_t n, const Retold&) { trace.lines.change(n).erase("tether"); });
}

Broken draw_not_recorded(Trace& trace, std::uint64_t number) {
  return at_event(
      trace, number, [](const Place& p) { return p.event.contains("draw"); },
      [&](std::size_t n, const Retold&) { trace.lines.change(n).erase("draw"); });
}

Broken draw_for_nothing(Trace& trace, std::uint64_t number) {
  return at_event(
      trace, number, [](const Place& p) { return is_collision(p.event) && !p.event.contains("draw"); },
      [&](std::size_t n, const Retold&) { trace.lines.change(n)["draw"] = "0x1p-2"; });
}

/// Makes a break of a pull: no impulse, no change of velocities.
void make_break(Trace& trace, std::size_t line) {
  Json& event = trace.lines.change(line);
  event["kind"] = "break";
  event["tether"] = "broken";
  event["post"] = event["pre"];
  for (const char* part : {"dp", "dp_stored", "members"}) event.erase(part);
  settle(trace);
}

Broken broken_against_the_rule(Trace& trace, std::uint64_t number) {
  return at_event(
      trace, number, [](const Place& p) { return pulls(p) && break_of(p) == BreakRule::When::never; },
      [&](std::size_t n, const Retold&) { make_break(trace, n); });
}

Broken broken_for_ever(Trace& trace, std::uint64_t number) {
  return at_event(
      trace, number, [](const Place& p) { return is_pull(p.event) && p.before.is_permanent(p.i(), p.j()); },
      [&](std::size_t n, const Retold&) { make_break(trace, n); });
}

Broken broken_below_the_threshold(Trace& trace, std::uint64_t number) {
  return at_event(
      trace, number, [](const Place& p) { return pulls(p) && break_of(p) == BreakRule::When::impulse_above; },
      [&](std::size_t n, const Retold&) { make_break(trace, n); });
}

Broken broken_against_the_draw(Trace& trace, std::uint64_t number) {
  return at_event(
      trace, number, [](const Place& p) { return pulls(p) && break_of(p) == BreakRule::When::probability; },
      [&](std::size_t n, const Retold&) { make_break(trace, n); });
}

/// Holds where it should break: a retraction by eq. (4).
template <typename Condition>
Broken held_where(Trace& trace, std::uint64_t number, Condition condition) {
  const auto found = find_event(trace, number, [&](const Place& p) {
    return breaks(p) && !p.trace.scene.grouping && condition(p) && p.normal_speed() > 0;
  });
  if (!found) return {};
  const Place place = place_of(trace, *found);
  const double masses[2] = {found->before.body_mass(place.i()), found->before.body_mass(place.j())};
  const double c = found->before.law(place.i(), place.j())->tethering->c_retract;
  const Vec dp = place.axis() * ((1 + c) / (1 / masses[0] + 1 / masses[1]) * place.normal_speed());
  Json& event = trace.lines.change(found->line);
  event["kind"] = "retract";
  event.erase("tether");
  event["dp"] = spelt(trace, dp);
  part_by(trace, event, masses, dp);
  settle(trace);
  return number_of(trace, found->line);
}

Broken held_against_the_rule(Trace& trace, std::uint64_t number) {
  return held_where(trace, number, [](const Place& p) { return break_of(p) == BreakRule::When::always; });
}

Broken held_above_the_threshold(Trace& trace, std::uint64_t number) {
  return held_where(trace, number,
                    [](const Place& p) { return break_of(p) == BreakRule::When::impulse_above; });
}

Broken held_against_the_draw(Trace& trace, std::uint64_t number) {
  return held_where(trace, number,
                    [](const Place& p) { return break_of(p) == BreakRule::When::probability; });
}

}  // namespace

const std::vector<Mutation>& broken_tethers() {
  using enum check::Rule;
  static const std::vector<Mutation> list = {
      {"formed_without_law", "a tether forms at a pair without a tethering law", tethers, formed_without_law},
      {"formed_twice", "a tether forms where there is one", tethers, formed_twice},
      {"formed_beyond_capacity", "a tether forms at a particle that is full", tethers,
       formed_beyond_capacity},
      {"formed_against_the_rule", "a tether forms although the rule says never", tethers,
       formed_against_the_rule},
      {"not_formed", "no tether forms although the rule says always", tethers, not_formed},
      {"formed_against_the_draw", "a tether forms on the wrong side of the probability", tethers,
       formed_against_the_draw},
      {"not_formed_against_the_draw", "none forms on the right side of the probability", tethers,
       not_formed_against_the_draw},
      {"draw_not_recorded", "a rule with a probability, and no draw", tethers, draw_not_recorded},
      {"draw_for_nothing", "a draw that no rule asks for", tethers, draw_for_nothing},
      {"broken_against_the_rule", "a tether breaks although the rule says never", tethers,
       broken_against_the_rule},
      {"broken_for_ever", "a permanent tether breaks", tethers, broken_for_ever},
      {"broken_below_the_threshold", "a tether breaks at an impulse below the threshold", tethers,
       broken_below_the_threshold},
      {"broken_against_the_draw", "a tether breaks on the wrong side of the probability", tethers,
       broken_against_the_draw},
      {"held_against_the_rule", "a tether holds although the rule says always", tethers,
       held_against_the_rule},
      {"held_above_the_threshold", "a tether holds at an impulse above the threshold", tethers,
       held_above_the_threshold},
      {"held_against_the_draw", "a tether holds on the right side of the probability", tethers,
       held_against_the_draw},
  };
  return list;
}

}  // namespace tps::mutation

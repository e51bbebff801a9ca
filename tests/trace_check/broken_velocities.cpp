// Velocities and positions that do not follow from the event, or from the flight before it.
#include <algorithm>
#include <cmath>

#include "tests/trace_check/edits.hpp"

namespace tps::mutation {
namespace {

double little(const Trace& trace) {
  return std::max(1e-9, 4096 * epsilon(trace));
}

bool parts_single_bodies(const Place& place) {
  return is_collision(place.event) && !is_load(place.event) &&
         place.event.at("pre") != place.event.at("post");
}

Broken masses_exchanged(Trace& trace, std::uint64_t number) {
  const auto unlike = [](const Place& p) {
    if (!parts_single_bodies(p) || p.before.fixed(p.i()) || p.before.fixed(p.j())) return false;
    return p.before.body_mass(p.i()) != p.before.body_mass(p.j());
  };
  return at_event(trace, number, unlike, [&](std::size_t n, const Retold& before) {
    Json& event = trace.lines.change(n);
    part_by(trace, event, {before.body_mass(event.at("j")), before.body_mass(event.at("i"))},
            numbers(event.at("dp")));
  });
}

/// Whether the velocity of j changes by more than rounding does.
bool moves_j(const Place& place) {
  return parts_single_bodies(place) && !place.before.fixed(place.j()) && !place.before.fixed(place.i()) &&
         length(place.post(place.j(), "velocity") - place.pre(place.j(), "velocity")) >
             1e-6 * length(place.approach());
}

Broken partner_unmoved(Trace& trace, std::uint64_t number) {
  return at_event(trace, number, moves_j, [&](std::size_t n, const Retold&) {
    Json& event = trace.lines.change(n);
    const std::string j = key(event.at("j"));
    event["post"][j]["velocity"] = event["pre"][j]["velocity"];
  });
}

Broken velocity_after_off(Trace& trace, std::uint64_t number) {
  const auto fast = [](const Place& p) {
    return moves_j(p) && p.post(p.j(), "velocity")[0] * p.post(p.j(), "velocity")[0] >
                             1e-4 * dot(p.approach(), p.approach());
  };
  return at_event(trace, number, fast, [&](std::size_t n, const Retold&) {
    Json& x = trace.lines.change(n)["post"][key(trace.lines[n].at("j"))]["velocity"][0];
    x = stepped(trace, x, 1 << 14);
  });
}

Broken impulse_misreported(Trace& trace, std::uint64_t number) {
  return at_event(trace, number, moves_j, [&](std::size_t n, const Retold&) {
    Json& dp = trace.lines.change(n)["dp"];
    dp = spelt(trace, Vec(numbers(dp) * (1 + little(trace))));
  });
}

/// A single particle of a collision that flew before, and was heard of before.
std::optional<int> flier(const Place& place) {
  if (!is_collision(place.event)) return {};
  for (const int id : {place.i(), place.j()}) {
    const Vec v = place.pre(id, "velocity");
    if (!place.before.fixed(id) && !place.before.load(id) &&
        length(v) > 1e-3 * (1e-3 + length(place.approach())))
      return id;
  }
  return {};
}

bool has_flier(const Place& place) {
  return flier(place).has_value();
}

Broken bystander_drifts(Trace& trace, std::uint64_t number) {
  const auto found = find_event(trace, number, has_flier);
  if (!found) return {};
  const int id = *flier(place_of(trace, *found));
  Json& v = trace.lines.change(found->line)["pre"][key(id)]["velocity"];
  v = spelt(trace, Vec(numbers(v) * (1 + little(trace))));
  return number_of(trace, found->line);
}

Broken teleported(Trace& trace, std::uint64_t number) {
  const auto away = [](const Place& p) { return flier(p) && length(p.pre(*flier(p), "position")) > 0; };
  const auto found = find_event(trace, number, away);
  if (!found) return {};
  const Place place = place_of(trace, *found);
  const int id = *flier(place);
  const Vec from = place.pre(id, "position");
  const std::string x = spelt(trace, from[0] + length(from) * little(trace));
  for (const char* when : {"pre", "post"}) trace.lines.change(found->line)[when][key(id)]["position"][0] = x;
  return number_of(trace, found->line);
}

Broken moved_by_the_event(Trace& trace, std::uint64_t number) {
  return at_event(trace, number, has_flier, [&](std::size_t n, const Retold&) {
    Json& event = trace.lines.change(n);
    Json& x = event["post"][key(event.at("i"))]["position"][0];
    const double old = mutation::number(x);
    x = spelt(trace, old + std::max(1., std::abs(old)) * little(trace));
  });
}

/// A particle that has nothing to do with an event, and flies freely; none if there is none.
std::optional<int> uninvolved(const Place& place) {
  for (const Particle& p : place.trace.scene.particles) {
    if (place.before.fixed(p.id) || place.before.load(p.id)) continue;
    if (!place.event.at("pre").contains(key(p.id)) && length(place.before.flight(p.id).velocity) > 0)
      return p.id;
  }
  return {};
}

Broken bystander_pushed(Trace& trace, std::uint64_t number) {
  const auto crowded = [](const Place& p) { return parts_single_bodies(p) && uninvolved(p).has_value(); };
  const auto found = find_event(trace, number, crowded);
  if (!found) return {};
  const int id = *uninvolved(place_of(trace, *found));
  Json& event = trace.lines.change(found->line);
  const Vec velocity = found->before.flight(id).velocity;
  const Json position = spelt(trace, found->before.position(id, event.at("t")));
  event["pre"][key(id)] = {{"position", position}, {"velocity", spelt(trace, velocity)}};
  event["post"][key(id)] = {{"position", position}, {"velocity", spelt(trace, Vec(velocity * 1.5))}};
  return number_of(trace, found->line);
}

Broken old_velocity_kept(Trace& trace, std::uint64_t number) {
  const auto found =
      find_event(trace, number, [](const Place& p) { return p.next != nullptr && moves_j(p); });
  if (!found) return {};
  const int j = trace.lines[found->line].at("j");
  const Json old = trace.lines[found->line]["pre"][key(j)]["velocity"];
  for (std::size_t n = found->line + 1; n < trace.lines.size(); ++n) {
    Json& later = trace.lines.change(n);
    if (!is_event(later) || !later.contains("pre") || !later["pre"].contains(key(j))) continue;
    later["pre"][key(j)]["velocity"] = old;
    return number_of(trace, n);
  }
  return {};
}

}  // namespace

const std::vector<Mutation>& broken_velocities() {
  using enum check::Rule;
  static const std::vector<Mutation> list = {
      {"masses_exchanged", "eq. (3) with the masses of i and j exchanged", impulse, masses_exchanged},
      {"velocity_after_off", "a velocity after a collision is 2^14 ulps off", impulse, velocity_after_off},
      {"impulse_misreported", "dp is off by 1e-9 of itself, velocities are right", impulse,
       impulse_misreported},
      {"partner_unmoved", "eq. (3) for i only: j keeps its velocity", conservation, partner_unmoved},
      {"bystander_drifts", "a velocity changes by 1e-9 of itself between two events", bystanders,
       bystander_drifts},
      {"moved_by_the_event", "a position after an event is not the one before it", bystanders,
       moved_by_the_event},
      {"bystander_pushed", "a collision changes a third particle's velocity", bystanders, bystander_pushed},
      {"old_velocity_kept", "a particle comes to an event with the velocity before its last one", bystanders,
       old_velocity_kept},
      {"teleported", "a particle is displaced by 1e-9 of its position", flight, teleported},
  };
  return list;
}

}  // namespace tps::mutation

// Loads that do not make the body that they should, eqs. (6) and (7).
#include <algorithm>
#include <cmath>

#include "tests/trace_check/edits.hpp"

namespace tps::mutation {
namespace {

bool makes_a_body(const Place& place) {
  return is_load(place.event);
}

/// Loads with a common velocity of its own (a grounded body has the wall's).
bool makes_a_moving_body(const Place& place) {
  return makes_a_body(place) && !place.before.fixed(place.i()) && !place.before.fixed(place.j()) &&
         place.before.body_mass(place.i()) + place.before.body_mass(place.j()) < HUGE_VAL;
}

/// A coordinate of the common velocity that is not zero.
std::optional<std::size_t> moving_coordinate(const Place& place) {
  const Vec v = place.post(place.j(), "velocity");
  for (std::size_t k = 0; k < v.size(); ++k) {
    if (std::abs(v[k]) > 1e-6 * length(place.approach())) return k;
  }
  return {};
}

Broken member_an_ulp_faster(Trace& trace, std::uint64_t number) {
  const auto moves = [](const Place& p) {
    return makes_a_moving_body(p) && moving_coordinate(p).has_value();
  };
  const auto found = find_event(trace, number, moves);
  if (!found) return {};
  const Place place = place_of(trace, *found);
  const std::size_t k = *moving_coordinate(place);
  const std::string last = std::to_string(place.event.at("members").back().get<int>());
  Json& x = trace.lines.change(found->line)["post"][last]["velocity"][k];
  x = stepped(trace, x, 1);
  return number_of(trace, found->line);
}

Broken member_missing(Trace& trace, std::uint64_t number) {
  const auto several = [](const Place& p) { return makes_a_body(p) && p.event.at("members").size() > 1; };
  return at_event(trace, number, several, [&](std::size_t n, const Retold&) {
    Json& members = trace.lines.change(n)["members"];
    members.erase(members.size() - 1);
  });
}

Broken wall_is_member(Trace& trace, std::uint64_t number) {
  const auto on_wall = [](const Place& p) {
    return makes_a_body(p) && (p.before.fixed(p.i()) || p.before.fixed(p.j()));
  };
  return at_event(trace, number, on_wall, [&](std::size_t n, const Retold& before) {
    Json& event = trace.lines.change(n);
    const int wall = before.fixed(event.at("i")) ? event.at("i") : event.at("j");
    auto members = event.at("members").get<std::vector<int>>();
    members.insert(std::ranges::lower_bound(members, wall), wall);
    event["members"] = members;
  });
}

bool keeps_impulse(const Place& place) {
  return makes_a_body(place) &&
         length(numbers(place.event.at("dp_stored"))) > 1e-6 * length(numbers(place.event.at("dp")));
}

Vec a_little_more(const Trace& trace, const Json& v) {
  return numbers(v) * (1 + std::max(1e-6, 4096 * epsilon(trace)));
}

/// Wrong where it is stored, and so at the restitution.
Broken stored_impulse_off(Trace& trace, std::uint64_t number) {
  return at_event(trace, number, keeps_impulse, [&](std::size_t n, const Retold& before) {
    Json& event = trace.lines.change(n);
    const Vec stored = a_little_more(trace, event.at("dp_stored"));
    event["dp_stored"] = spelt(trace, stored);
    const auto parted = restitution_of(trace, n);
    if (!parted) return;
    Json& restitution = trace.lines.change(*parted);
    restitution["dp"] = event["dp_stored"];
    part_by(trace, restitution, {before.body_mass(event.at("i")), before.body_mass(event.at("j"))}, stored);
  });
}

/// Stored right, and given back wrong.
Broken other_impulse_given_back(Trace& trace, std::uint64_t number) {
  const auto gives_back = [](const Place& p) {
    return p.event.at("kind") == "restitute" && length(numbers(p.event.at("dp"))) > 0 &&
           p.before.load(p.before.fixed(p.i()) ? p.j() : p.i()) != nullptr;
  };
  return at_event(trace, number, gives_back, [&](std::size_t n, const Retold& before) {
    Json& event = trace.lines.change(n);
    const auto load = before.load(before.fixed(event.at("i")) ? event.at("j") : event.at("i"));
    const Vec dp = a_little_more(trace, event.at("dp"));
    event["dp"] = spelt(trace, dp);
    part_by(trace, event, {load->mass[0], load->mass[1]}, dp);
  });
}

/// Eq. (6) with the weights of the two bodies exchanged, for every member.
Broken load_weights_exchanged(Trace& trace, std::uint64_t number) {
  const auto unlike = [](const Place& p) {
    return makes_a_moving_body(p) && p.before.body_mass(p.i()) != p.before.body_mass(p.j());
  };
  const auto found = find_event(trace, number, unlike);
  if (!found) return {};
  const Place place = place_of(trace, *found);
  const double m_i = place.before.body_mass(place.i());
  const double m_j = place.before.body_mass(place.j());
  const Vec v =
      (place.pre(place.i(), "velocity") * m_j + place.pre(place.j(), "velocity") * m_i) / (m_i + m_j);
  for (const Json& member : place.event.at("members")) {
    trace.lines.change(found->line)["post"][key(member)]["velocity"] = spelt(trace, v);
  }
  return number_of(trace, found->line);
}

/// The collision is answered at once by eq. (3), although the scene groups.
Broken not_loaded(Trace& trace, std::uint64_t number) {
  const auto pair_only = [](const Place& p) {
    return makes_a_body(p) && !p.before.load(p.i()) && !p.before.load(p.j());
  };
  return at_event(trace, number, pair_only, [&](std::size_t n, const Retold& before) {
    Json& event = trace.lines.change(n);
    event.erase("members");
    event.erase("dp_stored");
    part_by(trace, event, {before.mass(event.at("i")), before.mass(event.at("j"))}, numbers(event.at("dp")));
  });
}

/// A collision that groups nothing in a scene without grouping: the pair takes v_load.
Broken loaded_without_grouping(Trace& trace, std::uint64_t number) {
  const auto single = [](const Place& p) {
    return !p.trace.scene.grouping && is_collision(p.event) && !p.before.fixed(p.i()) &&
           !p.before.fixed(p.j());
  };
  return at_event(trace, number, single, [&](std::size_t n, const Retold&) {
    Json& event = trace.lines.change(n);
    event["dp_stored"] = event["dp"];
    event["members"] = {event.at("i"), event.at("j")};
  });
}

}  // namespace

const std::vector<Mutation>& broken_loads() {
  using enum check::Rule;
  static const std::vector<Mutation> list = {
      {"member_an_ulp_faster", "a member of a body is an ulp faster than the others", groups,
       member_an_ulp_faster},
      {"member_missing", "a load does not list one of its members", groups, member_missing},
      {"wall_is_member", "a grounded body lists the infinite mass", groups, wall_is_member},
      {"other_impulse_given_back", "a restitution gives back another impulse than was stored", groups,
       other_impulse_given_back},
      {"not_loaded", "a collision is answered by eq. (3) although the scene groups", groups, not_loaded},
      {"loaded_without_grouping", "a load in a scene without grouping", groups, loaded_without_grouping},
      {"stored_impulse_off", "dp_stored is 1e-6 of itself too large, and so is the restitution", impulse,
       stored_impulse_off},
      {"load_weights_exchanged", "eq. (6) with the masses exchanged", impulse, load_weights_exchanged},
  };
  return list;
}

}  // namespace tps::mutation

// Full states that are not what the events made.
#include <algorithm>

#include "tests/trace_check/edits.hpp"

namespace tps::mutation {
namespace {

/// Breaks one of the full states that meet a condition; the first wrong number is the state's.
template <typename Condition, typename Edit>
Broken at_state(Trace& trace, std::uint64_t number, Condition condition, Edit edit) {
  std::vector<std::size_t> states;
  for (std::size_t n = 0; n < trace.lines.size(); ++n) {
    if (is_state(trace.lines[n]) && condition(trace.lines[n])) states.push_back(n);
  }
  if (states.empty()) return {};
  Json& state = trace.lines.change(states[chosen(states.size(), number)]);
  edit(state);
  return state.at("state").get<std::uint64_t>();
}

bool is_later(const Json& state) {
  return state.at("state") > 0;
}

bool has_entries(const Json& state, const char* what) {
  return !state.at(what).empty();
}

/// The first particle that moves.
Json* mover(Json& state) {
  for (Json& p : state["particles"]) {
    if (length(numbers(p.at("velocity"))) > 0) return &p;
  }
  return nullptr;
}

Broken state_velocity_off(Trace& trace, std::uint64_t number) {
  const auto moves = [](const Json& s) { return mover(const_cast<Json&>(s)) != nullptr; };
  return at_state(trace, number, moves, [&](Json& state) {
    for (Json& x : (*mover(state))["velocity"]) x = mutation::number(x) == 0 ? x : Json(stepped(trace, x, 1));
  });
}

Broken state_position_off(Trace& trace, std::uint64_t number) {
  return at_state(trace, number, is_later, [&](Json& state) {
    Json& x = state["particles"][0]["position"][0];
    x = mutation::number(x) == 0 ? Json("0x1p-20") : Json(stepped(trace, x, 1));
  });
}

Broken state_clock_off(Trace& trace, std::uint64_t number) {
  return at_state(trace, number, is_later, [&](Json& state) {
    state["particles"][0]["clock"] = {"0x1.8p-30", "0x0p+0"};
  });
}

Broken state_particle_missing(Trace& trace, std::uint64_t number) {
  return at_state(trace, number, is_later, [&](Json& state) { state["particles"].erase(0); });
}

Broken state_tether_missing(Trace& trace, std::uint64_t number) {
  return at_state(
      trace, number, [](const Json& s) { return has_entries(s, "tethers"); },
      [&](Json& state) { state["tethers"].erase(0); });
}

Broken state_tether_invented(Trace& trace, std::uint64_t number) {
  const auto lacks_one = [](const Json& s) {
    return s.at("particles").size() > 2 && s.at("tethers").size() < s.at("particles").size() - 2;
  };
  return at_state(trace, number, lacks_one, [&](Json& state) {
    const Json& particles = state["particles"];
    for (std::size_t n = 0; n + 1 < particles.size(); ++n) {
      const Json pair = Json::array({particles[n].at("id"), particles[n + 1].at("id")});
      if (std::ranges::count(state["tethers"], pair) > 0) continue;
      state["tethers"].push_back(pair);
      return;
    }
  });
}

Broken state_forgets_responses(Trace& trace, std::uint64_t number) {
  return at_state(
      trace, number, [](const Json& s) { return has_entries(s, "responded"); },
      [&](Json& state) { state["responded"] = Json::array(); });
}

bool holds_groups(const Json& state) {
  return has_entries(state, "groups");
}

Broken state_expiry_off(Trace& trace, std::uint64_t number) {
  return at_state(trace, number, holds_groups, [&](Json& state) {
    Json& hi = state["groups"][0]["expiry"][0];
    hi = stepped(trace, hi, 1);
  });
}

Broken state_group_missing(Trace& trace, std::uint64_t number) {
  return at_state(trace, number, holds_groups, [&](Json& state) { state["groups"].erase(0); });
}

Broken state_node_impulse_off(Trace& trace, std::uint64_t number) {
  return at_state(trace, number, holds_groups, [&](Json& state) {
    Json& dp = state["groups"][0]["nodes"][0]["dp"];
    dp = spelt(trace, Vec(numbers(dp) * 1.5 + 1.));
  });
}

Broken state_sides_exchanged(Trace& trace, std::uint64_t number) {
  return at_state(trace, number, holds_groups, [&](Json& state) {
    Json& sides = state["groups"][0]["nodes"][0]["sides"];
    std::swap(sides[0], sides[1]);
  });
}

Broken state_draws_off(Trace& trace, std::uint64_t number) {
  return at_state(
      trace, number, [](const Json& s) { return has_entries(s, "draws"); },
      [&](Json& state) { state["draws"][0][3] = state["draws"][0][3].get<int>() + 1; });
}

Broken state_plan_off(Trace& trace, std::uint64_t number) {
  return at_state(
      trace, number, [](const Json& s) { return has_entries(s, "progress"); },
      [&](Json& state) {
        for (auto& [effect, done] : state["progress"].items()) done = done.template get<int>() - 1;
      });
}

Broken state_counts_off(Trace& trace, std::uint64_t number) {
  const auto counts_events = [](const Json& s) {
    return is_later(s) && std::any_of(s.at("counts").items().begin(), s.at("counts").items().end(),
                                      [](const auto& item) { return item.key()[0] != '#'; });
  };
  return at_state(trace, number, counts_events, [&](Json& state) {
    for (auto& [kind, count] : state["counts"].items()) {
      if (kind[0] != '#') count = count.template get<int>() + 1;
    }
  });
}

Broken state_time_off(Trace& trace, std::uint64_t number) {
  const auto has_time = [](const Json& s) { return is_later(s) && mutation::number(s.at("now")[0]) > 0; };
  return at_state(trace, number, has_time, [&](Json& state) {
    Json& hi = state["now"][0];
    hi = stepped(trace, hi, 1);
  });
}

/// The state's clock in every one of its spellings, so that it fits itself and not the run.
Broken state_clock_ahead(Trace& trace, std::uint64_t number) {
  const auto has_time = [](const Json& s) { return is_later(s) && mutation::number(s.at("now")[0]) > 0; };
  return at_state(trace, number, has_time, [&](Json& state) {
    const int ulps = 1 << number % 20;
    for (Json* hi : {&state["now"][0], &state["t"]}) *hi = stepped(trace, *hi, ulps);
  });
}

/// One event too late in the file, and otherwise as it was.
Broken state_out_of_place(Trace& trace, std::uint64_t) {
  for (std::size_t n = 0; n + 1 < trace.lines.size(); ++n) {
    if (!is_state(trace.lines[n]) || !is_event(trace.lines[n + 1])) continue;
    trace.lines.swap(n, n + 1);
    return trace.lines[n + 1].at("state").get<std::uint64_t>();
  }
  return {};
}

}  // namespace

const std::vector<Mutation>& broken_states() {
  using enum check::Rule;
  static const std::vector<Mutation> list = {
      {"state_velocity_off", "a full state has a velocity that is an ulp off", states, state_velocity_off},
      {"state_position_off", "… a position", states, state_position_off},
      {"state_clock_off", "… a clock that is not the particle's", states, state_clock_off},
      {"state_particle_missing", "a full state lacks a particle", states, state_particle_missing},
      {"state_tether_missing", "… a tether", states, state_tether_missing},
      {"state_tether_invented", "a full state has a tether that never formed", states, state_tether_invented},
      {"state_forgets_responses", "a full state has no pairs that responded", states,
       state_forgets_responses},
      {"state_expiry_off", "a group's expiry is an ulp off", states, state_expiry_off},
      {"state_group_missing", "a full state lacks a group", states, state_group_missing},
      {"state_node_impulse_off", "a node keeps another impulse", states, state_node_impulse_off},
      {"state_sides_exchanged", "the sides of a node are exchanged", states, state_sides_exchanged},
      {"state_draws_off", "a full state has used one draw more", states, state_draws_off},
      {"state_plan_off", "a full state has done one planned event less", states, state_plan_off},
      {"state_counts_off", "a full state counts one event more", states, state_counts_off},
      {"state_time_off", "a full state is an ulp later than its event", states, state_time_off},
      {"state_clock_ahead", "a full state's clock is ahead of its event, t and now alike", states,
       state_clock_ahead},
      {"state_out_of_place", "a full state stands one event too late", states, state_out_of_place},
  };
  return list;
}

}  // namespace tps::mutation

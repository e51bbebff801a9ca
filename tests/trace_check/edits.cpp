#include "tests/trace_check/edits.hpp"

#include <algorithm>

namespace tps::mutation {
namespace {

bool are_pair(const Json& event, int i, int j) {
  return event.value("i", -1) == i && event.value("j", -1) == j;
}

}  // namespace

std::uint64_t number_of_last(const Trace& trace) {
  return trace.lines.back().at("events").get<std::uint64_t>();
}

Broken end_for(Trace& trace, const char* reason) {
  trace.lines.change_last()["end"] = reason;
  return number_of_last(trace);
}

void erase_line(Trace& trace, std::size_t line) {
  trace.lines.erase(line);
}

void insert_line(Trace& trace, std::size_t line, Json text) {
  trace.lines.insert(line, std::move(text));
}

void cut_behind(Trace& trace, std::size_t line) {
  Json state = trace.lines[*last_state(trace)];
  Json end = trace.lines.back();
  trace.lines.keep_first(line + 1);
  Retold told(trace);
  for (std::size_t n = 0; n <= line; ++n) told.hear(trace.lines[n], n);
  for (Json& p : state["particles"]) {
    const Flight& flight = told.flight(p.at("id"));
    p["position"] = spelt(trace, flight.position);
    p["velocity"] = spelt(trace, flight.velocity);
    p["clock"] = Json::array({spelt(trace, since_start(trace, flight.t)), "0x0p+0"});
  }
  state["tethers"] = told.tethers();
  state["responded"] = Json::array();
  end["end"] = "max_events";
  trace.lines.push_back(std::move(state));
  trace.lines.push_back(std::move(end));
  settle(trace);
}

void move_event(Trace& trace, std::size_t line, double since) {
  trace.lines.change(line)["t"] = clock_time(trace, since);
  settle(trace);
}

void carry_event(Trace& trace, std::size_t line, const Retold& before, double since) {
  move_event(trace, line, since);
  Json& event = trace.lines.change(line);
  for (const char* when : {"pre", "post"}) {
    for (const auto& [id, state] : event[when].items()) {
      state["position"] = spelt(trace, before.position(std::stoi(id), event.at("t")));
    }
  }
}

void part_by(Trace& trace, Json& event, const double (&masses)[2], const Vec& dp) {
  const std::string ids[2] = {key(event.at("i")), key(event.at("j"))};
  for (int side = 0; side < 2; ++side) {
    const Vec before = numbers(event["pre"][ids[side]]["velocity"]);
    const Vec change = dp / (side == 0 ? masses[side] : -masses[side]);
    event["post"][ids[side]]["velocity"] = spelt(trace, Vec(before + change));
  }
}

std::optional<std::size_t> restitution_of(const Trace& trace, std::size_t load) {
  const int i = trace.lines[load].at("i");
  const int j = trace.lines[load].at("j");
  for (std::size_t n = load + 1; n < trace.lines.size(); ++n) {
    const Json& line = trace.lines[n];
    if (is_event(line) && line.at("kind") == "restitute" && are_pair(line, i, j)) return n;
  }
  return {};
}

void set_impulse(Trace& trace, const Place& place, const Vec& dp) {
  const double masses[2] = {place.before.body_mass(place.i()), place.before.body_mass(place.j())};
  Json& event = trace.lines.change(place.line);
  const Vec more = dp - numbers(event.at("dp"));
  event["dp"] = spelt(trace, dp);
  if (!is_load(event)) {
    part_by(trace, event, masses, dp);
    return;
  }
  const Vec stored = numbers(event.at("dp_stored")) + more;
  event["dp_stored"] = spelt(trace, stored);
  const auto parted = restitution_of(trace, place.line);
  if (!parted) return;
  Json& restitution = trace.lines.change(*parted);
  restitution["dp"] = event["dp_stored"];
  part_by(trace, restitution, masses, stored);
}

double coefficient(const Place& place) {
  const PairLaw& law = *place.before.law(place.i(), place.j());
  return place.event.at("kind") == "rebound" ? law.blocking->c_rebound : law.tethering->c_retract;
}

std::optional<std::size_t> last_state(const Trace& trace) {
  for (std::size_t n = trace.lines.size(); n-- > 0;) {
    if (is_state(trace.lines[n])) return n;
  }
  return {};
}

Json& particle_of(Json& state, int id) {
  Json& particles = state["particles"];
  return *std::find_if(particles.begin(), particles.end(), [id](const Json& p) { return p.at("id") == id; });
}

}  // namespace tps::mutation

#include "reference/trace/state_data.hpp"

#include <nlohmann/json.hpp>

namespace tps {

using nlohmann::json;
using ordered = nlohmann::ordered_json;

namespace {

const char* limit_name(bool outer) {
  return outer ? "outer" : "inner";
}

ordered side_json(const StateData::Side& side) {
  if (side.node) return {{"node", *side.node}};
  if (side.particle) return {{"particle", *side.particle}};
  return nullptr;
}

StateData::Side side_from(const json& value) {
  if (value.is_null()) return {};
  if (value.contains("node")) return {value.at("node").get<int>(), std::nullopt};
  return {std::nullopt, value.at("particle").get<std::int32_t>()};
}

ordered group_json(const StateData::Group& group) {
  ordered nodes = ordered::array();
  for (const StateData::Node& n : group.nodes) {
    nodes.push_back({{"i", n.i},
                     {"j", n.j},
                     {"limit", limit_name(n.outer)},
                     {"sides", {side_json(n.sides[0]), side_json(n.sides[1])}},
                     {"masses", n.masses},
                     {"dp", n.dp}});
  }
  return {{"members", group.members},
          {"mass", group.mass},
          {"expiry", group.expiry},
          {"birth", group.birth},
          {"nodes", nodes}};
}

StateData::Group group_from(const json& value) {
  StateData::Group group{value.at("members"), value.at("mass"), value.at("expiry"), value.at("birth"), {}};
  for (const json& n : value.at("nodes")) {
    group.nodes.push_back({n.at("i"),
                           n.at("j"),
                           n.at("limit") == "outer",
                           {side_from(n.at("sides").at(0)), side_from(n.at("sides").at(1))},
                           n.at("masses"),
                           n.at("dp")});
  }
  return group;
}

}  // namespace

std::string write_state(const StateData& state, const Hex& t) {
  ordered line{{"state", state.k}, {"t", t}};
  if (state.final) line["final"] = true;
  line["now"] = state.now;
  line["last_event"] = state.last_event;
  line["progress_event"] = state.progress_event;
  ordered& particles = line["particles"] = ordered::array();
  for (const StateData::Particle& p : state.particles) {
    particles.push_back(
        {{"id", p.id}, {"position", p.position}, {"velocity", p.velocity}, {"clock", p.clock}});
  }
  line["tethers"] = state.tethers;
  ordered& responded = line["responded"] = ordered::array();
  for (const StateData::Responded& r : state.responded) {
    responded.push_back(ordered::array({r.first, r.second, limit_name(r.outer)}));
  }
  ordered& groups = line["groups"] = ordered::array();
  for (const StateData::Group& group : state.groups) groups.push_back(group_json(group));
  ordered& draws = line["draws"] = ordered::array();
  for (const StateData::Draws& d : state.draws) {
    draws.push_back(ordered::array({d.purpose, d.first, d.second, d.used}));
  }
  line["progress"] = state.progress;
  line["counts"] = state.counts;
  line["quantities"] = state.quantities;
  line["observations"] = state.observations;
  return line.dump();
}

StateData read_state(std::string_view text) {
  const json line = json::parse(text);
  StateData state;
  state.k = line.at("state");
  state.final = line.value("final", false);
  state.now = line.at("now");
  state.last_event = line.at("last_event");
  state.progress_event = line.at("progress_event");
  for (const json& p : line.at("particles")) {
    state.particles.push_back({p.at("id"), p.at("position"), p.at("velocity"), p.at("clock")});
  }
  state.tethers = line.at("tethers").get<std::vector<std::array<std::int32_t, 2>>>();
  for (const json& r : line.at("responded"))
    state.responded.push_back({r.at(0), r.at(1), r.at(2) == "outer"});
  for (const json& group : line.at("groups")) state.groups.push_back(group_from(group));
  for (const json& d : line.at("draws")) state.draws.push_back({d.at(0), d.at(1), d.at(2), d.at(3)});
  state.progress = line.at("progress").get<std::map<std::string, std::uint64_t>>();
  state.counts = line.at("counts").get<std::map<std::string, std::uint64_t>>();
  state.quantities = line.at("quantities").get<std::map<std::string, HexVector>>();
  state.observations = line.at("observations").get<std::vector<std::vector<Hex>>>();
  return state;
}

}  // namespace tps

#include "reference/trace/state_data.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <span>

#include "reference/text/checksum.hpp"
#include "reference/text/fields.hpp"
#include "reference/text/hexfloat.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"
#include "reference/trace/own_lists.hpp"

namespace tps {

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

void append_numbers(std::string& text, std::string_view key, std::span<const Hex> numbers) {
  text.append(",\"").append(key).append("\":[");
  for (const Hex& number : numbers) text.append("\"").append(number).append("\",");
  if (numbers.empty()) {
    text.push_back(']');
  } else {
    text.back() = ']';
  }
}

/// Most of a state by far, written without the detour of a tree; hexadecimal floats need no escapes.
void append_particles(std::string& text, const std::vector<StateData::Particle>& particles) {
  text.append("\"particles\":[");
  for (const StateData::Particle& p : particles) {
    text.append("{\"id\":").append(std::to_string(p.id));
    append_numbers(text, "position", p.position);
    append_numbers(text, "velocity", p.velocity);
    if (!p.spin.empty()) append_numbers(text, "spin", p.spin);
    append_numbers(text, "clock", p.clock);
    text.append("},");
  }
  if (particles.empty()) {
    text.push_back(']');
  } else {
    text.back() = ']';
  }
}

/// The line without its checksum.
std::string content_of(const StateData& state, const Hex& t) {
  ordered head{{"state", state.k}, {"t", t}};
  if (state.final) head["final"] = true;
  head["now"] = state.now;
  head["last_event"] = state.last_event;
  head["progress_event"] = state.progress_event;
  std::string text = json_text(head);
  text.back() = ',';
  append_particles(text, state.particles);
  ordered line;
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
  text.append(",").append(json_text(line), 1);
  return text;
}

// Reading.

constexpr std::uint64_t kMostId = INT32_MAX;
/// Numbers of the widest scalar have 84 digits; but t is start_time + hi + lo, whose digits may lie far
/// apart.
constexpr std::size_t kLongestNumber = 2000;

std::int32_t id_from(const Field& value) {
  return static_cast<std::int32_t>(value.natural(kMostId));
}

Hex hex_from(const Field& value, bool may_be_infinite) {
  const Hex& text = value.text();
  const bool is_number = text.size() <= kLongestNumber && split_hex(text).has_value();
  if (!is_number && !(may_be_infinite && (text == "inf" || text == "-inf"))) {
    value.refuse(fmt::format("\"{}\" is not a hexadecimal float such as \"0x1.8p+1\"{}",
                             text.substr(0, kShownOfText), may_be_infinite ? " or \"inf\"" : ""));
  }
  return text;
}

HexVector numbers_from(const std::vector<Field>& entries, bool may_be_infinite) {
  HexVector numbers;
  for (const Field& entry : entries) numbers.push_back(hex_from(entry, may_be_infinite));
  return numbers;
}

HexVector vector_from(const Field& value) {
  const std::size_t size = value.json().array() == nullptr ? 0 : value.json().array()->size();
  return numbers_from(value.list_of(size == 2 ? 2 : 3), false);
}

HexTime time_from(const Field& value, bool may_be_never = false) {
  const std::vector<Field> parts = value.list_of(2);
  return {hex_from(parts[0], may_be_never), hex_from(parts[1], false)};
}

bool limit_from(const Field& value) {
  return value.word({"inner", "outer"}) == 1;
}

StateData::Particle particle_from(const Field& value) {
  value.require_keys({"id", "position", "velocity", "clock"}, {"spin"});
  StateData::Particle particle{id_from(value.at("id")), vector_from(value.at("position")),
                               vector_from(value.at("velocity")), time_from(value.at("clock"))};
  if (value.has("spin")) {
    const Field spin = value.at("spin");
    const std::size_t size = spin.json().array() == nullptr ? 0 : spin.json().array()->size();
    particle.spin = numbers_from(spin.list_of(size == 1 ? 1 : 3), false);
  }
  return particle;
}

StateData::Responded responded_from(const Field& value) {
  const std::vector<Field> parts = value.list_of(3);
  return {id_from(parts[0]), id_from(parts[1]), limit_from(parts[2])};
}

StateData::Side side_from(const Field& value) {
  if (value.is_null()) return {};
  if (value.has("node")) {
    value.require_keys({"node"});
    return {static_cast<int>(value.at("node").natural(kMostId)), std::nullopt};
  }
  value.require_keys({"particle"});
  return {std::nullopt, id_from(value.at("particle"))};
}

StateData::Node node_from(const Field& value) {
  value.require_keys({"i", "j", "limit", "sides", "masses", "dp"});
  const std::vector<Field> sides = value.at("sides").list_of(2);
  const HexVector masses = numbers_from(value.at("masses").list_of(2), true);
  return {id_from(value.at("i")),        id_from(value.at("j")),
          limit_from(value.at("limit")), {side_from(sides[0]), side_from(sides[1])},
          {masses[0], masses[1]},        vector_from(value.at("dp"))};
}

StateData::Group group_from(const Field& value) {
  value.require_keys({"members", "mass", "expiry", "birth", "nodes"});
  StateData::Group group;
  for (const Field& member : value.at("members").list()) group.members.push_back(id_from(member));
  group.mass = hex_from(value.at("mass"), true);
  group.expiry = time_from(value.at("expiry"), true);
  group.birth = time_from(value.at("birth"));
  for (const Field& node : value.at("nodes").list()) group.nodes.push_back(node_from(node));
  return group;
}

StateData::Draws draws_from(const Field& value) {
  const std::vector<Field> parts = value.list_of(4);
  return {static_cast<int>(parts[0].natural(kMostId)), id_from(parts[1]), id_from(parts[2]),
          static_cast<std::uint32_t>(parts[3].natural(UINT32_MAX))};
}

std::map<std::string, std::uint64_t> counts_from(const Field& value) {
  std::map<std::string, std::uint64_t> counts;
  for (const auto& [name, count] : value.members()) counts[name] = count.natural();
  return counts;
}

std::vector<Hex> observation_from(const Field& value) {
  std::vector<Hex> observation;
  for (const Field& entry : value.list()) observation.push_back(entry.text());
  return observation;
}

StateData state_from(const Field& line) {
  line.require_keys({"state", "t", "now", "last_event", "progress_event", "particles", "tethers", "responded",
                     "groups", "draws", "progress", "counts", "quantities", "observations"},
                    {"final", "checksum"});
  StateData state;
  state.k = line.at("state").natural();
  state.t = hex_from(line.at("t"), false);
  state.final = line.has("final") && line.at("final").truth();
  state.now = time_from(line.at("now"));
  state.last_event = time_from(line.at("last_event"));
  state.progress_event = line.at("progress_event").natural();
  for (const Field& p : line.at("particles").list()) state.particles.push_back(particle_from(p));
  for (const Field& tether : line.at("tethers").list()) {
    const std::vector<Field> pair = tether.list_of(2);
    state.tethers.push_back({id_from(pair[0]), id_from(pair[1])});
  }
  for (const Field& r : line.at("responded").list()) state.responded.push_back(responded_from(r));
  for (const Field& group : line.at("groups").list()) state.groups.push_back(group_from(group));
  for (const Field& d : line.at("draws").list()) state.draws.push_back(draws_from(d));
  state.progress = counts_from(line.at("progress"));
  state.counts = counts_from(line.at("counts"));
  for (const auto& [name, numbers] : line.at("quantities").members())
    state.quantities[name] = numbers_from(numbers.list(), false);
  for (const Field& o : line.at("observations").list()) state.observations.push_back(observation_from(o));
  return state;
}

/// Of a million particles: a line of a trace is no file of people.
constexpr JsonLimits kStateLimits{std::size_t{512} << 20U, 16, 100, 40'000'000};

}  // namespace

std::string write_state(const StateData& state, const Hex& t) {
  return with_checksum(content_of(state, t));
}

namespace {

/// A line spelt to the last byte as write_state spells it: of the tree that all JSON takes, only what is
/// short is made. Nothing for any other line, whether it is a state or not.
std::optional<StateData> own_state(std::string_view text) try {
  if (text.size() > kStateLimits.max_bytes) return std::nullopt;
  std::optional<StateWithoutLists> lists = without_own_lists(text);
  if (!lists) return std::nullopt;
  const std::string name = "state";
  const JsonDocument document = parse_json(lists->rest, name, kStateLimits);
  if (!document.problems.empty()) return std::nullopt;
  const Field line(document.root, name);
  StateData state = state_from(line);
  std::string content = content_of(state, state.t);
  if (line.has("checksum")) {
    const Hex& checksum = line.at("checksum").text();
    const std::string member = ",\"checksum\":\"" + checksum + "\"}";
    content.pop_back();
    if (!text.ends_with(member) || content + member != lists->rest) return std::nullopt;
    const std::string own = std::string(text.substr(0, text.size() - member.size())) + "}";
    state.checksum = checksum == checksum_of(own) ? StateData::Checksum::right : StateData::Checksum::wrong;
  } else if (content != lists->rest) {
    return std::nullopt;
  }
  state.particles = std::move(lists->particles);
  state.responded = std::move(lists->responded);
  return state;
} catch (const InputError&) {
  return std::nullopt;  // the other road says what is wrong, and where
}

}  // namespace

StateData read_state(std::string_view text, const std::string& file, std::size_t number) {
  if (std::optional<StateData> own = own_state(text)) return *std::move(own);
  const JsonDocument document = parse_json(text, file, kStateLimits, number);
  document.problems.throw_if_any();
  const Field line(document.root, file);
  StateData state = state_from(line);
  if (line.has("checksum")) {
    const bool right = line.at("checksum").text() == checksum_of(content_of(state, state.t));
    state.checksum = right ? StateData::Checksum::right : StateData::Checksum::wrong;
  }
  return state;
}

}  // namespace tps

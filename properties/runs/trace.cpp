#include "properties/runs/trace.hpp"

#include <sstream>
#include <stdexcept>

#include "reference/text/json_document.hpp"

namespace tps::properties::runs {
namespace {

[[noreturn]] void lacks(std::size_t line, const std::string& what) {
  throw std::runtime_error("trace:" + std::to_string(line) + ": lacks " + what +
                           "; docs/trace.md says what a line of a trace holds");
}

const JsonValue& member(const JsonValue& object, const char* key, std::size_t line) {
  const JsonValue* value = object.find(key);
  if (value == nullptr) lacks(line, std::string("\"") + key + "\"");
  return *value;
}

const std::string& text(const JsonValue& value, std::size_t line) {
  if (value.string() == nullptr) lacks(line, "a text");
  return *value.string();
}

template <typename Integer>
Integer integer(const JsonValue& value, std::size_t line) {
  if (value.number() == nullptr) lacks(line, "a whole number");
  return static_cast<Integer>(value.number()->value);
}

Point point(const JsonValue& value, std::size_t line) {
  if (value.array() == nullptr || value.array()->size() > 3) lacks(line, "a vector");
  Point result = Point::Zero();
  Eigen::Index k = 0;
  for (const JsonValue& component : *value.array()) result[k++] = read_real(text(component, line));
  return result;
}

Point spin_of(const JsonValue& value, std::size_t line) {
  const bool in_the_plane = value.array() != nullptr && value.array()->size() == 1;
  const Point read = point(value, line);
  return in_the_plane ? Point(0, 0, read[0]) : read;
}

std::map<std::int32_t, TracedState> states(const JsonValue* value, std::size_t line) {
  std::map<std::int32_t, TracedState> result;
  if (value == nullptr) return result;
  if (value->object() == nullptr) lacks(line, "states by id");
  for (const JsonMember& entry : *value->object()) {
    TracedState& state = result[static_cast<std::int32_t>(std::stol(entry.key))];
    state = {point(member(entry.value, "position", line), line),
             point(member(entry.value, "velocity", line), line)};
    if (const JsonValue* spin = entry.value.find("spin")) state.spin = spin_of(*spin, line);
  }
  return result;
}

TracedEvent event_of(const JsonValue& json, std::size_t line) {
  TracedEvent e;
  e.k = integer<std::uint64_t>(member(json, "k", line), line);
  const bool drag = json.find("s") != nullptr;  // the clock in which paths are straight
  e.t = read_instant(text(member(json, drag ? "s" : "t", line), line));
  e.dt = read_real(text(member(json, drag ? "ds" : "dt", line), line));
  if (drag) e.time = read_real(text(member(json, "t", line), line));
  if (const JsonValue* contact = json.find("contact")) e.sticks = text(*contact, line) == "sticks";
  e.kind = text(member(json, "kind", line), line);
  if (const JsonValue* i = json.find("i")) e.i = integer<std::int32_t>(*i, line);
  if (const JsonValue* j = json.find("j")) e.j = integer<std::int32_t>(*j, line);
  e.pre = states(json.find("pre"), line);
  e.post = states(json.find("post"), line);
  if (const JsonValue* dp = json.find("dp")) e.dp = point(*dp, line);
  if (const JsonValue* dp = json.find("dp_stored")) e.dp_stored = point(*dp, line);
  if (const JsonValue* list = json.find("members"); list != nullptr && list->array() != nullptr) {
    for (const JsonValue& id : *list->array()) e.members.push_back(integer<std::int32_t>(id, line));
  }
  if (const JsonValue* tether = json.find("tether")) e.tether = text(*tether, line);
  if (const JsonValue* draw = json.find("draw")) e.draw = read_real(text(*draw, line));
  if (const JsonValue* phase = json.find("phase")) e.phase = integer<int>(*phase, line);
  if (const JsonValue* wall = json.find("wall")) e.wall = integer<std::size_t>(*wall, line);
  if (const JsonValue* face = json.find("face")) e.face = integer<int>(*face, line);
  return e;
}

}  // namespace

std::string RunTrace::bytes() const {
  std::string all;
  for (const std::string& line : lines) all.append(line).push_back('\n');
  return all;
}

bool is_minimal(std::string_view bytes) {
  const std::string_view header = bytes.substr(0, bytes.find('\n'));
  const JsonDocument document = parse_json(header, "trace");
  const JsonValue* form = document.root.find("form");
  return form != nullptr && form->string() != nullptr && *form->string() == "minimal";
}

RunTrace read_trace(std::string_view bytes) {
  RunTrace trace;
  std::istringstream in{std::string(bytes)};
  for (std::string line; std::getline(in, line);) {
    trace.lines.push_back(line);
    const std::size_t number = trace.lines.size();
    const JsonDocument document = parse_json(line, "trace", {}, number);
    document.problems.throw_if_any();
    const JsonValue& json = document.root;
    if (number == 1) {
      static_cast<void>(member(json, "trace", number));
    } else if (json.find("kind") != nullptr) {
      trace.events.push_back(event_of(json, number));
    } else if (json.find("end") != nullptr) {
      trace.end = text(member(json, "end", number), number);
      trace.end_time =
          read_instant(text(member(json, json.find("s") != nullptr ? "s" : "t", number), number));
    } else if (json.find("state") == nullptr) {
      lacks(number, "\"kind\", \"state\" or \"end\"");
    }
  }
  return trace;
}

}  // namespace tps::properties::runs

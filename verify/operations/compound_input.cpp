#include "verify/operations/compound_input.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "reference/scene/read_scene.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/nearest_name.hpp"

namespace tps::operations {
namespace {

/// Groups of the paper's scenes hold a few bodies; exact fractions grow with each load.
constexpr std::size_t kMostBodies = 32;
constexpr std::size_t kMostCollisions = 32;

[[noreturn]] void refuse(const JsonValue& value, const Place& place, std::string message) {
  throw InputError({{place.source, value.line, place.pointer, std::move(message)}});
}

Place inside(const Place& place, std::string_view step) {
  return {place.source, fmt::format("{}/{}", place.pointer, step)};
}

/// One of two words.
bool is_second_word(const JsonValue& value, const Place& place, std::string_view one, std::string_view two) {
  const std::string* word = value.string();
  if (word == nullptr || (*word != one && *word != two))
    refuse(value, place, fmt::format("must be \"{}\" or \"{}\"", one, two));
  return *word == two;
}

TimingInput read_query(const JsonValue& value, const Place& place) {
  const bool tether = is_second_word(member(value, "kind", place), inside(place, "kind"), "block", "tether");
  return {tether ? TimingKind::tether : TimingKind::block,
          read_object("a timing query", operation(Op::block_time).keys, value, place, "kind")};
}

/// One query of an order from the words that begin with its prefix.
TimingInput query_from_words(const std::vector<std::string>& words, const std::string& prefix) {
  const std::string kind_key = prefix + "kind=";
  TimingInput query{TimingKind::block, {}};
  std::optional<std::string> given;
  std::vector<std::string> numbers;
  for (const std::string& word : words) {
    if (!word.starts_with(prefix)) continue;
    if (!word.starts_with(kind_key)) {
      numbers.push_back(word.substr(prefix.size()));
      continue;
    }
    given = word.substr(kind_key.size());
  }
  if (given != "block" && given != "tether") {
    throw InputError({{"command line", 0, "",
                       fmt::format("{0}kind is {1}; write {0}kind=block or {0}kind=tether", prefix,
                                   given ? *given : "missing")}});
  }
  if (given == "tether") query.kind = TimingKind::tether;
  const std::string which = prefix.substr(0, prefix.size() - 1);
  query.numbers = read_words(query.operation(), numbers, "command line, " + which);
  return query;
}

const JsonValue::Array& list(const JsonValue& in, const char* key, std::size_t most, const Place& place) {
  const JsonValue& value = member(in, key, place);
  if (value.array() == nullptr) refuse(value, inside(place, key), "must be a list");
  if (value.array()->size() > most) {
    refuse(value, inside(place, key),
           fmt::format("has {} entries; at most {} are taken", value.array()->size(), most));
  }
  return *value.array();
}

GroupInput::Body read_body(const JsonValue& value, const Place& place) {
  static const std::vector<std::string> keys{"m", "u", "v"};
  const Input body = read_object("a body", keys, value, place, "");
  return {body.values.at("m")[0], body.values.at("u"), body.values.at("v")};
}

GroupInput::Collision read_collision(const JsonValue& value, std::size_t bodies, const Place& place) {
  static const std::vector<std::string> inner_keys{"i", "j", "c"};
  static const std::vector<std::string> outer_keys{"i", "j", "c_retract", "c_revolve", "theta_revolve_deg"};
  const bool outer = is_second_word(member(value, "limit", place), inside(place, "limit"), "inner", "outer");
  const Input in = read_object(outer ? "an outer collision" : "an inner collision",
                               outer ? outer_keys : inner_keys, value, place, "limit");
  const auto number = [&](const char* key) { return in.values.at(key)[0]; };
  const auto index = [&](const char* key) {
    const double x = number(key);
    if (!(x >= 0 && x < static_cast<double>(bodies) && std::trunc(x) == x)) {
      refuse(value, inside(place, key),
             fmt::format("is {}; it must be a place in bodies, 0 to {}", x, bodies - 1));
    }
    return static_cast<std::size_t>(x);
  };
  GroupInput::Collision collision{index("i"), index("j"), outer};
  if (!outer) {
    collision.c = number("c");
    return collision;
  }
  collision.c_retract = number("c_retract");
  collision.c_revolve = number("c_revolve");
  collision.theta_revolve_deg = number("theta_revolve_deg");
  return collision;
}

}  // namespace

const JsonValue& member(const JsonValue& object, const char* key, const Place& place) {
  if (object.object() == nullptr) refuse(object, place, "must be an object");
  const JsonValue* value = object.find(key);
  if (value == nullptr) refuse(object, place, fmt::format("needs the key {}", key));
  return *value;
}

void require_keys(const JsonValue& object, const std::vector<std::string>& keys, const Place& place) {
  for (const JsonMember& each : *object.object()) {
    if (std::find(keys.begin(), keys.end(), each.key) != keys.end()) continue;
    refuse(each.value, inside(place, each.key),
           fmt::format("there is no key {}{} Allowed are {}", each.key, did_you_mean(each.key, keys),
                       fmt::join(keys, ", ")));
  }
}

OrderInput read_order(const JsonValue& in, const Place& place) {
  OrderInput order{read_query(member(in, "first", place), inside(place, "first")),
                   read_query(member(in, "second", place), inside(place, "second"))};
  require_keys(in, {"first", "second"}, place);
  return order;
}

OrderInput read_order_words(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (word.starts_with("first.") || word.starts_with("second.")) continue;
    throw InputError(
        {{"command line", 0, "", fmt::format("'{}' is neither first.key=value nor second.key=value", word)}});
  }
  return {query_from_words(words, "first."), query_from_words(words, "second.")};
}

GroupInput read_group(const JsonValue& in, const Place& place) {
  GroupInput group;
  const JsonValue::Array& bodies = list(in, "bodies", kMostBodies, place);
  for (std::size_t n = 0; n < bodies.size(); ++n) {
    const Place here = inside(place, fmt::format("bodies/{}", n));
    group.bodies.push_back(read_body(bodies[n], here));
    if (group.bodies[n].position.size() != group.bodies[0].position.size())
      refuse(bodies[n], here, "has another dimension than the first body; all must have the same");
  }
  const JsonValue::Array& collisions = list(in, "collisions", kMostCollisions, place);
  for (std::size_t n = 0; n < collisions.size(); ++n) {
    group.collisions.push_back(
        read_collision(collisions[n], bodies.size(), inside(place, fmt::format("collisions/{}", n))));
  }
  require_keys(in, {"bodies", "collisions"}, place);
  return group;
}

namespace {

Scene read_scene_in(const JsonValue& in, const Place& place) {
  const JsonValue& value = member(in, "scene", place);
  const Place here = inside(place, "scene");
  const JsonValue* particles = value.find("particles");
  if (particles != nullptr && particles->array() != nullptr && particles->array()->size() > kMostParticles) {
    refuse(*particles, inside(here, "particles"),
           fmt::format("has {} entries; the protocol takes at most {} particles; `tps run` takes any",
                       particles->array()->size(), kMostParticles));
  }
  return read_scene_value(value, here.source, here.pointer);
}

}  // namespace

Scene read_next_event(const JsonValue& in, const Place& place) {
  Scene scene = read_scene_in(in, place);
  require_keys(in, {"scene"}, place);
  return scene;
}

SimulateInput read_simulate(const JsonValue& in, const Place& place) {
  SimulateInput input{read_scene_in(in, place)};
  require_keys(in, {"scene", "max_events"}, place);
  if (input.scene.clusters) {
    refuse(
        *in.find("scene"), inside(place, "scene/observe"),
        "a reply is a trace, which has no samples, however many a scene asks for; leave observe out, or use "
        "`tps run`");
  }
  const JsonValue* most = in.find("max_events");
  if (most == nullptr) return input;
  const double n = most->number() != nullptr ? most->number()->value : 0;
  if (!(n >= 1 && n <= static_cast<double>(kMostEvents)) || std::trunc(n) != n) {
    refuse(*most, inside(place, "max_events"),
           fmt::format("must be an integer from 1 to {}; `tps run` takes any", kMostEvents));
  }
  input.max_events = static_cast<std::uint64_t>(n);
  return input;
}

}  // namespace tps::operations

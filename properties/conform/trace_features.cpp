#include "properties/conform/trace_features.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reference/text/input_error.hpp"
#include "reference/text/plain_json.hpp"

namespace tps::properties::conform {
namespace {

using Json = nlohmann::ordered_json;

std::string word(const Json& event, const char* key) {
  const auto found = event.find(key);
  return found != event.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// Spins stand where friction acts.
bool has_spins(const Json& event) {
  const auto post = event.find("post");
  return post != event.end() && post->is_object() &&
         std::any_of(post->begin(), post->end(),
                     [](const Json& state) { return state.is_object() && state.contains("spin"); });
}

std::set<std::string> features_of(const Json& event, const std::set<std::int64_t>& infinite) {
  std::set<std::string> met;
  const std::string kind = word(event, "kind");
  if (kind.empty()) return event.contains("end") ? std::set<std::string>{"end"} : met;
  met.insert(kind.starts_with("phase") ? "phase" : kind);
  if (word(event, "tether") == "formed") met.insert("formed");
  if (event.contains("draw")) met.insert("drawn");
  if (kind != "restitute" && event.contains("members")) met.insert("load");
  if (kind == "rebound" && has_spins(event)) met.insert("friction");
  for (const char* key : {"i", "j"}) {
    const auto id = event.find(key);
    if (id != event.end() && id->is_number_integer() && infinite.contains(id->get<std::int64_t>()))
      met.insert("infinite mass");
  }
  return met;
}

}  // namespace

std::map<std::uint64_t, std::set<std::string>> features_by_line(std::string_view trace, const Scene& scene) {
  std::set<std::int64_t> infinite;
  for (const Particle& p : scene.particles) {
    if (std::isinf(scene.species[static_cast<std::size_t>(p.species)].mass)) infinite.insert(p.id);
  }
  std::map<std::uint64_t, std::set<std::string>> lines;
  for (std::uint64_t number = 1; !trace.empty(); ++number) {
    const std::size_t end = std::min(trace.find('\n'), trace.size());
    const std::string_view line = trace.substr(0, end);
    trace.remove_prefix(std::min(end + 1, trace.size()));
    if (number == 1) continue;  // the header
    try {
      const Json event = parse_plain_json(line, "trace");
      if (event.is_object()) lines[number] = features_of(event, infinite);
    } catch (const InputError&) {
      lines[number];  // the check says what is wrong with it
    }
  }
  return lines;
}

}  // namespace tps::properties::conform

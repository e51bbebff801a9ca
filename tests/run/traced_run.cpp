#include "tests/run/traced_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

namespace tps::testing {
namespace {

using nlohmann::json;

double number(const std::string& text) {
  return std::strtod(text.c_str(), nullptr);
}

std::vector<double> numbers(const json& texts) {
  std::vector<double> result;
  for (const json& text : texts) result.push_back(number(text.get<std::string>()));
  return result;
}

std::map<int, TracedParticle> particles(const json& states) {
  std::map<int, TracedParticle> result;
  for (const auto& [id, state] : states.items()) {
    result[std::stoi(id)] = {numbers(state.at("position")), numbers(state.at("velocity")),
                             state.at("position"), state.at("velocity")};
  }
  return result;
}

TracedEvent event_of(const json& line) {
  TracedEvent e;
  e.k = line.at("k");
  e.exact_t = line.at("t");
  e.exact_dt = line.contains("ds") ? line.at("ds") : line.at("dt");
  e.exact_s = line.value("s", "");
  e.t = number(e.exact_t);
  e.dt = number(e.exact_dt);
  if (!e.exact_s.empty()) e.s = number(e.exact_s);
  e.kind = line.at("kind");
  e.i = line.value("i", -1);
  e.j = line.value("j", -1);
  e.tether = line.value("tether", "");
  e.phase = line.value("phase", -1);
  if (line.contains("pre")) e.pre = particles(line.at("pre"));
  if (line.contains("post")) e.post = particles(line.at("post"));
  if (line.contains("dp")) e.dp = numbers(line.at("dp"));
  if (line.contains("dp_stored")) e.dp_stored = numbers(line.at("dp_stored"));
  if (line.contains("draw")) e.draw = number(line.at("draw"));
  if (line.contains("members")) e.members = line.at("members").get<std::vector<int>>();
  return e;
}

PairLaw& law_of(Scene& scene, int a, int b) {
  for (PairLaw& law : scene.pairs) {
    if (law.species_a == std::min(a, b) && law.species_b == std::max(a, b)) return law;
  }
  scene.pairs.push_back({std::min(a, b), std::max(a, b), {}, {}});
  return scene.pairs.back();
}

}  // namespace

std::string scratch(const std::string& name) {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  // Of this build folder: two of them may be tested at once.
  const std::size_t folder = std::hash<std::string>()(std::filesystem::current_path().string());
  std::string path =
      "tps_" + std::to_string(folder) + "_" + test->test_suite_name() + "_" + test->name() + "_" + name;
  std::replace(path.begin(), path.end(), '/', '_');
  return ::testing::TempDir() + path;
}

std::string read_bytes(const std::string& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return std::move(bytes).str();
}

void write_bytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

RunOptions options_for(const std::string& scalar, std::optional<std::uint64_t> max_events) {
  RunOptions options;
  options.scalar = *scalar_kind(scalar);
  options.max_events = max_events;
  return options;
}

TracedRun traced(const Scene& scene, RunOptions options) {
  options.trace = scratch("trace.ndjson");
  TracedRun run;
  run.summary = run_scene(scene, options);
  run.bytes = read_bytes(options.trace);
  run.events = events_of(run.bytes);
  std::istringstream text(run.bytes);
  for (std::string line; std::getline(text, line);) run.lines.push_back(line);
  return run;
}

std::string traced_bytes(const Scene& scene, RunOptions options) {
  options.trace = scratch("trace.ndjson");
  run_scene(scene, options);
  return read_bytes(options.trace);
}

TracedRun traced(const Scene& scene, const std::string& scalar, std::optional<std::uint64_t> max_events) {
  return traced(scene, options_for(scalar, max_events));
}

std::vector<TracedEvent> events_of(const std::string& bytes) {
  std::vector<TracedEvent> events;
  std::istringstream text(bytes);
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("{\"k\":")) events.push_back(event_of(json::parse(line)));
  }
  return events;
}

Scene plain_scene(int dimension) {
  Scene scene;
  scene.dimension = dimension;
  scene.duration = std::numeric_limits<double>::infinity();
  scene.species = {{.name = "p", .mass = 1, .radius = 0.5, .max_tethers = {}}};
  return scene;
}

int add_species(Scene& scene, const std::string& name, double mass, double radius) {
  scene.species.push_back({.name = name, .mass = mass, .radius = radius, .max_tethers = {}});
  return static_cast<int>(scene.species.size()) - 1;
}

int add_particle(Scene& scene, int species, Coordinates position, Coordinates velocity) {
  const auto id = static_cast<std::int32_t>(scene.particles.size());
  scene.particles.push_back({.id = id, .species = species, .position = position, .velocity = velocity});
  return id;
}

PairLaw& block(Scene& scene, int a, int b, double c_rebound) {
  PairLaw& law = law_of(scene, a, b);
  const auto radius = [&](int s) { return scene.species[static_cast<std::size_t>(s)].radius; };
  law.blocking = BlockingLaw{.distance = radius(a) + radius(b), .c_rebound = c_rebound};
  return law;
}

PairLaw& tether(Scene& scene, int a, int b, double distance, double c_retract, FormRule::When form) {
  PairLaw& law = law_of(scene, a, b);
  law.tethering = TetheringLaw{.distance = distance,
                               .c_retract = c_retract,
                               .c_revolve = 1,
                               .theta_revolve_deg = 45,
                               .form = {.when = form},
                               .breaks = {}};
  return law;
}

std::vector<Coordinates> positions_at_the_end(const TracedRun& run) {
  const auto number = [](const json& hex) { return std::strtod(hex.get<std::string>().c_str(), nullptr); };
  const std::string& line = *std::find_if(run.lines.rbegin(), run.lines.rend(), [](const std::string& text) {
    return text.starts_with("{\"state\":");
  });
  const json state = json::parse(line);
  std::vector<Coordinates> positions;
  for (const json& particle : state.at("particles")) {
    const double since = number(state.at("now")[0]) - number(particle.at("clock")[0]);
    Coordinates x{};
    for (std::size_t k = 0; k < particle.at("position").size(); ++k)
      x[k] = number(particle.at("position")[k]) + since * number(particle.at("velocity")[k]);
    positions.push_back(x);
  }
  return positions;
}

}  // namespace tps::testing

#include "reference/scene/check_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "reference/scene/check_box.hpp"
#include "reference/scene/check_starts.hpp"
#include "reference/scene/check_walls.hpp"
#include "reference/text/json_pointer.hpp"
#include "reference/text/number_text.hpp"
#include "reference/text/schema_words.hpp"

namespace tps {
namespace {

const Species& species_of(const Scene& scene, int index) {
  return scene.species[static_cast<std::size_t>(index)];
}
const Particle& particle_of(const Scene& scene, int index) {
  return scene.particles[static_cast<std::size_t>(index)];
}
bool is_fixed(const Scene& scene, const Particle& particle) {
  return std::isinf(species_of(scene, particle.species).mass);
}
bool is_permanent(const TetheringLaw& law) {
  return law.form.when == FormRule::When::permanent;
}

std::string pair_name(const Scene& scene, int a, int b) {
  return fmt::format("{} and {}", in_quotes(species_of(scene, a).name), in_quotes(species_of(scene, b).name));
}

// "0.5", and "inf" where a sum of radii overflows.
std::string length(double value) {
  return std::isfinite(value) ? write_shortest(value) : "inf";
}

/// The laws by their species, the first of each pair; phases and tethers may be as many as laws.
using LawsBySpecies = std::map<std::pair<int, int>, const PairLaw*>;

LawsBySpecies laws_by_species(const Scene& scene) {
  LawsBySpecies laws;
  for (const PairLaw& law : scene.pairs) laws.emplace(std::pair(law.species_a, law.species_b), &law);
  return laws;
}

const PairLaw* find_law(const LawsBySpecies& laws, int a, int b) {
  const auto found = laws.find({std::min(a, b), std::max(a, b)});
  return found == laws.end() ? nullptr : found->second;
}

void check_pair(const Scene& scene, const PairLaw& law, const std::string& pointer, SceneSource& source) {
  const auto is_limit = [](double distance) { return distance > 0 && std::isfinite(distance); };
  if (law.blocking && !is_limit(law.blocking->distance)) {
    source.report(
        pointer + "/blocking/distance",
        fmt::format("the default, the sum of the radii of {}, is {}; a distance must be greater than 0 "
                    "and finite: give one here, or change the radii",
                    pair_name(scene, law.species_a, law.species_b), length(law.blocking->distance)));
  }
  if (!law.tethering) return;
  const std::string place = pointer + "/tethering";
  const bool given = resolve_pointer(source.root(), place).find("distance") != nullptr;
  if (!given && !is_permanent(*law.tethering)) {
    source.report(place, "key \"distance\" is missing; it has a default only with \"form\": \"permanent\"");
    return;
  }
  if (!is_limit(law.tethering->distance)) {
    source.report(
        place + "/distance",
        fmt::format("the default, the difference of the radii of {}, is {}; a distance must be greater "
                    "than 0 and finite: give one here, or change the radii",
                    pair_name(scene, law.species_a, law.species_b), length(law.tethering->distance)));
    return;
  }
  if (is_permanent(*law.tethering) && law.tethering->breaks.when != BreakRule::When::never) {
    source.report(place + "/break", "a permanent tether never breaks; allowed here: \"never\"");
  }
  // Semantics §3: with a smaller gap the pair bounces between its two limits without progress of the clock.
  const double smallest_gap = 1e-9 * law.tethering->distance;
  if (law.blocking && is_limit(law.blocking->distance) &&
      !(law.tethering->distance - law.blocking->distance > smallest_gap)) {
    source.report(
        place + "/distance",
        fmt::format("tethering distance {}, blocking distance {}; the tethering distance must exceed the "
                    "blocking distance by more than 1e-9 of itself",
                    length(law.tethering->distance), length(law.blocking->distance)));
  }
}

// Scene::phases[k] of a rule ("form" or "break") must not overlap another of the same pair.
template <typename HasRule>
void check_overlaps(const Scene& scene, std::string_view rule, HasRule has_rule, SceneSource& source) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < scene.phases.size(); ++k) {
    if (has_rule(scene.phases[k])) order.push_back(k);
  }
  const auto key = [&](std::size_t k) {
    const Phase& phase = scene.phases[k];
    return std::tuple(phase.species_a, phase.species_b, phase.from, k);
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::size_t last = 0;  // the phase of the pair at hand that ends last so far
  for (std::size_t n = 0; n < order.size(); ++n) {
    const Phase& phase = scene.phases[order[n]];
    const Phase& before = scene.phases[last];
    const bool same_pair =
        n > 0 && phase.species_a == before.species_a && phase.species_b == before.species_b;
    if (same_pair && phase.from < before.until) {
      source.report(
          fmt::format("/phases/{}", order[n]),
          fmt::format("overlaps /phases/{} (line {}), which replaces \"{}\" of the same pair until {}; "
                      "one rule can be replaced by one phase at a time",
                      last, source.line(fmt::format("/phases/{}", last)), rule, length(before.until)));
    }
    if (!same_pair || phase.until > before.until) last = order[n];
  }
}

void check_phases(const Scene& scene, SceneSource& source) {
  const LawsBySpecies laws = laws_by_species(scene);
  for (std::size_t k = 0; k < scene.phases.size(); ++k) {
    const Phase& phase = scene.phases[k];
    const std::string pointer = fmt::format("/phases/{}", k);
    if (!(phase.until > phase.from)) {
      source.report(pointer + "/until", fmt::format("found {}; allowed: a number greater than \"from\", {}",
                                                    length(phase.until), length(phase.from)));
    }
    const PairLaw* law = find_law(laws, phase.species_a, phase.species_b);
    const bool has_rules = law != nullptr && law->tethering && !is_permanent(*law->tethering);
    if (!has_rules) {
      const bool permanent = law != nullptr && law->tethering;
      source.report(pointer + "/between",
                    fmt::format("{} have {}; a phase replaces rules of a tethering that is not permanent",
                                pair_name(scene, phase.species_a, phase.species_b),
                                permanent ? "a permanent tethering" : "no tethering under \"pairs\""));
    }
  }
  check_overlaps(
      scene, "form", [](const Phase& phase) { return phase.form.has_value(); }, source);
  check_overlaps(
      scene, "break", [](const Phase& phase) { return phase.breaks.has_value(); }, source);
}

void check_infinite_masses(const Scene& scene, SceneSource& source) {
  const Particle* first = nullptr;
  for (std::size_t k = 0; k < scene.particles.size(); ++k) {
    const Particle& particle = scene.particles[k];
    if (!is_fixed(scene, particle)) continue;
    if (first == nullptr) first = &particle;
    if (particle.velocity == first->velocity) continue;
    source.report(fmt::format("/particles/{}/velocity", source.particle_entries[k]),
                  fmt::format("particles {} and {} have infinite mass and different velocities; particles of "
                              "infinite mass must all have the same velocity",
                              first->id, particle.id));
  }
}

void check_impulses(const Scene& scene, SceneSource& source) {
  for (std::size_t k = 0; k < scene.impulses.size(); ++k) {
    const Particle& particle = particle_of(scene, scene.impulses[k].particle);
    if (!is_fixed(scene, particle)) continue;
    source.report(fmt::format("/impulses/{}/particle", k),
                  fmt::format("particle {} has infinite mass: no impulse moves it; give it a finite mass, or "
                              "remove the impulse",
                              particle.id));
  }
}

// Kicks at random times move finite masses; a thermostat has no meaning for a body of several particles.
void check_kicks(const Scene& scene, SceneSource& source) {
  for (const Species& species : scene.species) {
    const std::string at = "/species/" + escape_pointer_key(species.name);
    const bool fixed = species.mass == std::numeric_limits<double>::infinity();
    for (const auto& [key, called] : {std::pair("random_impulses", species.random_impulses.has_value()),
                                      std::pair("thermostat", species.thermostat.has_value())}) {
      if (called && fixed)
        source.report(
            fmt::format("{}/{}", at, key),
            fmt::format("{} has infinite mass: no impulse moves it; give it a finite mass, or remove "
                        "the key",
                        in_quotes(species.name)));
    }
    if (species.thermostat && scene.grouping)
      source.report(
          at + "/thermostat",
          "a thermostat and \"grouping\" have no meaning together: a velocity of one particle's mass "
          "cannot be drawn for a body of several; remove one of the two");
  }
}

// Why two different particles cannot be tethered by the scene's list; empty if they can.
std::string objection(const Scene& scene, const LawsBySpecies& laws, const Particle& a, const Particle& b) {
  const PairLaw* law = find_law(laws, a.species, b.species);
  const std::string who = fmt::format("particles {} and {}", a.id, b.id);
  const std::string kinds = pair_name(scene, a.species, b.species);
  if (law == nullptr || !law->tethering) {
    return fmt::format("{}: {} have no tethering under \"pairs\"", who, kinds);
  }
  if (is_permanent(*law->tethering)) {
    return fmt::format("{}: the tethering of {} is permanent; such tethers are there without being listed",
                       who, kinds);
  }
  if (is_fixed(scene, a) && is_fixed(scene, b)) {
    return fmt::format("{} both have infinite mass; two such particles never interact", who);
  }
  return "";
}

void check_tethers(const Scene& scene, SceneSource& source) {
  const LawsBySpecies laws = laws_by_species(scene);
  std::map<std::pair<int, int>, std::size_t> entry_of;
  std::vector<int> held(scene.particles.size(), 0);
  for (std::size_t k = 0; k < scene.tethers.size(); ++k) {
    const auto [i, j] = scene.tethers[k];
    const Particle& a = particle_of(scene, i);
    const Particle& b = particle_of(scene, j);
    const std::string pointer = fmt::format("/tethers/{}", k);
    if (i == j) {
      source.report(pointer, fmt::format("particle {} is tethered to itself; name two particles", a.id));
      continue;
    }
    const auto [first, is_new] = entry_of.emplace(std::pair(i, j), k);
    if (!is_new) {
      source.report(pointer,
                    fmt::format("particles {} and {} are tethered by /tethers/{} (line {}) already", a.id,
                                b.id, first->second, source.line(fmt::format("/tethers/{}", first->second))));
      continue;
    }
    if (const std::string reason = objection(scene, laws, a, b); !reason.empty()) {
      source.report(pointer, reason);
      continue;
    }
    for (const int end : {i, j}) {
      const Particle& particle = particle_of(scene, end);
      const Species& species = species_of(scene, particle.species);
      const int count = ++held[static_cast<std::size_t>(end)];
      if (!species.max_tethers || count <= *species.max_tethers) continue;
      source.report(pointer,
                    fmt::format("this is tether number {} of particle {}; \"max_tethers\" of {} is {}", count,
                                particle.id, in_quotes(species.name), *species.max_tethers));
    }
  }
}

}  // namespace

void check_scene(const Scene& scene, SceneSource& source) {
  if (source.full()) return;
  if (source.sound({"species", "pairs"})) {
    for (std::size_t k = 0; k < scene.pairs.size(); ++k) {
      check_pair(scene, scene.pairs[k], fmt::format("/pairs/{}", k), source);
    }
  }
  if (source.sound({"species", "pairs", "phases"})) check_phases(scene, source);
  if (source.sound({"species", "grouping"})) check_kicks(scene, source);
  if (!source.sound({"species", "dimension", "particles"})) return;
  check_infinite_masses(scene, source);
  if (source.sound({"drag", "gravity", "grouping", "impulses", "phases", "walls"})) check_drag(scene, source);
  if (source.sound({"grouping", "walls"})) check_walls(scene, source);
  if (source.sound({"walls"})) check_starts_at_walls(scene, source);
  if (source.sound({"pairs", "grouping", "drag"})) check_friction(scene, source);
  if (source.sound({"box", "duration", "observe", "pairs", "walls"})) check_box(scene, source);
  if (source.sound({"impulses"})) check_impulses(scene, source);
  if (source.sound({"pairs", "tethers"})) check_tethers(scene, source);
  if (source.sound({"box", "pairs", "particles", "tethers"})) check_starts(scene, source);
}

}  // namespace tps

#include <fmt/format.h>

#include <cmath>

#include "reference/scene/check_scene.hpp"
#include "reference/text/json_pointer.hpp"
#include "reference/text/schema_words.hpp"

namespace tps {
namespace {

/// What happens at a time t that somebody gave, or for a length of time, has no place on the clock s.
constexpr const char* kByTheClock =
    "happens at times t, and under drag a run counts s = (1 - exp(-gamma t)) / gamma, which never reaches "
    "1 / gamma, so that a double has one s for all times after 37 / gamma; remove one of the two";

void refuse(SceneSource& source, const std::string& pointer, const std::string& what) {
  source.report(pointer, fmt::format("{} and \"drag\" are not defined together: it {}", what, kByTheClock));
}

}  // namespace

void check_drag(const Scene& scene, SceneSource& source) {
  if (!scene.drag) return;
  if (scene.gravity)
    source.report("/gravity",
                  "\"gravity\" and \"drag\" are not defined together: between kicks a falling particle under "
                  "drag moves on no straight line, in t or in s; remove one of the two");
  if (scene.grouping)
    source.report("/grouping",
                  "\"grouping\" and \"drag\" are not defined together: dt_restitute is a length of time, and "
                  "its end in s depends on when it begins; remove one of the two");
  if (!scene.phases.empty()) refuse(source, "/phases", "\"phases\"");
  if (!scene.impulses.empty()) refuse(source, "/impulses", "\"impulses\"");
  if (scene.clusters) refuse(source, "/observe", "\"observe\"");
  for (const Species& species : scene.species) {
    const std::string at = "/species/" + escape_pointer_key(species.name);
    if (species.random_impulses) refuse(source, at + "/random_impulses", "\"random_impulses\"");
    if (species.thermostat) refuse(source, at + "/thermostat", "\"thermostat\"");
  }
  for (std::size_t k = 0; k < scene.walls.size(); ++k) {
    if (scene.walls[k].velocity != Coordinates{})
      source.report(
          fmt::format("/walls/{}/velocity", k),
          fmt::format("wall {} moves: no drag slows it, so that its path is not straight in the clock "
                      "of a scene with \"drag\"; let it rest, or remove \"drag\"",
                      k));
  }
  for (std::size_t k = 0; k < source.particle_entries.size(); ++k) {
    const Particle& particle = scene.particles[k];
    const bool fixed = std::isinf(scene.species[static_cast<std::size_t>(particle.species)].mass);
    if (!fixed || particle.velocity == Coordinates{}) continue;
    source.report(
        fmt::format("/particles/{}/velocity", source.particle_entries[k]),
        fmt::format("particle {} has infinite mass and moves: no drag slows it, so that its path is "
                    "not straight in the clock of a scene with \"drag\"; let it rest, or remove "
                    "\"drag\"",
                    particle.id));
  }
}

}  // namespace tps

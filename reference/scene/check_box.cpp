#include "reference/scene/check_box.hpp"

#include <fmt/format.h>

#include <cmath>

#include "reference/scene/surfaces.hpp"
#include "reference/text/number_text.hpp"
#include "reference/text/schema_words.hpp"

namespace tps {
namespace {

bool is_open(double edge) {
  return std::isinf(edge);
}

void check_width(const Scene& scene, std::size_t k, double edge, SceneSource& source) {
  for (const PairLaw& law : scene.pairs) {
    const double blocking = law.blocking ? law.blocking->distance : 0;
    const double longest = law.tethering ? std::max(law.tethering->distance, blocking) : blocking;
    if (is_wide_enough(edge, longest)) continue;
    source.report(
        fmt::format("/box/periodic/{}", k),
        fmt::format("found {}; {} and {} interact over {}: a periodic edge must exceed two interaction "
                    "distances, {}, by more than a 64th of itself, or two images could be met at once",
                    write_shortest(edge),
                    in_quotes(scene.species[static_cast<std::size_t>(law.species_a)].name),
                    in_quotes(scene.species[static_cast<std::size_t>(law.species_b)].name),
                    write_shortest(longest), write_shortest(2 * longest)));
    return;
  }
}

void check_particles(const Scene& scene, std::size_t k, double edge, SceneSource& source) {
  for (std::size_t n = 0; n < scene.particles.size() && !source.full(); ++n) {
    const double x = scene.particles[n].position[k];
    if (x >= 0 && x < edge) continue;
    source.report(
        fmt::format("/particles/{}/position/{}", source.particle_entries[n], k),
        fmt::format("particle {} starts outside of the box: found {}; allowed: from 0 to below {}, the "
                    "periodic edge",
                    scene.particles[n].id, write_shortest(x), write_shortest(edge)));
  }
}

void check_walls_in_box(const Scene& scene, SceneSource& source) {
  std::size_t last = scene.walls.size();
  for (const Surface& surface : surfaces(scene)) {
    bool across = surface.kind != Surface::Kind::plane;
    for (std::size_t k = 0; k < surface.normal.size(); ++k)
      across = across || (!is_open(scene.box->edges[k]) && surface.normal[k] != 0);
    if (!across || surface.wall == last) continue;
    last = surface.wall;
    source.report(
        fmt::format("/walls/{}", surface.wall),
        "lies across a periodic axis, where it would have images; allowed in a periodic box: planes "
        "along its periodic axes");
  }
}

}  // namespace

bool is_wide_enough(double edge, double interaction_distance) {
  // Without something to spare the nearest image of a pair that meets is not certain, and would have to be
  // chosen again at once.
  constexpr double kSpare = 1. / 64;
  return edge * (1 - kSpare) > 2 * interaction_distance;
}

void check_box(const Scene& scene, SceneSource& source) {
  if (!scene.box) return;
  bool all_open = true;
  for (std::size_t k = 0; k < static_cast<std::size_t>(scene.dimension); ++k) {
    const double edge = scene.box->edges[k];
    if (is_open(edge)) continue;
    all_open = false;
    check_width(scene, k, edge, source);
    check_particles(scene, k, edge, source);
  }
  if (all_open) source.report("/box/periodic", "no axis is periodic; give one a length, or remove \"box\"");
  check_walls_in_box(scene, source);
  if (std::isinf(scene.duration)) {
    source.report(
        "/duration",
        "found \"inf\"; allowed with \"box\": a number; in a periodic box something may always lie ahead, "
        "so that nobody can tell when nothing more will happen");
  }
  if (scene.clusters) {
    source.report(
        "/observe/clusters",
        "clusters are not described in a periodic box, where one may go round it; remove one of the "
        "two");
  }
}

}  // namespace tps

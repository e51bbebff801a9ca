#include "reference/scene/check_walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "reference/scene/check_starts.hpp"
#include "reference/scene/surfaces.hpp"
#include "reference/text/number_text.hpp"
#include "reference/text/schema_words.hpp"

namespace tps {
namespace {

using Rational = boost::multiprecision::cpp_rational;

Rational dot(const Coordinates& x, const Coordinates& y, const Coordinates& from) {
  Rational sum = 0;
  for (std::size_t k = 0; k < x.size(); ++k) sum += Rational(x[k]) * (Rational(y[k]) - Rational(from[k]));
  return sum;
}

/// A vector divided by its length has three roundings a component and lies within 2^-50 of length 1; what
/// does not was not meant as a unit vector, and L would be measured in its units.
bool has_unit_length(const Coordinates& normal) {
  const Rational excess = dot(normal, normal, Coordinates{}) - 1;
  return abs(excess) <= Rational(0x1p-50);
}

std::string listed(const Coordinates& x, int dimension) {
  std::string text;
  for (int k = 0; k < dimension; ++k)
    text += (k == 0 ? "[" : ", ") + write_shortest(x[static_cast<std::size_t>(k)]);
  return text + "]";
}

void check_plane(const Scene& scene, const Wall& wall, const std::string& pointer, SceneSource& source) {
  if (has_unit_length(wall.normal)) return;
  const double length = std::hypot(wall.normal[0], wall.normal[1], wall.normal[2]);
  std::string remedy = "give it a direction";
  if (length > 0 && std::isfinite(length)) {
    Coordinates unit = wall.normal;
    for (double& component : unit) component /= length;
    remedy = "write " + listed(unit, scene.dimension);
  }
  source.report(pointer + "/plane/normal", fmt::format("found the length {}; allowed: 1, to rounding; {}",
                                                       write_shortest(length), remedy));
}

void check_box(const Scene& scene, const Wall& wall, const std::string& pointer, SceneSource& source) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(scene.dimension); ++k) {
    if (wall.high[k] > wall.point[k]) continue;
    source.report(fmt::format("{}/box/high/{}", pointer, k),
                  fmt::format("found {}; allowed: a number greater than that of \"low\", {}",
                              write_shortest(wall.high[k]), write_shortest(wall.point[k])));
  }
}

/// The radius at which a species touches is a limit of eq. (2), which needs one above 0.
void check_distances(const Scene& scene, SceneSource& source) {
  for (const Surface& surface : surfaces(scene)) {
    if (surface.face.value_or(0) > 0) continue;  // said once a box
    for (const Species& species : scene.species) {
      const double L = touching_distance(surface, species.radius);
      if (std::isinf(species.mass) || (L > 0 && std::isfinite(L))) continue;
      const std::string pointer = fmt::format("/walls/{}", surface.wall);
      if (surface.kind == Surface::Kind::plane) {
        source.report(pointer,
                      fmt::format("{} has the radius 0: a wall blocks a particle at its radius, which "
                                  "must be greater than 0; give it one",
                                  in_quotes(species.name)));
      } else {
        source.report(pointer + "/sphere/radius",
                      fmt::format("found {}; {} has the radius {}: {} must be greater than 0 and finite",
                                  write_shortest(surface.radius), in_quotes(species.name),
                                  write_shortest(species.radius),
                                  surface.kind == Surface::Kind::inside ? "their difference" : "their sum"));
      }
    }
  }
}

/// The point of a box that is nearest to a particle; itself, where it is inside.
Coordinates nearest_of(const BoxRegion& box, const Coordinates& u) {
  Coordinates nearest{};
  for (std::size_t k = 0; k < u.size(); ++k) nearest[k] = std::clamp(u[k], box.low[k], box.high[k]);
  return nearest;
}

bool starts_inside_of(const Surface& surface, const Particle& particle, double L) {
  if (surface.region)
    return start_verdict(nearest_of(*surface.region, particle.position), particle.position, L) ==
           StartVerdict::nearer;
  if (surface.kind != Surface::Kind::plane) {
    const bool inside = surface.kind == Surface::Kind::inside;
    return start_verdict(surface.point, particle.position, L) ==
           (inside ? StartVerdict::farther : StartVerdict::nearer);
  }
  double height = -L;
  double size = L;
  for (std::size_t k = 0; k < 3; ++k) {
    const double term = surface.normal[k] * (particle.position[k] - surface.point[k]);
    height += term;
    size += std::fabs(term);
  }
  if (height > 0x1p-48 * size) return false;  // six roundings of it at most
  const Rational exact = dot(surface.normal, particle.position, surface.point) - Rational(L);
  return exact < -Rational(start_allowance(surface.point, particle.position));
}

}  // namespace

void check_walls(const Scene& scene, SceneSource& source) {
  for (std::size_t n = 0; n < scene.walls.size(); ++n) {
    const std::string pointer = fmt::format("/walls/{}", n);
    if (scene.walls[n].shape == Wall::Shape::plane) check_plane(scene, scene.walls[n], pointer, source);
    if (scene.walls[n].shape == Wall::Shape::box) check_box(scene, scene.walls[n], pointer, source);
  }
  check_distances(scene, source);
  if (scene.grouping && !scene.walls.empty()) {
    source.report(
        "/walls",
        "walls and \"grouping\" have no meaning together yet: a node of a group joins two particles, and "
        "a wall is none; remove one of the two, or contain the particles by a permanent tether");
  }
}

void check_starts_at_walls(const Scene& scene, SceneSource& source) {
  for (const Surface& surface : surfaces(scene)) {
    if (surface.region && *surface.face > 0) continue;  // the box as a whole, once
    for (std::size_t n = 0; n < scene.particles.size(); ++n) {
      const Particle& particle = scene.particles[n];
      const Species& species = scene.species[static_cast<std::size_t>(particle.species)];
      const double L = touching_distance(surface, species.radius);
      if (std::isinf(species.mass) || !(L > 0) || !starts_inside_of(surface, particle, L)) continue;
      const Coordinates from =
          surface.region ? nearest_of(*surface.region, particle.position) : surface.point;
      source.report(
          fmt::format("/particles/{}/position", source.particle_entries[n]),
          fmt::format("particle {} starts beyond {}, which blocks it at {}, by more than 4 ulp of the "
                      "largest coordinate ({}); move it",
                      particle.id,
                      surface.region ? fmt::format("wall {}, a box it is outside of", surface.wall)
                                     : surface_name(surface),
                      write_shortest(L), write_shortest(start_allowance(from, particle.position))));
      if (source.full()) return;
    }
  }
}

}  // namespace tps

// Runs around a box that particles are outside of.
#include <algorithm>
#include <limits>
#include <vector>

#include "properties/runs/laws.hpp"
#include "properties/runs/outlook_scenes.hpp"
#include "properties/runs/wall_judge.hpp"

namespace tps::properties::runs {
namespace {

Point nearest_of(const Wall& block, const Point& u) {
  const Point low = point_of(block.point), high = point_of(block.high);
  return u.cwiseMax(low).cwiseMin(high);
}

Real distance(const Wall& block, const Point& u) {
  return (u - nearest_of(block, u)).norm();
}

/// The least distance from the block on a flight of dt. It is convex in time; between the moments at which a
/// coordinate passes an end of the block its square is a parabola.
Real least_distance(const Wall& block, const Flight& f, Real dt) {
  std::vector<Real> times{0, dt};
  const Point low = point_of(block.point), high = point_of(block.high);
  for (int k = 0; k < 3; ++k) {
    if (f.velocity[k] == 0) continue;
    for (const Real end : {low[k], high[k]})
      times.push_back(std::clamp((end - f.position[k]) / f.velocity[k], Real(0), std::max(Real(0), dt)));
  }
  std::sort(times.begin(), times.end());
  Real least = std::numeric_limits<Real>::infinity();
  for (std::size_t n = 0; n + 1 < times.size(); ++n) {
    const Point middle = f.position + f.velocity * ((times[n] + times[n + 1]) / 2);
    Real along = 0, speed = 0;  // over the axes on which the middle is beyond the ends
    for (int k = 0; k < 3; ++k) {
      if (middle[k] >= low[k] && middle[k] <= high[k]) continue;
      const Real end = middle[k] < low[k] ? low[k] : high[k];
      along += (f.position[k] - end) * f.velocity[k];
      speed += f.velocity[k] * f.velocity[k];
    }
    const Real vertex = speed > 0 ? std::clamp(-along / speed, times[n], times[n + 1]) : times[n];
    for (const Real t : {times[n], vertex, times[n + 1]})
      least = std::min(least, distance(block, f.position + f.velocity * t));
  }
  return least;
}

std::optional<std::string> comes_too_near(const Scene& scene, const ImpliedState& before, const Instant& t,
                                          Real u) {
  for (int i = 0; i < before.size(); ++i) {
    const Flight& f = before.flight(i);
    const Real gap = least_distance(scene.walls[1], f, elapsed(f.clock, t)) - radius_of(scene, before, i);
    if (gap < -slack_between_walls(scene, u))
      return "particle " + std::to_string(before.id_of(i)) +
             " comes nearer to the block than its radius, by " + std::to_string(-gap);
  }
  return std::nullopt;
}

/// Along the line from the nearest point of the block, which errs by the ulps of its places.
std::optional<std::string> turns_wrongly(const Scene& scene, const ImpliedState& before,
                                         const TracedEvent& event, Real u) {
  const Wall& block = scene.walls[1];
  const Point& at_event = event.pre.at(*event.i).position;
  const Point r = at_event - nearest_of(block, at_event);
  const Real turn = 2 * u + 4 * u * (at_event.norm() + point_of(block.high).norm()) / r.norm();
  const Real gap = r.norm() - radius_of(scene, before, before.index_of(*event.i));
  return rebounds_wrongly_at(scene, before, event, r / r.norm(), gap, turn, u);
}

RunVerdict stays_outside(const Scene& scene, Simulator& simulator) {
  const Real u = simulator.roundoff();
  return RunVerdict::of(
      first_fault(scene, simulator,
                  [&](const ImpliedState& before, const TracedEvent& event) -> std::optional<std::string> {
                    if (auto fault = comes_too_near(scene, before, event.t, u)) return fault;
                    const bool is_at_block = event.kind == "wall" && event.wall == 1;
                    return is_at_block ? turns_wrongly(scene, before, event, u) : std::nullopt;
                  }));
}

}  // namespace

std::vector<RunLaw> box_outside_laws() {
  Wanted free;
  free.grouping = Wanted::Choice::never;
  free.outside = free.infinite_masses = false;
  return {
      {33, "Block",
       "Nobody comes nearer than its radius to a box that it is outside of, on whole flights; at a face, an "
       "edge "
       "or a corner it is turned by eq. (4) along the line from the nearest point.",
       "docs/effects.md",
       [free](int dimension) mutable {
         free.dimension = dimension;
         free.tethers = true;
         return rc::gen::map(small_scene(free), around_a_block);
       },
       stays_outside, true},
  };
}

}  // namespace tps::properties::runs

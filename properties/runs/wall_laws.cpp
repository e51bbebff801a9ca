// Runs between walls.
#include <algorithm>
#include <array>

#include "properties/runs/laws.hpp"
#include "properties/runs/outlook_scenes.hpp"
#include "properties/runs/wall_judge.hpp"

namespace tps::properties::runs {
namespace {

/// A face of the box: n·r = L with r from a point of it.
struct Face {
  Point normal = Point::Zero(), point;
};

Face face_of(const Wall& box, int face) {
  Face found{Point::Zero(), point_of(face % 2 == 0 ? box.point : box.high)};
  found.normal[face / 2] = face % 2 == 0 ? 1 : -1;
  return found;
}

/// How far inside of the box a particle's surface is, and how far from the post's.
Real least_gap(const Scene& scene, const Point& u, Real radius) {
  const Wall &box = scene.walls[0], &post = scene.walls[1];
  Real gap = (u - point_of(post.point)).norm() - Real(post.radius) - radius;
  for (int face = 0; face < 2 * scene.dimension; ++face) {
    const Face of_box = face_of(box, face);
    gap = std::min(gap, of_box.normal.dot(u - of_box.point) - radius);
  }
  return gap;
}

/// A particle's flight up to t: at both ends, and where it is nearest to the post.
std::optional<std::string> leaves_walls(const Scene& scene, const ImpliedState& before, const Instant& t,
                                        Real u) {
  for (int i = 0; i < before.size(); ++i) {
    const Flight& f = before.flight(i);
    const Real dt = elapsed(f.clock, t);
    std::array<Real, 2> times{dt, dt};
    const Point r = f.position - point_of(scene.walls[1].point);
    if (const Real vv = f.velocity.squaredNorm(); vv > 0)
      times[1] = std::clamp(-r.dot(f.velocity) / vv, Real(0), std::max(Real(0), dt));
    for (const Real part : times) {
      const Real gap = least_gap(scene, f.position + f.velocity * part, radius_of(scene, before, i));
      if (gap < -slack_between_walls(scene, u))
        return "particle " + std::to_string(before.id_of(i)) + " is behind a wall by " + std::to_string(-gap);
    }
  }
  return std::nullopt;
}

/// Eq. (4) with an infinite mass at rest. The axis of a face is exact, that of the post turns by the ulps of
/// its places.
std::optional<std::string> rebounds_wrongly(const Scene& scene, const ImpliedState& before,
                                            const TracedEvent& event, Real u) {
  const int i = before.index_of(*event.i);
  const TracedState& pre = event.pre.at(*event.i);
  const Wall& wall = scene.walls.at(event.wall.value());
  Point n;
  Real gap = 0, turn = 2 * u;
  if (wall.shape == Wall::Shape::box) {
    const Face face = face_of(wall, event.face.value());
    n = face.normal;
    gap = n.dot(pre.position - face.point) - radius_of(scene, before, i);
  } else {
    const Point r = pre.position - point_of(wall.point);
    n = r / r.norm();
    gap = r.norm() - Real(wall.radius) - radius_of(scene, before, i);
    turn += 4 * u * (pre.position.norm() + point_of(wall.point).norm()) / r.norm();
  }
  return rebounds_wrongly_at(scene, before, event, n, gap, turn, u);
}

RunVerdict stays_within(const Scene& scene, Simulator& simulator) {
  const Real u = simulator.roundoff();
  return RunVerdict::of(
      first_fault(scene, simulator,
                  [&](const ImpliedState& before, const TracedEvent& event) -> std::optional<std::string> {
                    if (auto fault = leaves_walls(scene, before, event.t, u)) return fault;
                    return event.kind == "wall" ? rebounds_wrongly(scene, before, event, u) : std::nullopt;
                  }));
}

}  // namespace

std::vector<RunLaw> wall_laws() {
  Wanted free;
  free.grouping = Wanted::Choice::never;
  free.outside = free.infinite_masses = false;
  return {
      {30, "Walls",
       "Nobody is ever behind a wall, on whole flights; at one a particle is turned by eq. (4) with an "
       "infinite "
       "mass, and the wall gives what the particle gains.",
       "docs/effects.md",
       [free](int dimension) mutable {
         free.dimension = dimension;
         free.tethers = true;
         return rc::gen::map(small_scene(free), between_walls);
       },
       stays_within, true},
  };
}

}  // namespace tps::properties::runs

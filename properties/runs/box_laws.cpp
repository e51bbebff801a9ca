// Runs in periodic boxes.
#include <algorithm>
#include <cmath>
#include <limits>

#include "properties/runs/laws.hpp"
#include "properties/runs/outlook_scenes.hpp"
#include "properties/runs/scene_bounds.hpp"
#include "reference/scene/read_scene.hpp"
#include "reference/scene/write_scene.hpp"
#include "reference/text/input_error.hpp"

namespace tps::properties::runs {
namespace {

/// The difference to the nearest image.
Point nearest(const Scene& scene, Point r) {
  for (int k = 0; k < scene.dimension; ++k) r[k] = std::remainder(r[k], Real(scene.box->edges[at(k)]));
  return r;
}

/// Positions are unwrapped, so that they and their roundings grow with the way.
Real slack_in_box(const ImpliedState& before, int i, int j, const Instant& t, Real L, Real u) {
  Real size = L;
  for (const int n : {i, j}) {
    const Flight& f = before.flight(n);
    size += before.position(n, t).norm() + f.position.norm() + f.velocity.norm() * elapsed(f.clock, t);
  }
  return 80 * u * kSpare * size;
}

/// No two images nearer than their limit, at sixteen moments of the time since the last event.
std::optional<std::string> overlaps(const Scene& scene, const ImpliedState& before, const Instant& last,
                                    const TracedEvent& event, Real u) {
  const Real dt = elapsed(last, event.t);
  for (int i = 0; i < before.size(); ++i) {
    for (int j = i + 1; j < before.size(); ++j) {
      const PairLaw* law = before.law(i, j);
      if (law == nullptr || !law->blocking) continue;
      const Real L = before.stored(law->blocking->distance);
      for (int part = 1; part <= 16; ++part) {
        const Instant t{last.hi + (last.lo + dt * part / 16), 0};
        const Real distance = nearest(scene, before.position(j, part == 16 ? event.t : t) -
                                                 before.position(i, part == 16 ? event.t : t))
                                  .norm();
        if (distance < L - slack_in_box(before, i, j, event.t, L, u))
          return "particles " + std::to_string(before.id_of(i)) + " and " + std::to_string(before.id_of(j)) +
                 " are nearer than their limit, by an image";
      }
    }
  }
  return std::nullopt;
}

/// A rebound at the nearest image: at its limit, by eq. (4), with equal and opposite momenta.
std::optional<std::string> rebounds_elsewhere(const Scene& scene, const ImpliedState& before,
                                              const TracedEvent& event, Real u) {
  const int i = before.index_of(*event.i), j = before.index_of(*event.j);
  const PairLaw* law = before.law(i, j);
  const Real L = before.stored(law->blocking->distance), c = before.stored(law->blocking->c_rebound);
  const TracedState &a = event.pre.at(*event.i), &b = event.pre.at(*event.j);
  const Point r = nearest(scene, b.position - a.position);
  const Real off = slack_in_box(before, i, j, event.t, L, u);
  if (auto fault = beyond("distance of the nearest image from the limit", std::abs(r.norm() - L), off))
    return fault;
  const Point n = r / r.norm(), v = b.velocity - a.velocity;
  const Real mu = reduced(before.mass(i), before.mass(j));
  const Real rounding = (64 * u + 2 * off / L) * kSpare * (a.velocity.norm() + b.velocity.norm());
  const Point expected = (1 + c) * mu * std::min(v.dot(n), Real(0)) * n;
  if (auto fault =
          beyond("impulse along the nearest image", (event.dp.value() - expected).norm(), mu * rounding))
    return fault;
  const Point given_i = before.mass(i) * (event.post.at(*event.i).velocity - a.velocity);
  const Point given_j = before.mass(j) * (event.post.at(*event.j).velocity - b.velocity);
  const Real heavier = std::max(before.mass(i), before.mass(j));
  return beyond("momentum gained by both", (given_i + given_j).norm(), 2 * heavier * rounding);
}

/// Behind a shift coordinates are smaller, and with them what a start may overlap by (docs/scene.md).
bool is_a_scene(const Scene& scene) {
  try {
    read_scene_text(write_scene(scene), "shifted");
    return true;
  } catch (const InputError&) {
    return false;
  }
}

RunVerdict meets_images(const Scene& scene, Simulator& simulator) {
  if (!is_a_scene(scene)) return RunVerdict::not_asked();
  const Real u = simulator.roundoff();
  Instant last;
  return RunVerdict::of(
      first_fault(scene, simulator,
                  [&](const ImpliedState& before, const TracedEvent& event) -> std::optional<std::string> {
                    const auto fault = overlaps(scene, before, last, event, u);
                    last = event.t;
                    if (fault || event.kind != "rebound") return fault;
                    return rebounds_elsewhere(scene, before, event, u);
                  }));
}

/// Nobody is within half an edge of an image: speeds stay below what all the energy gives the lightest.
RunVerdict ignores_a_wide_box(const Scene& scene, Simulator& simulator) {
  Real energy = 0, lightest = std::numeric_limits<Real>::infinity();
  for (const Particle& p : scene.particles) {
    const Real mass = scene.species[at(p.species)].mass;
    energy += mass / 2 * point_of(p.velocity).squaredNorm();
    lightest = std::min(lightest, mass);
  }
  const Scene open = shifted(scene, 0);
  const Bounds bounds = bounds_of(open);
  const Real way = std::sqrt(2 * energy / lightest) * Real(scene.duration);
  const Real size = point_of(bounds.high).norm() + 4 * Real(longest_limit(scene));
  const int exponent = std::ilogb(4 * (way + size)) + 2;
  if (exponent > 100) return RunVerdict::not_asked();
  Scene boxed = open;
  boxed.box.emplace();
  boxed.box->edges.fill(std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < at(scene.dimension); ++k) boxed.box->edges[k] = std::ldexp(1.0, exponent);
  const RunTrace one = simulator.run(open), other = simulator.run(boxed);
  const std::size_t count = std::min(one.events.size(), other.events.size());
  for (std::size_t n = 0; n < count; ++n) {
    if (one.events[n] != other.events[n])
      return RunVerdict::broken("event " + std::to_string(n + 1) +
                                " is another one in a box that is never left");
  }
  if (one.events.size() != other.events.size())
    return RunVerdict::broken("a box that is never left changes the number of events");
  return {};
}

}  // namespace

std::vector<RunLaw> box_laws() {
  Wanted free;
  free.grouping = Wanted::Choice::never;
  free.outside = free.infinite_masses = false;
  return {
      {31, "Images",
       "In a periodic box no two images are nearer than their limit, and a rebound is one at the nearest "
       "image: "
       "eq. (4) along it, momentum kept.",
       "docs/effects.md",
       [free](int dimension) mutable {
         free.dimension = dimension;
         free.tethers = false;
         return scene_in_a_box(free);
       },
       meets_images, true},
      {32, "WideBox", "A periodic box that nobody comes near to leaving changes no event, bit for bit.",
       "docs/effects.md", of(free), ignores_a_wide_box, false, true},
  };
}

}  // namespace tps::properties::runs

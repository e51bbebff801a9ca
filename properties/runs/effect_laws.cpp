// Runs with effects of the outlook: drag, and friction with spins.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "properties/runs/laws.hpp"
#include "properties/runs/outlook_scenes.hpp"
#include "reference/scene/pair_law.hpp"

namespace tps::properties::runs {
namespace {

/// −ln(1 − γs)/γ in long double: 16 of its units off, and half an ulp of the double that is printed.
bool is_time_of(Real s, Real time, Real gamma, int digits) {
  if (digits > 53) return true;  // s has more than a long double holds
  if (s == 0) return time == 0;
  const Real t = -std::log1p(-gamma * s) / gamma;
  const Real z = gamma * s;
  const Real share = z < 1 ? z / ((1 - z) * std::max(-std::log1p(-z), z)) : 0;
  return std::abs(time - t) <= (std::ldexp(Real(1), -53) + (4 + share) * std::ldexp(Real(1), -62)) * t;
}

/// The run with drag is that of the scene without it, on the clock s, up to the last s before s(T).
RunVerdict drags(const Scene& scene, Simulator& simulator) {
  if (!can_have_drag(scene)) return RunVerdict::not_asked();
  Scene slowed = scene;
  const double gamma = 0.5 / scene.duration;
  slowed.drag = Drag{gamma};
  const Extent extent{.max_events = 60, .state_every = 0};
  const RunTrace slow = simulator.run(slowed, extent);
  const RunTrace free = simulator.run(scene, extent);
  if (slow.end == "stalled" || free.end == "stalled") return RunVerdict::not_asked();
  const int digits = simulator.scalar() == "float" ? 24 : simulator.scalar() == "double" ? 53 : 64;
  if (slow.events.size() > free.events.size())
    return RunVerdict::broken("drag makes " + std::to_string(slow.events.size() - free.events.size()) +
                              " events more");
  const Real last = -std::expm1(-Real(gamma) * Real(scene.duration)) / Real(gamma);
  const Real u = digits == 24 ? std::ldexp(Real(1), -24) : std::ldexp(Real(1), -53);
  for (std::size_t n = 0; n < slow.events.size(); ++n) {
    TracedEvent event = slow.events[n];
    const Real s = event.t.hi + event.t.lo;
    const std::string place = "event " + std::to_string(event.k) + ": ";
    if (!event.time) return RunVerdict::broken(place + "drag, and no clock s");
    if (!is_time_of(s, *event.time, gamma, digits))
      return RunVerdict::broken(place + "t is not -ln(1 - gamma s)/gamma");
    if (s > last * (1 + 4 * u)) return RunVerdict::broken(place + "happens behind the end of s(T)");
    event.time.reset();
    if (event != free.events[n]) return RunVerdict::broken(place + "is another one than without drag");
  }
  if (slow.end != "duration" || slow.events.size() == free.events.size()) return {};
  const Instant& next = free.events[slow.events.size()].t;
  if (next.hi + next.lo < last * (1 - 4 * u))
    return RunVerdict::broken("an event before the end of s(T) is missing");
  return {};
}

/// One of the two of a rebound with friction.
struct Side {
  Real inverse = 0, inertia = 0, radius = 0, speeds = 0;
  Point before = Point::Zero(), after = Point::Zero(), spin_before = Point::Zero(),
        spin_after = Point::Zero();
};

Side side_of(const Scene& scene, const TracedEvent& event, std::int32_t id) {
  const auto particle = std::ranges::find_if(scene.particles, [&](const Particle& p) { return p.id == id; });
  const Species& species = scene.species[static_cast<std::size_t>(particle->species)];
  const TracedState &pre = event.pre.at(id), &post = event.post.at(id);
  Side side;
  side.radius = species.radius;
  side.before = pre.velocity;
  side.after = post.velocity;
  side.speeds = side.before.norm() + side.after.norm();
  if (std::isinf(species.mass)) return side;
  side.inverse = 1 / Real(species.mass);
  side.inertia =
      (scene.dimension == 2 ? Real(1) / 2 : Real(2) / 5) * Real(species.mass) * side.radius * side.radius;
  side.spin_before = pre.spin.value_or(Point::Zero());
  side.spin_after = post.spin.value_or(Point::Zero());
  side.speeds += side.radius * (side.spin_before.norm() + side.spin_after.norm());
  return side;
}

/// Walton's laws at one rebound, by velocities and spins alone. Everything is known to 64 u of the speeds s,
/// those of surfaces among them (docs/ledger.md), times what is asked about.
std::optional<std::string> rubs_wrongly(const Scene& scene, const PairLaw& law, const TracedEvent& event,
                                        Real u) {
  const Side a = side_of(scene, event, *event.i), b = side_of(scene, event, *event.j);
  const Point r = event.pre.at(*event.j).position - event.pre.at(*event.i).position;
  const Point axis = r / r.norm();
  const Real mu = 1 / (a.inverse + b.inverse);
  const Real speeds = a.speeds + b.speeds;
  const Real turn =
      4 * u * (event.pre.at(*event.i).position.norm() + event.pre.at(*event.j).position.norm()) / r.norm();
  const Real allowed = (64 * u + turn) * speeds;
  const auto slip = [&](const Point& v, const Point& spin) -> Point {
    const Point g = v - spin.cross(axis);
    return g - g.dot(axis) * axis;
  };
  const Point before = slip(b.before - a.before, a.radius * a.spin_before + b.radius * b.spin_before);
  const Point after = slip(b.after - a.after, a.radius * a.spin_after + b.radius * b.spin_after);
  const Point dp = event.dp.value();
  const Real normal = std::abs(dp.dot(axis));
  const Real K = scene.dimension == 2 ? Real(1) / 2 : Real(2) / 5;
  const Real holding = (1 + Real(law.friction->beta0)) * K / (1 + K) * mu * before.norm();
  const Real most = Real(law.friction->mu) * normal;
  const Real across = (dp - dp.dot(axis) * axis).norm();
  const Real scale = 1 + Real(law.friction->mu);
  if (const auto fault = beyond("the tangential impulse, against min(mu J_n, what holds),",
                                std::abs(across - std::min(holding, most)), scale * mu * allowed))
    return fault;
  if (event.sticks.value_or(false)) {
    if (const auto fault = beyond("of sticking surfaces |g_t' + beta0 g_t|",
                                  (after + Real(law.friction->beta0) * before).norm(), 8 * allowed))
      return fault;
  }
  if (a.inverse == 0 || b.inverse == 0) return std::nullopt;
  const Point given = (a.after - a.before) / a.inverse;
  const Point angular = a.inertia * (a.spin_after - a.spin_before) +
                        b.inertia * (b.spin_after - b.spin_before) - r.cross(given);
  const Real masses = 1 / a.inverse + 1 / b.inverse;
  return beyond("the angular momentum gained, orbit and spin,", angular.norm(),
                std::abs(r.norm() - a.radius - b.radius) * dp.norm() + 8 * masses * r.norm() * allowed);
}

RunVerdict rubs(const Scene& scene, Simulator& simulator) {
  const Real u = judged_roundoff(simulator.scalar());
  if (!std::ranges::any_of(scene.pairs, [](const PairLaw& law) { return law.friction.has_value(); }))
    return RunVerdict::not_asked();
  const auto species_of = [&](std::int32_t id) {
    return std::ranges::find_if(scene.particles, [&](const Particle& p) { return p.id == id; })->species;
  };
  return RunVerdict::of(first_fault(
      scene, simulator, [&](const ImpliedState&, const TracedEvent& event) -> std::optional<std::string> {
        if (event.kind != "rebound") return std::nullopt;
        const PairLaw* law = pair_law(scene.pairs, species_of(*event.i), species_of(*event.j));
        if (law == nullptr || !law->friction || event.dp.value().isZero(0)) return std::nullopt;
        return rubs_wrongly(scene, *law, event, u);
      }));
}

}  // namespace

std::vector<RunLaw> effect_laws() {
  Wanted still;
  still.grouping = Wanted::Choice::never;
  still.outside = false;
  RunLaw drag{
      28,
      "Drag",
      "A run with drag is that of the scene without it on the clock s; its times are -ln(1 - gamma s)/gamma.",
      "docs/effects.md",
      of(still),
      drags};
  RunLaw friction{
      29,
      "Friction",
      "A rebound with friction gives the smaller of what slides and what holds across the axis, reverses "
      "the slip of sticking surfaces by beta0, and keeps angular momentum, orbit and spin.",
      "docs/effects.md",
      [still](int dimension) mutable {
        still.dimension = dimension;
        still.tethers = false;
        return rc::gen::map(small_scene(still), with_friction);
      },
      rubs};
  return {drag, friction};
}

}  // namespace tps::properties::runs

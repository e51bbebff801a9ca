// The steady orbit of a tethered pair: the paper's example of revolution.
#include <cmath>

#include "properties/runs/choices.hpp"
#include "properties/runs/laws.hpp"

namespace tps::properties::runs {
namespace {

/// A pair at its outer limit that moves exactly across; c_retract < 1, so that at 45° no retraction suffices.
Scene orbit(int dimension) {
  Scene scene;
  scene.dimension = dimension != 0 ? dimension : pick({2, 3});
  scene.duration = std::numeric_limits<double>::infinity();
  const double R = pick({1.0, 0.1, 7.0});
  const int steps = *rc::gen::inRange(1, 5);
  const double speed = steps * pick({1.0, 0.3});
  for (const char* name : {"a", "b"}) {
    const double mass = pick({1.0, 0.01, 3.0, 1e9});
    scene.species.push_back({name, mass, R / 4, {}});
  }
  PairLaw law{0, 1, {}, TetheringLaw{}};
  if (*rc::gen::arbitrary<bool>()) law.blocking = BlockingLaw{R / 2, 1};
  law.tethering->distance = R;
  law.tethering->c_retract = pick({0.5, 0.0, 0.9});
  law.tethering->c_revolve = pick({0.5, 1.0, 0.9, 0.1});
  law.tethering->form = {FormRule::When::never, 1};
  scene.pairs = {law};
  // Turned, so that v_n may be negative by rounding.
  const double angle = *rc::gen::inRange(0, 100), x = std::cos(angle), y = std::sin(angle);
  const bool upwards = scene.dimension == 3 && *rc::gen::arbitrary<bool>();
  const Coordinates across = upwards ? Coordinates{0, 0, speed} : Coordinates{-speed * y, speed * x, 0};
  scene.particles = {{0, 0, {}, {}}, {1, 1, {R * x, R * y, 0}, across}};
  scene.tethers = {{0, 1}};
  return scene;
}

/// Axis of the pair and relative speed afterwards, at one event.
struct Turn {
  Point axis;
  Real speed, farthest;
};

Turn turn_of(const TracedEvent& e) {
  const TracedState &a = e.post.at(0), &b = e.post.at(1);
  const Point r = b.position - a.position;
  return {r / r.norm(), (b.velocity - a.velocity).norm(), a.position.norm() + b.position.norm()};
}

/// One event turns the axis by twice the angle of the velocity, whose error docs/eq5.md bounds by 15√2 + 21 <
/// 43 u, and by landing beside the limit, 16 u (x_A + x_B + R)/R: four of them by less than 512 u (1 + (x_A +
/// x_B)/R). The two bodies' velocities are rounded relative to their own sizes, which are those of the
/// relative one here; a factor 2 for both.
RunVerdict orbits(const Scene& scene, Simulator& simulator) {
  const RunTrace run = simulator.run(scene, {.max_events = 13, .state_every = 0});
  const TetheringLaw& law = *scene.pairs.front().tethering;
  const Real u = simulator.roundoff(), c = law.c_revolve;
  std::vector<Turn> turns;
  for (const TracedEvent& e : run.events) {
    if (e.kind != "revolve") return RunVerdict::broken("event " + std::to_string(e.k) + " is no revolution");
    turns.push_back(turn_of(e));
  }
  if (turns.size() < 13)
    return RunVerdict::broken("the run ends after " + std::to_string(turns.size()) + " events");
  for (std::size_t n = 0; n + 4 < turns.size(); ++n) {
    const Turn &first = turns[n], &next = turns[n + 1], &fourth = turns[n + 4];
    const Real bound = 1024 * u * kSpare * (1 + fourth.farthest / Real(law.distance));
    for (const auto& fault :
         {beyond("axis after four events beside the axis before", (fourth.axis - first.axis).norm(), bound),
          beyond("cosine of the turn of one event", std::abs(next.axis.dot(first.axis)), bound),
          beyond("speed after four events beside c times that before",
                 std::abs(fourth.speed - c * first.speed), 1024 * u * kSpare * first.speed)}) {
      if (fault) return RunVerdict::broken("from event " + std::to_string(n + 1) + " on: " + *fault);
    }
  }
  return {};
}

}  // namespace

std::vector<RunLaw> orbit_laws() {
  return {
      {21, "Orbit",
       "A pair that moves across its taut tether at 45° has four events a revolution, each a quarter turn, "
       "and a revolution multiplies its speed by c_revolve.",
       "docs/eq5.md",
       [](int dimension) {
         return rc::gen::resize(rc::kNominalSize,
                                rc::gen::exec([dimension] { return SmallScene{orbit(dimension)}; }));
       },
       orbits}};
}

}  // namespace tps::properties::runs

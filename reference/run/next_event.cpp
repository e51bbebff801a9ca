#include "reference/run/next_event.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/engine/simulation.hpp"
#include "reference/run/end_of_times.hpp"
#include "reference/text/input_error.hpp"
#include "reference/trace/event_line.hpp"

namespace tps {
namespace {

/// Images of each other that pairs may pass before a search for an event in a periodic box is given up.
constexpr double kMostImages = 1e7;

/// How long all pairs together take to pass so many images: each passes one whenever two particles have
/// crossed an edge between them.
double longest_search(const Scene& scene) {
  double crossings = 0;  // a unit of time, of all particles
  for (const Particle& p : scene.particles) {
    for (std::size_t k = 0; k < 3; ++k) crossings += std::abs(p.velocity[k]) / scene.box->edges[k];
  }
  return kMostImages / (crossings * static_cast<double>(scene.particles.size()));
}

template <int D>
NextEvent next_event_in(const Scene& scene, const TimingChoice& timing) {
  Simulation<double, D> simulation(scene, timing);
  World<double, D>& world = simulation.world();
  NextEvent event;
  const auto id = [&](int i) { return scene.particles[static_cast<std::size_t>(i)].id; };
  world.sink = [&](const Record<double, D>& record) {
    event.kind = record.kind;
    event.dt = record.dt;
    if (record.i >= 0) event.i = id(record.i);
    if (record.j >= 0 && record.j != record.i) event.j = id(record.j);
    if (record.tether != TetherChange::none)
      event.tether = record.tether == TetherChange::formed ? "formed" : "broken";
  };
  // In a periodic box something may always lie ahead.
  const double until =
      scene.box ? std::min(scene.duration, longest_search(scene)) : std::numeric_limits<double>::infinity();
  const Time<double> last = clock_until<double>(scene, until);
  const bool goes_on = has_times_behind(scene, until, last);
  simulation.set_horizon(goes_on ? Time<double>::never() : last);
  const Time<double> next = simulation.next_time();
  const auto who = goes_on ? simulation.waits_behind(last) : simulation.waits_behind();
  if (who && !(scene.drag && is_never_reached(scene.drag->gamma, next)))
    throw OutOfRange("the time of the next event of " + *who);
  const bool happens = next != Time<double>::never() && next <= last;
  if (!happens && scene.box && until < scene.duration)
    throw InputError(
        {{"scene", 0, "",
          fmt::format("in the periodic box nothing happens until {:.6g} after the start, by when pairs "
                      "have passed {:.0e} of their images; no farther is looked: give a duration below that",
                      until, kMostImages)}});
  if (happens) simulation.step();
  if (scene.drag && event.dt) event.dt = drag_time(scene.drag->gamma, whole(world.now), 0);
  const double unit = scene.drag ? nearest<double>(drag_factor(scene.drag->gamma, whole(world.now))) : 1;
  for (int i = 0; i < world.size(); ++i) {
    const Vector<double, D> u = world.position(i, world.now);
    const Vector<double, D> v = world.velocity(i) * unit;
    event.state.push_back({id(i), {u.begin(), u.end()}, {v.begin(), v.end()}});
  }
  return event;
}

}  // namespace

NextEvent next_event(const Scene& scene, const TimingChoice& timing) {
  try {
    return scene.dimension == 2 ? next_event_in<2>(scene, timing) : next_event_in<3>(scene, timing);
  } catch (const OutOfRange& problem) {
    throw InputError(
        {{"scene", 0, "", std::string(problem.what()) + " leaves the range of double; choose other units"}});
  }
}

}  // namespace tps

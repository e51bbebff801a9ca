#include "reference/run/next_event.hpp"

#include <limits>

#include "reference/engine/simulation.hpp"
#include "reference/text/input_error.hpp"
#include "reference/trace/event_line.hpp"

namespace tps {
namespace {

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
  const double until = scene.box ? scene.duration : std::numeric_limits<double>::infinity();
  const Time<double> last = clock_until<double>(scene, until);
  simulation.set_horizon(last);
  if (const auto who = simulation.beyond_every_time())
    throw OutOfRange("the time of the next event of " + *who);
  const Time<double> next = simulation.next_time();
  if (next != Time<double>::never() && next <= last) simulation.step();
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

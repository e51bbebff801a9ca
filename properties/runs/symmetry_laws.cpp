// What a run does not depend on: units, orientation, the clock's start, strangers, names.
#include <algorithm>
#include <cmath>

#include "properties/runs/laws.hpp"

namespace tps::properties::runs {
namespace {

/// A change of units: lengths, times and masses by powers of two, axes by signs and perhaps a swap of x and
/// y.
struct Change {
  int length = 0, time = 0, mass = 0;  ///< exponents of two
  Point signs = Point::Ones();
  bool swap = false;

  Point turned(const Point& x, int exponent) const {
    Point y = x.cwiseProduct(signs);
    if (swap) std::swap(y[0], y[1]);
    return y * std::ldexp(Real(1), exponent);
  }
  Coordinates turned(const Coordinates& x, int exponent) const {
    const Point y = turned(Point(x[0], x[1], x[2]), exponent);
    return {static_cast<double>(y[0]), static_cast<double>(y[1]), static_cast<double>(y[2])};
  }
  int velocity() const { return length - time; }
  int impulse() const { return mass + length - time; }
};

Scene changed(Scene s, const Change& c) {
  const auto scale = [](double& x, int exponent) { x = std::ldexp(x, exponent); };
  scale(s.duration, c.time);
  for (Species& species : s.species) scale(species.mass, c.mass);
  for (PairLaw& pair : s.pairs) {
    if (pair.blocking) scale(pair.blocking->distance, c.length);
    if (pair.tethering) scale(pair.tethering->distance, c.length);
    if (pair.tethering) scale(pair.tethering->breaks.threshold, c.impulse());
  }
  if (s.grouping) scale(s.grouping->dt_restitute, c.time);
  for (Phase& phase : s.phases) {
    scale(phase.from, c.time);
    scale(phase.until, c.time);
    if (phase.breaks) scale(phase.breaks->threshold, c.impulse());
  }
  for (ScheduledImpulse& impulse : s.impulses) {
    scale(impulse.at, c.time);
    impulse.impulse = c.turned(impulse.impulse, c.impulse());
  }
  for (Particle& p : s.particles) {
    p.position = c.turned(p.position, c.length);
    p.velocity = c.turned(p.velocity, c.velocity());
  }
  return s;
}

TracedEvent changed(TracedEvent e, const Change& c) {
  e.t = {std::ldexp(e.t.hi, c.time), std::ldexp(e.t.lo, c.time)};
  e.dt = std::ldexp(e.dt, c.time);
  for (auto* states : {&e.pre, &e.post}) {
    for (auto& [id, state] : *states)
      state = {c.turned(state.position, c.length), c.turned(state.velocity, c.velocity())};
  }
  for (auto* impulse : {&e.dp, &e.dp_stored}) {
    if (*impulse) *impulse = c.turned(**impulse, c.impulse());
  }
  return e;
}

/// The first event in which a changed run differs from the run changed.
RunVerdict changes_with(const Scene& scene, Simulator& simulator, const Change& change) {
  const RunTrace run = simulator.run(scene);
  const RunTrace other = simulator.run(changed(scene, change));
  for (std::size_t n = 0; n < run.events.size(); ++n) {
    if (n == other.events.size() || changed(run.events[n], change) != other.events[n])
      return RunVerdict::broken("event " + std::to_string(run.events[n].k) + " is another one");
  }
  if (other.events.size() != run.events.size()) return RunVerdict::broken("the changed run has more events");
  return {};
}

RunVerdict scales(const Scene& scene, Simulator& simulator) {
  for (const Change& change :
       {Change{.length = 9, .time = 0, .mass = 0}, Change{.length = 0, .time = -7, .mass = 0},
        Change{.length = -11, .time = 3, .mass = 20}}) {
    const RunVerdict verdict = changes_with(scene, simulator, change);
    if (verdict.kind != RunVerdict::Kind::holds) return verdict;
  }
  return {};
}

RunVerdict reflects(const Scene& scene, Simulator& simulator) {
  const bool planar = scene.dimension == 2;
  for (const Change& change : {Change{.signs = Point(-1, 1, 1), .swap = planar},
                               Change{.signs = Point(1, -1, planar ? 1 : -1), .swap = false}}) {
    const RunVerdict verdict = changes_with(scene, simulator, change);
    if (verdict.kind != RunVerdict::Kind::holds) return verdict;
  }
  return {};
}

/// The events' lines from a key on.
std::vector<std::string> tails(const RunTrace& trace, const std::string& key) {
  std::vector<std::string> all;
  for (const std::string& line : trace.lines) {
    if (line.starts_with("{\"k\":")) all.push_back(line.substr(std::min(line.find(key), line.size())));
  }
  return all;
}

RunVerdict starts_anywhen(const Scene& scene, Simulator& simulator) {
  Scene late = scene;
  late.start_time = 0x1p+40;
  if (tails(simulator.run(scene), "\"dt\"") != tails(simulator.run(late), "\"dt\""))
    return RunVerdict::broken("a start at 2^40 has other events");
  return {};
}

RunVerdict ignores_strangers(const Scene& scene, Simulator& simulator) {
  Scene crowded = scene;
  const int stranger = static_cast<int>(crowded.species.size());
  crowded.species.push_back({"stranger", 1, 1, {}});
  const auto id = static_cast<std::int32_t>(crowded.particles.back().id + 1);
  crowded.particles.push_back({id, stranger, crowded.particles.front().position, {1, 1, 0}});
  if (tails(simulator.run(scene), "\"k\"") != tails(simulator.run(crowded), "\"k\""))
    return RunVerdict::broken("a particle without laws changes the others' events");
  return {};
}

/// The scene with the ids of its particles in the opposite order, and the way back.
Scene renamed(const Scene& scene) {
  Scene s = scene;
  const int last = static_cast<int>(s.particles.size()) - 1;
  std::ranges::reverse(s.particles);
  std::ranges::reverse(s.spins);
  for (int n = 0; n <= last; ++n) {
    s.particles[static_cast<std::size_t>(n)].id = scene.particles[static_cast<std::size_t>(n)].id;
  }
  for (Tether& t : s.tethers) t = {last - t.j, last - t.i};
  for (ScheduledImpulse& impulse : s.impulses) impulse.particle = last - impulse.particle;
  return s;
}

TracedEvent renamed(TracedEvent e, const Scene& scene) {
  const std::int32_t sum = scene.particles.front().id + scene.particles.back().id;
  const auto renamed_states = [&](const std::map<std::int32_t, TracedState>& states) {
    std::map<std::int32_t, TracedState> result;
    for (const auto& [id, state] : states) result[sum - id] = state;
    return result;
  };
  e.pre = renamed_states(e.pre);
  e.post = renamed_states(e.post);
  if (e.i) e.i = sum - *e.i;
  if (e.j) {
    e.j = sum - *e.j;
    std::swap(e.i, e.j);
    for (auto* impulse : {&e.dp, &e.dp_stored}) {
      if (*impulse) *impulse = -**impulse;
    }
  }
  for (std::int32_t& id : e.members) id = sum - id;
  std::ranges::reverse(e.members);
  e.k = 0;
  return e;
}

/// The events of one time, in an order that does not depend on ids.
struct Simultaneous {
  std::vector<TracedEvent> events;

  /// Two events at one time other than restitutions go by ids.
  bool is_tie() const {
    return std::ranges::count_if(events, [](const TracedEvent& e) { return e.kind != "restitute"; }) > 1;
  }
};

std::vector<Simultaneous> by_time(const std::vector<TracedEvent>& events) {
  std::vector<Simultaneous> times;
  for (const TracedEvent& e : events) {
    if (times.empty() || times.back().events.front().t != e.t) times.emplace_back();
    times.back().events.push_back(e);
    // dt is zero but for the first event of a time, whichever that is.
    times.back().events.back().dt = times.back().events.front().dt;
  }
  for (Simultaneous& time : times) {
    std::ranges::sort(time.events, {}, [](const TracedEvent& e) { return std::pair{e.i, e.j}; });
  }
  return times;
}

/// Runs part where a tie goes by ids; up to there they are the same. A run cut off by its number of events
/// may end within a time.
RunVerdict ignores_names(const Scene& scene, Simulator& simulator) {
  RunTrace run = simulator.run(scene);
  for (TracedEvent& e : run.events) e = renamed(e, scene);
  RunTrace other = simulator.run(renamed(scene));
  for (TracedEvent& e : other.events) e.k = 0;
  const std::vector<Simultaneous> expected = by_time(run.events), found = by_time(other.events);
  for (std::size_t n = 0; n + 1 < expected.size(); ++n) {
    if (expected[n].is_tie()) return {};
    if (n >= found.size() || expected[n].events != found[n].events)
      return RunVerdict::broken("the events at t = " + std::to_string(expected[n].events.front().t.hi) +
                                " are others where the ids run the other way");
  }
  return {};
}

}  // namespace

std::vector<RunLaw> symmetry_laws() {
  Wanted undrawn;  // A tie may be decided out of sight: the first of two contacts at one time can undo the
                   // other.
  undrawn.draws = undrawn.ties = false;
  return {
      {14, "Units",
       "Lengths, times and masses times powers of two (impulses and thresholds with them) scale a run bit "
       "for "
       "bit, but for a 0 that directed rounding makes the smallest number.",
       "docs/engine.md", of({}), scales, false, true},
      {15, "Reflection",
       "Reversed axes, and in the plane exchanged ones, turn a run bit for bit. In space an exchange "
       "would add three products in another order.",
       "docs/engine.md", of({}), reflects, false, true},
      {16, "StartTime", "The clock's start labels times and changes nothing else.", "docs/trace.md", of({}),
       starts_anywhen, false, true},
      {17, "Strangers", "A particle that interacts with nobody changes nobody's events.", "docs/engine.md",
       of({}), ignores_strangers, false, true},
      {18, "Names", "Where the order of ids decides no tie and keys no draw, other ids change nothing.",
       "docs/engine.md", of(undrawn), ignores_names, false, true},
  };
}

}  // namespace tps::properties::runs

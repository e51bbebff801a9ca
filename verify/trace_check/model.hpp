// What the check knows of a run at a moment, from the lines of the trace so far. It follows; it never
// simulates.
#pragma once

#include <map>
#include <set>
#include <string>

#include "reference/engine/large_pages.hpp"
#include "reference/scene/random.hpp"
#include "verify/trace_check/effect_rules.hpp"
#include "verify/trace_check/flight_in_doubles.hpp"
#include "verify/trace_check/group_model.hpp"
#include "verify/trace_check/line.hpp"
#include "verify/trace_check/pair_rules.hpp"
#include "verify/trace_check/small_map.hpp"
#include "verify/trace_check/wall_model.hpp"

namespace tps::check {

/// A particle since its velocity was last set.
template <typename Number>
struct Flight {
  Vec<Number> position, velocity;
  Instant<Number> since;
  Work<Number> blur{0};      ///< how far the position may be off: where the trace does not record it
  std::uint64_t events = 0;  ///< of the run when it began
  Work<Number> drift{0};     ///< how far the velocity may be off: where no line says it
};

template <typename Number>
class Model {
 public:
  using W = Work<Number>;

  Model(const Scene& scene, const Precision<Number>& precision);

  const Scene& scene;
  const Precision<Number> precision;
  RuleTable<Number> rules;
  bool eager = false;  ///< everybody is advanced, and rounded, at every event
  LargeVector<Flight<Number>> flights;
  std::vector<W> inverse_masses;               ///< 0 for an infinite mass
  std::optional<Vec<Number>> edges;            ///< of a periodic box; 0 along an open axis
  const std::vector<WallModel<Number>> walls;  ///< surfaces, by their place in surfaces(scene)
  std::vector<Vec<Number>> spins;              ///< of all, where some pair has friction; in the plane along z
  std::vector<std::set<int>> tethers;          ///< formed or listed, by particle
  GroupModel<Number> groups;
  std::vector<std::unique_ptr<EffectRules<Number>>> effects;  ///< by rank
  std::map<std::array<int, 3>, std::uint32_t> draws;
  std::vector<std::uint64_t> kinds = std::vector<std::uint64_t>(check::kinds().size());  ///< events so far
  std::uint64_t events = 0;
  Instant<Number> now;               ///< of the last event
  Instant<Number> asked;             ///< of the line that is being judged
  std::uint64_t progress_event = 0;  ///< the last one at which the clock's first part moved

  int size() const { return static_cast<int>(flights.size()); }
  std::int32_t id(int i) const { return scene.particles[at(i)].id; }
  bool fixed(int i) const { return inverse_masses[at(i)] == W(0); }
  const Flight<Number>& flight(int i) const { return flights[at(i)]; }
  const FlightInDoubles& flight_in_doubles(int i) const { return flights_in_doubles_[at(i)]; }
  bool keeps_spin(int i) const {
    return !spins.empty() && tps::keeps_spin(scene, scene.particles[at(i)].species);
  }
  Number radius(int i) const {
    return stored<Number>(scene.species[at(scene.particles[at(i)].species)].radius, precision);
  }
  bool tethered(int i, int j) const {
    const PairRules<Number>& pair = rules.of(i, j);
    return pair.can_tether && (pair.permanent || tethers[at(i)].count(j) != 0);
  }
  /// 1/m of the body that a particle belongs to.
  W inverse_mass(int i) const {
    const Body<Number>* body = groups.body(i);
    return body != nullptr ? body->inverse_mass : inverse_masses[at(i)];
  }
  /// Loads that made the body of a particle: each rounded its mass once.
  int loads(int i) const {
    const Body<Number>* body = groups.body(i);
    return body != nullptr ? body->loads : 0;
  }
  /// Where the surface of an event is in `walls`; nothing where the scene has no such one.
  std::optional<std::size_t> wall_of(const EventLine<Number>& event) const {
    for (std::size_t n = 0; n < walls.size(); ++n) {
      const Surface& surface = walls[n].surface;
      if (event.wall == static_cast<int>(surface.wall) && event.face == surface.face) return n;
    }
    return std::nullopt;
  }
  /// Who judges the events of a kind; null where the check does so itself, or nobody can.
  EffectRules<Number>* effect_of(Kind kind) const {
    if (!is_of_effect(kind)) return nullptr;
    for (const auto& effect : effects) {
      if (effect->effect() == row(kind).effect) return effect.get();
    }
    return nullptr;
  }
  std::vector<int> members(int i) const {
    if (fixed(i)) return {};
    const Body<Number>* body = groups.body(i);
    return body != nullptr ? body->members : std::vector<int>{i};
  }

  /// Where a particle is, to the working precision.
  Vec<W> position(int i, const Instant<Number>& t) const {
    const Flight<Number>& f = flight(i);
    const W dt = elapsed(f.since, t);
    return widened<W>(f.position) + dt * widened<W>(f.velocity);
  }

  /// Edges by which j has to be displaced to be nearest to i; nothing without a periodic box.
  Vec<Number> nearest_image(int i, int j, const Instant<Number>& t) const {
    using std::floor;
    Vec<Number> image;
    if (!edges) return image;
    const Vec<W> r = position(j, t) - position(i, t);
    for (std::size_t k = 0; k < 3; ++k) {
      if ((*edges)[k] != Number(0)) image[k] = Number(-floor(W(r[k] / W((*edges)[k]) + W(0.5))));
    }
    return image;
  }
  /// Of a periodic box. REQUIRES one.
  W shortest_edge() const {
    W shortest(0);
    for (std::size_t k = 0; k < 3; ++k) {
      const W edge((*edges)[k]);
      if (edge != W(0) && (shortest == W(0) || edge < shortest)) shortest = edge;
    }
    return shortest;
  }
  /// Whether a pair within L of each other may be nearer by another image once it has flown `way`. REQUIRES a
  /// box.
  bool images_are_open(const W& L, const W& way) const { return W(2) * (L + way) >= shortest_edge(); }
  /// What an image is displaced by.
  Vec<W> shift_of(const Vec<Number>& image) const {
    Vec<W> shift;
    for (std::size_t k = 0; edges && k < 3; ++k) shift[k] = W(image[k]) * W((*edges)[k]);
    return shift;
  }

  /// The size of what the clock of the trace's lines begins with, where a program has one number for it. The
  /// clock s of drag begins at 0.
  W start_of_clock() const {
    return scene.drag ? W(0) : W(scene.start_time < 0 ? -scene.start_time : scene.start_time);
  }

  /// How far a particle may be from its straight line by the event that is being judged, `asked`.
  ///
  /// A run that advances everybody at every event rounds x and v dt each time, and t as well: n (u |x| + u
  /// |t| |v|) + 2 u |v| (t − t₀) after n events, |x| at its ends, since the flight is straight.
  W blur(int i) const {
    const Flight<Number>& f = flight(i);
    const W known = f.drift > W(0) ? W(f.blur + f.drift * elapsed(f.since, asked)) : f.blur;
    if (!eager || fixed(i)) return known;
    const W n(events + 1 - std::min(f.events, events));
    const W speed = length(widened<W>(f.velocity));
    const W dt = elapsed(f.since, asked);
    const W farthest = std::max(length(widened<W>(f.position)), length(position(i, asked)));
    const W times = start_of_clock() + W(asked.hi);
    return known + W(2) * precision.u * (n * (farthest + times * speed) + speed * dt);
  }

  /// How far position(i, t) may be from where a run has a particle that it does not record there: blur, and
  /// the roundings of dt, v dt and u + v dt, which a run that advances everybody has made by then.
  W blur_of_place(int i, const Instant<Number>& t) const {
    const W before = blur(i);
    const Flight<Number>& f = flight(i);
    const Vec<W> step = elapsed(f.since, t) * widened<W>(f.velocity);
    if (eager || !(length(step) > W(0))) return before;
    return before + W(precision.u) * (W(2) * length(step) + length(widened<W>(f.position) + step));
  }

  /// Pairs that have responded at a limit and cannot be there again (semantics §1).
  bool responded(int i, int j, bool outer) const {
    return has_responded(i, j, outer) && has_responded(j, i, outer);
  }
  /// `speeds` are those of the two before it: what its roundings are of.
  void note_response(int i, int j, bool outer, const W& speeds) {
    if (!fixed(i)) responded_[at(i)][{j, outer}] = speeds;
    if (!fixed(j)) responded_[at(j)][{i, outer}] = speeds;
  }
  using Responses = SmallMap<std::pair<int, bool>, W>;  ///< by partner and whether at the outer limit
  const Responses& responses(int i) const { return responded_[at(i)]; }
  /// REQUIRES responded(i, j, outer), and not both of infinite mass.
  const W& speeds_before_response(int i, int j, bool outer) const {
    return fixed(i) ? *responded_[at(j)].find({i, outer}) : *responded_[at(i)].find({j, outer});
  }

  /// Begins a new flight. A fixed particle keeps its own.
  void set_flight(int i, const Vec<Number>& position, const Vec<Number>& velocity, const Instant<Number>& t,
                  const W& blur, const W& drift = W(0)) {
    if (fixed(i)) return;
    Flight<Number>& f = flights[at(i)];
    if (!(f.velocity == velocity)) responded_[at(i)].clear();
    f = {position, velocity, t, blur, events + 1, drift};
    flights_in_doubles_[at(i)] =
        in_doubles(position, velocity, t, static_cast<double>(blur), static_cast<double>(drift));
  }

  static std::size_t at(int n) { return static_cast<std::size_t>(n); }

 private:
  bool has_responded(int i, int j, bool outer) const {
    return fixed(i) || responded_[at(i)].find({j, outer}) != nullptr;
  }

  LargeVector<FlightInDoubles> flights_in_doubles_;
  std::vector<Responses> responded_;
};

template <typename Number>
Model<Number>::Model(const Scene& scene_in, const Precision<Number>& precision_in)
    : scene(scene_in),
      precision(precision_in),
      rules(scene_in, precision_in),
      walls(wall_models(scene_in, precision_in)),
      tethers(scene_in.particles.size()),
      groups(scene_in.particles.size()),
      responded_(scene_in.particles.size()) {
  const auto lifted = [&](const Coordinates& x) {
    return Vec<Number>{
        {stored<Number>(x[0], precision), stored<Number>(x[1], precision), stored<Number>(x[2], precision)}};
  };
  for (const Particle& p : scene.particles) {
    flights.push_back({lifted(p.position), lifted(p.velocity), {}, W(0)});
    flights_in_doubles_.push_back(in_doubles(flights.back().position, flights.back().velocity, {}));
    const double mass = scene.species[at(p.species)].mass;
    inverse_masses.push_back(std::isinf(mass) ? W(0) : W(1) / W(stored<Number>(mass, precision)));
  }
  const auto has_friction = [](const PairLaw& law) { return law.friction.has_value(); };
  if (std::any_of(scene.pairs.begin(), scene.pairs.end(), has_friction)) {
    for (std::size_t n = 0; n < scene.particles.size(); ++n) {
      const Coordinates spin = spin_of(scene, n);
      spins.push_back(lifted(scene.dimension == 2 ? Coordinates{0, 0, spin[0]} : spin));
    }
  }
  for (const Tether& tether : scene.tethers) {
    tethers[at(tether.i)].insert(tether.j);
    tethers[at(tether.j)].insert(tether.i);
  }
  if (scene.box) {
    edges.emplace();
    for (std::size_t k = 0; k < 3; ++k) {
      const double edge = scene.box->edges[k];
      (*edges)[k] = std::isinf(edge) ? Number(0) : stored<Number>(edge, precision);
    }
  }
}

}  // namespace tps::check

// The state of a run, and the few operations by which effects change it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reference/engine/clock.hpp"
#include "reference/engine/coupling.hpp"
#include "reference/engine/large_pages.hpp"
#include "reference/engine/laws.hpp"
#include "reference/engine/ledger.hpp"
#include "reference/engine/pair_timing.hpp"
#include "reference/engine/particle_state.hpp"
#include "reference/engine/periodic_box.hpp"
#include "reference/engine/queue.hpp"
#include "reference/engine/range.hpp"
#include "reference/engine/record.hpp"
#include "reference/engine/statistics.hpp"
#include "reference/engine/tethers.hpp"
#include "reference/equations/vector.hpp"
#include "reference/scene/random.hpp"
#include "reference/scene/scene.hpp"
#include "reference/scene/surfaces.hpp"

namespace tps {

/// Receives every record of a run, in order.
template <typename Scalar, int D>
using RecordSink = std::function<void(const Record<Scalar, D>&)>;

template <typename Scalar, int D>
class World {
 public:
  using Vec = Vector<Scalar, D>;

  World(const Scene& scene_in, const TimingChoice& timing_in);

  const Scene& scene;
  const PairTiming<Scalar, D> timing;
  Laws<Scalar> laws;
  Time<Scalar> now;
  Time<Scalar> last_event;
  std::uint64_t events = 0;
  LargeVector<ParticleState<Scalar, D>> particles;
  Tethers tethers;
  Responded responded;
  std::map<std::array<int, 3>, std::uint32_t> draws;  ///< (purpose, i, j) → random numbers used
  std::unique_ptr<Coupling<Scalar, D>> coupling;
  std::unique_ptr<PeriodicBox<Scalar, D>> box;  ///< null: space is unbounded
  EventQueue<Scalar> queue;
  Ledger<Scalar, D> ledger;
  Statistics<Scalar> statistics;
  RecordSink<Scalar, D> sink;

  int size() const { return static_cast<int>(particles.size()); }
  int species(int i) const { return tags_[index(i)].species; }
  /// Raised whenever predictions of a particle become void.
  std::uint32_t revision(int i) const { return tags_[index(i)].revision; }
  const Scalar& mass(int i) const { return masses_[index(species(i))]; }
  bool fixed(int i) const { return fixed_[index(species(i))] != 0; }
  const Vec& velocity(int i) const { return particles[index(i)].velocity; }
  /// The common velocity of infinite masses, else that of all walls; zero where there is none.
  const Vec& frame_velocity() const { return frame_velocity_; }
  const Law<Scalar>& law(int i, int j) const { return laws.of(species(i), species(j)); }
  bool tethered(int i, int j) const {
    const auto& tethering = law(i, j).tethering;
    return tethering && (tethering->permanent || tethers.contains(i, j));
  }

  /// u + v (t − clock): free flight. Two roundings a coordinate.
  Vec position(int i, const Time<Scalar>& t) const {
    const ParticleState<Scalar, D>& p = particles[index(i)];
    return p.clock == t ? p.position : p.after(elapsed(p.clock, t));
  }

  /// Two particles, i < j, the one with the earlier clock advanced to the later one's.
  PairView<Scalar, D> view(int i, int j) const {
    const Time<Scalar>& clock_i = particles[index(i)].clock;
    const Time<Scalar>& clock_j = particles[index(j)].clock;
    const Time<Scalar>& start = clock_i < clock_j ? clock_j : clock_i;
    return {i, j, start, position(i, start), position(j, start), velocity(i), velocity(j)};
  }

  /// The same in a periodic box, with the image of j that is nearest at time t. Throws OutOfRange where
  /// places are no longer known well enough.
  ImagedPairView<Scalar, D> imaged_view(int i, int j, const Time<Scalar>& t) const {
    ImagedPairView<Scalar, D> pair{view(i, j), {}, {}, {}};
    pair.stored_i = pair.u_i;
    pair.stored_j = pair.u_j;
    pair.image = pair.start == t ? nearest_image(i, j, pair.u_i, pair.u_j) : nearest_image(i, j, t);
    pair.u_i.setZero();
    pair.u_j = pair.image.difference(pair.stored_i, pair.stored_j);
    return pair;
  }
  /// REQUIRES box. Throws OutOfRange.
  PeriodicImage<Scalar, D> nearest_image(int i, int j, const Time<Scalar>& t) const {
    return nearest_image(i, j, position(i, t), position(j, t));
  }
  PeriodicImage<Scalar, D> nearest_image(int i, int j, const Vec& u_i, const Vec& u_j) const {
    if (!box->knows(u_i) || !box->knows(u_j)) lose_count(box->knows(u_i) ? j : i);
    return box->nearest(u_i, u_j);
  }
  [[noreturn]] void lose_count(int i) const {
    throw OutOfRange("the number of edges of the box that " + particle_name(scene, i) + " has crossed");
  }
  /// Two particles now, kept for the next who asks. Whoever puts in another state says so: forget_places().
  const PairPlaces<Scalar, D>& places(int i, int j) const {
    if (places_of_ == std::pair(i, j) && places_at_ == now) return places_;
    places_ = {position(i, now), position(j, now), {}};
    if (box) places_.image = nearest_image(i, j, places_.u_i, places_.u_j);
    places_of_ = {i, j};
    places_at_ = now;
    return places_;
  }
  void forget_places() { places_of_ = {-1, -1}; }

  /// Asks memory for what an event of a particle needs.
  void prefetch(int i) const {
    __builtin_prefetch(&particles[index(i)]);
    __builtin_prefetch(&tags_[index(i)]);
    tethers.prefetch(i);
    responded.prefetch(i);
  }

  /// Advances a particle's stored state to now. Infinite masses keep theirs: nothing ever changes it.
  void bring(int i);
  /// Gives a particle a velocity; pairs that had responded may do so again if it differs. REQUIRES bring(i).
  void set_velocity(int i, const Vec& velocity);
  /// Marks a particle's predictions as void; they are made again after the event.
  void touch(int i);
  /// The particles touched since the last call, ascending; valid until the next one.
  const std::vector<int>& take_touched();

  /// A record of an event of i and j now, with both brought to now.
  Record<Scalar, D> open_record(std::string_view kind, int i, int j);
  /// Adds a particle to a record, as it is before the event, and brings it to now.
  void involve(Record<Scalar, D>& record, int i);
  /// Completes a record with what came of it, and hands it to the sink. Throws OutOfRange.
  void close_record(Record<Scalar, D>& record);

  /// The next random number in [0, 1) for a purpose and a pair.
  double draw(Purpose purpose, int i, int j);

  /// An event of one or two particles, with their present revisions.
  PendingEvent<Scalar> pending(const Time<Scalar>& time, Rank rank, int first, int second, int detail,
                               int effect) const;
  bool is_live(const PendingEvent<Scalar>& event) const;

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

 private:
  /// What is asked of neighbours, side by side.
  struct Tag {
    int species;
    std::uint32_t revision;
  };
  LargeVector<Tag> tags_;
  std::vector<Scalar> masses_;  ///< by species
  std::vector<char> fixed_;     ///< by species
  Vec frame_velocity_ = Vec::Zero();
  std::vector<int> touched_, taken_;
  std::vector<char> is_touched_;
  mutable PairPlaces<Scalar, D> places_;  ///< of the pair that was last asked for
  mutable std::pair<int, int> places_of_{-1, -1};
  mutable Time<Scalar> places_at_;
};

template <typename Scalar, int D>
Vector<Scalar, D> lifted(const Coordinates& coordinates) {
  Vector<Scalar, D> vector;
  for (int k = 0; k < D; ++k) vector[k] = Scalar(coordinates[static_cast<std::size_t>(k)]);
  return vector;
}

inline std::vector<bool> infinite_masses(const Scene& scene) {
  std::vector<bool> fixed;
  for (const Particle& p : scene.particles) {
    const double mass = scene.species[static_cast<std::size_t>(p.species)].mass;
    fixed.push_back(mass == std::numeric_limits<double>::infinity());
  }
  return fixed;
}

template <typename Scalar, int D>
World<Scalar, D>::World(const Scene& scene_in, const TimingChoice& timing_in)
    : scene(scene_in),
      timing(timing_in),
      laws(scene_in),
      tethers(scene_in.particles.size()),
      responded(infinite_masses(scene_in)),
      is_touched_(scene_in.particles.size(), false) {
  if (const auto V = velocity_of_walls(scene)) frame_velocity_ = lifted<Scalar, D>(*V);
  for (const Species& species : scene.species) {
    masses_.push_back(Scalar(species.mass));
    fixed_.push_back(species.mass == std::numeric_limits<double>::infinity());
  }
  particles.reserve(scene.particles.size());
  tags_.reserve(scene.particles.size());
  for (const Particle& p : scene.particles) {
    particles.push_back({lifted<Scalar, D>(p.position), lifted<Scalar, D>(p.velocity), {}});
    tags_.push_back({p.species, 0});
    if (fixed_[index(p.species)]) frame_velocity_ = particles.back().velocity;
  }
  for (const Tether& tether : scene.tethers) tethers.add(tether.i, tether.j);
}

template <typename Scalar, int D>
void World<Scalar, D>::bring(int i) {
  if (fixed(i)) return;
  ParticleState<Scalar, D>& p = particles[index(i)];
  p.position = position(i, now);
  p.clock = now;
}

template <typename Scalar, int D>
void World<Scalar, D>::set_velocity(int i, const Vec& velocity) {
  if (fixed(i)) return;
  Vec& stored = particles[index(i)].velocity;
  // Also where nothing changed: a heavy particle may have rounded a whole impulse away.
  ledger.add_rounding(mass(i), stored, velocity, frame_velocity_);
  if (stored != velocity) responded.forget(i);
  stored = velocity;
}

template <typename Scalar, int D>
void World<Scalar, D>::touch(int i) {
  if (fixed(i) || is_touched_[index(i)]) return;
  is_touched_[index(i)] = true;
  touched_.push_back(i);
  ++tags_[index(i)].revision;
}

template <typename Scalar, int D>
const std::vector<int>& World<Scalar, D>::take_touched() {
  for (const int i : touched_) is_touched_[index(i)] = false;
  std::sort(touched_.begin(), touched_.end());
  taken_.swap(touched_);
  touched_.clear();
  return taken_;
}

template <typename Scalar, int D>
Record<Scalar, D> World<Scalar, D>::open_record(std::string_view kind, int i, int j) {
  Record<Scalar, D> record;
  record.kind = kind;
  record.i = i;
  record.j = j;
  record.involved.reserve(2);
  involve(record, i);
  if (j != i) involve(record, j);
  return record;
}

template <typename Scalar, int D>
void World<Scalar, D>::involve(Record<Scalar, D>& record, int i) {
  bring(i);
  touch(i);
  record.involved.push_back({i, position(i, now), velocity(i), velocity(i)});
}

template <typename Scalar, int D>
void World<Scalar, D>::close_record(Record<Scalar, D>& record) {
  for (ParticleChange<Scalar, D>& change : record.involved) change.velocity_after = velocity(change.particle);
  record.k = ++events;
  record.t = now;
  record.dt = elapsed(last_event, now);
  require_range<Scalar, D>(scene, record);
  require_range<Scalar, D>(ledger);
  last_event = now;
  statistics.count(record.kind);
  if (sink) sink(record);
}

template <typename Scalar, int D>
double World<Scalar, D>::draw(Purpose purpose, int i, int j) {
  const int first = scene.particles[index(std::min(i, j))].id;
  const int second = scene.particles[index(std::max(i, j))].id;
  std::uint32_t& used = draws[{static_cast<int>(purpose), first, second}];
  return uniform(scene.seed, purpose, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(second),
                 used++);
}

template <typename Scalar, int D>
PendingEvent<Scalar> World<Scalar, D>::pending(const Time<Scalar>& time, Rank rank, int first, int second,
                                               int detail, int effect) const {
  const auto present = [this](int i) { return i < 0 ? 0U : revision(i); };
  return {time, rank, first, second, detail, effect, present(first), present(second)};
}

template <typename Scalar, int D>
bool World<Scalar, D>::is_live(const PendingEvent<Scalar>& event) const {
  const auto unchanged = [this](int i, std::uint32_t then) { return i < 0 || revision(i) == then; };
  return unchanged(event.first, event.first_revision) && unchanged(event.second, event.second_revision);
}

}  // namespace tps

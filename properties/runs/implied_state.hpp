// The state that a trace implies, event by event: a small, obvious model of a run that shares no code with
// the engine.
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "properties/runs/judge.hpp"
#include "properties/runs/trace.hpp"
#include "reference/scene/scene.hpp"

namespace tps::properties::runs {

/// A particle that flies straight from where its velocity was last set.
struct Flight {
  Point position = Point::Zero(), velocity = Point::Zero();
  Instant clock;
};

/// One load of a group that has not been given back.
struct LoadedNode {
  int i, j;
  std::set<int> side_i, side_j;  ///< particles of the two bodies; empty for an infinite mass
  Real mass_i, mass_j;
  Point dp;         ///< Δp_AB of eq. (7) on the body of i
  Real speeds = 0;  ///< of i and j before the load

  std::set<int> particles() const;
  Real mass_of(int particle) const { return side_i.contains(particle) ? mass_i : mass_j; }
};

/// Particles that move as one, with the loads that made them so.
struct LoadedBody {
  std::set<int> members;
  int ground = -1;  ///< the infinite mass that it is grounded on; −1: none
  Instant last_load;
  std::vector<LoadedNode> nodes;
};

class ImpliedState {
 public:
  /// `scalar` as in a trace's header: masses and limits are the scene's, rounded to it.
  ImpliedState(const Scene& scene, const std::string& scalar);

  /// Takes over what an event says. Throws std::runtime_error where it names particles that the scene has
  /// not.
  void apply(const TracedEvent& event);

  int dimension() const { return scene_->dimension; }
  int size() const { return static_cast<int>(flights_.size()); }
  int index_of(std::int32_t id) const;
  std::int32_t id_of(int i) const { return scene_->particles[at(i)].id; }
  const Flight& flight(int i) const { return flights_[at(i)]; }
  Point position(int i, const Instant& t) const;
  Real mass(int i) const { return masses_[at(i)]; }
  bool is_fixed(int i) const;
  /// The pair's law, with tether rules as phases have them now; null where the two do not interact.
  const PairLaw* law(int i, int j) const;
  /// A number of the scene as the run's scalar holds it.
  Real stored(double x) const;
  /// An angle in degrees, which in float must not become 90.
  Real stored_angle(double degrees) const;

  bool tethered(int i, int j) const;
  /// Tethers that count towards a capacity.
  int tether_count(int i) const;

  const LoadedBody* body(int i) const;
  /// The live load of a pair; null where there is none.
  const LoadedNode* node(int i, int j) const;
  const std::vector<LoadedBody>& bodies() const { return bodies_; }
  /// Of the particle, or of the group that it belongs to; infinite where that is grounded.
  Real body_mass(int i) const;
  /// The particles that move with i, itself among them.
  std::set<int> with(int i) const;
  bool together(int i, int j) const;

  const Point& frame_velocity() const { return frame_velocity_; }

 private:
  static std::size_t at(int n) { return static_cast<std::size_t>(n); }
  static std::pair<int, int> ordered(int i, int j) { return {std::min(i, j), std::max(i, j)}; }
  void load(const TracedEvent& event, int i, int j);
  void part(const TracedEvent& event, int i, int j);
  void change_phase(const TracedEvent& event);

  const Scene* scene_;
  bool in_float_;
  std::vector<Flight> flights_;
  std::vector<Real> masses_;
  std::vector<PairLaw> laws_;
  std::vector<bool> active_phases_;
  std::set<std::pair<int, int>> tethers_;
  std::vector<LoadedBody> bodies_;
  Point frame_velocity_ = Point::Zero();
};

/// μ without a division by infinity.
Real reduced(Real mass_i, Real mass_j);

}  // namespace tps::properties::runs

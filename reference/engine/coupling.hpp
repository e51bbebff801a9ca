// How colliding particles pass an impulse on: each for itself (eq. 3), or as bodies that are grouped for a
// while (eqs. 6-7, effects/grouping.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "reference/engine/range.hpp"
#include "reference/engine/record.hpp"
#include "reference/engine/tethers.hpp"
#include "reference/equations/collision_frame.hpp"
#include "reference/equations/directed_rounding.hpp"
#include "reference/equations/eq3_apply_impulse.hpp"

namespace tps {

template <typename Scalar, int D>
class World;

/// A collision between the bodies of two particles, before it is answered.
template <typename Scalar, int D>
struct Collision {
  int i, j;  ///< i < j
  Limit limit;
  CollisionFrame<Scalar, D> frame;  ///< from the positions of i and j and the velocities of their bodies
  Scalar mass_i, mass_j;            ///< of the bodies
  Vector<Scalar, D> dp;             ///< by eq. (4) or (5)
  Scalar loss;                      ///< of energy, by eq. (4) or (5)
};

/// ½ Σ I ω².
template <typename Scalar>
struct SpinEnergies {
  Scalar at_start, now;
};

/// Those that are not restituted yet.
template <typename Scalar>
struct LiveGroups {
  std::uint64_t count = 0;
  Scalar oldest{};  ///< since its first load
};

template <typename Scalar, int D>
class Coupling {
 public:
  virtual ~Coupling() = default;
  Coupling(const Coupling&) = delete;
  Coupling& operator=(const Coupling&) = delete;
  /// Whether two particles move as one: then they have no events with each other.
  bool together(int i, int j) const { return makes_bodies_ && share_body(i, j); }
  /// Mass of the body that a particle belongs to.
  Scalar body_mass(const World<Scalar, D>& world, int i) const {
    return makes_bodies_ ? mass_of_body(world, i) : world.mass(i);
  }
  /// Answers a collision: takes its loss to the ledger, changes velocities and completes its record, which is
  /// still open.
  virtual void collide(World<Scalar, D>& world, const Collision<Scalar, D>& collision,
                       Record<Scalar, D>& record) = 0;
  /// The same of a rebound that is no collision of two particles.
  virtual void lose(World<Scalar, D>& world, const Scalar& loss) { world.ledger.lost += loss; }
  /// What velocities and impulses of the run have to be multiplied with to be the scene's at time t.
  virtual Scalar velocity_unit(const Time<Scalar>& /*t*/) const { return Scalar(1); }

  // For the summary of a run that ends at `end`, which is not before the last event:
  /// The energy of the scene that collisions have cost, and what else has taken some between them.
  virtual Scalar lost(const World<Scalar, D>& world) const { return world.ledger.lost.value(); }
  virtual Scalar taken(const World<Scalar, D>&, const Time<Scalar>& /*end*/) const { return Scalar(0); }
  /// Nothing where no particle keeps a spin.
  virtual std::optional<SpinEnergies<Scalar>> spin_energies(const World<Scalar, D>&) const {
    return std::nullopt;
  }
  virtual LiveGroups<Scalar> live_groups(const Time<Scalar>& /*end*/) const { return {}; }
  /// An impulse from outside on a particle, which acts on its whole body.
  virtual void push(World<Scalar, D>& world, int i, const Vector<Scalar, D>& impulse,
                    Record<Scalar, D>& record) = 0;

 protected:
  enum class Bodies { single, of_several };
  explicit Coupling(Bodies bodies) : makes_bodies_(bodies == Bodies::of_several) {}

 private:
  // Asked of couplings with bodies of several particles alone: every pair is asked whether it moves as one,
  // and where nobody does the answer is no call.
  virtual bool share_body(int /*i*/, int /*j*/) const { return false; }
  virtual Scalar mass_of_body(const World<Scalar, D>& world, int i) const { return world.mass(i); }

  const bool makes_bodies_;
};

/// Throws OutOfRange where two particles are at one place, which has no axis.
template <typename Scalar, int D>
void require_apart(const World<Scalar, D>& world, int i, int j) {
  const PairPlaces<Scalar, D> places = world.places(i, j);
  if (places.from() != places.to()) return;
  throw OutOfRange("the distance of " + pair_name(world.scene, i, j) + ", which rounding puts at one point,");
}

/// require_normal_impulse for both bodies of a pair.
template <typename Scalar, int D>
void require_normal_impulses(const World<Scalar, D>& world, int i, int j, const Vector<Scalar, D>& dp,
                             const Scalar& mass_i, const Scalar& mass_j) {
  require_normal_impulse<Scalar, D>(world.scene, i, dp, mass_i, world.velocity(i));
  require_normal_impulse<Scalar, D>(world.scene, j, dp, mass_j, world.velocity(j));
}

/// The velocities of two bodies after their response, rounded so that their particles i and j leave each
/// other the right way (D22). What that changes enters the ledger's bounds. Out of line wherever it is used,
/// so that a run without groups does not pay for those who group (docs/performance.md).
template <typename Scalar, int D>
[[gnu::noinline]] PairVelocities<Scalar, D> directed_response(World<Scalar, D>& world, int i, int j,
                                                              Limit limit, const Scalar& mass_i,
                                                              const Scalar& mass_j,
                                                              const PairVelocities<Scalar, D>& v) {
  const Leaving leaving = limit == Limit::inner ? Leaving::apart : Leaving::together;
  const PairPlaces<Scalar, D> places = world.places(i, j);
  const PairVelocities<Scalar, D> result =
      directed<Scalar, D>(places.u_i, places.u_j, mass_i, mass_j, v, leaving, places.exact());
  if (result.v_A != v.v_A) world.ledger.add_change(mass_i, v.v_A, result.v_A, world.frame_velocity());
  if (result.v_B != v.v_B) world.ledger.add_change(mass_j, v.v_B, result.v_B, world.frame_velocity());
  return result;
}

/// Every particle is its own body; eq. (3) acts at once.
template <typename Scalar, int D>
class FreeCoupling : public Coupling<Scalar, D> {
 public:
  FreeCoupling() : Coupling<Scalar, D>(Coupling<Scalar, D>::Bodies::single) {}

  void collide(World<Scalar, D>& world, const Collision<Scalar, D>& c, Record<Scalar, D>&) override {
    world.ledger.lost += c.loss;
    require_normal_impulses<Scalar, D>(world, c.i, c.j, c.dp, c.mass_i, c.mass_j);
    const PairVelocities<Scalar, D> v =
        apply_impulse<Scalar, D>(c.mass_i, c.mass_j, world.velocity(c.i), world.velocity(c.j), c.dp);
    const PairVelocities<Scalar, D> directed =
        directed_response<Scalar, D>(world, c.i, c.j, c.limit, c.mass_i, c.mass_j, v);
    world.set_velocity(c.i, directed.v_A);
    world.set_velocity(c.j, directed.v_B);
    if (world.fixed(c.j)) world.ledger.add_from_walls(c.dp);
    if (world.fixed(c.i)) world.ledger.add_from_walls(Vector<Scalar, D>(-c.dp));
  }

  void push(World<Scalar, D>& world, int i, const Vector<Scalar, D>& impulse, Record<Scalar, D>&) override {
    require_normal_impulse<Scalar, D>(world.scene, i, impulse, world.mass(i), world.velocity(i));
    world.set_velocity(i, world.velocity(i) + impulse / world.mass(i));
  }
};

}  // namespace tps

// Walls: planes, in- and outsides of spheres and boxes. A particle that touches one rebounds by eq. (4) with
// an infinite mass.
//
// Laws: (1) afterwards v_n' = −c v_n relative to the wall, exactly with the right sign (D25), and the rest of
// the velocity is kept; (2) a wall needs no memory of who has responded; (3) without walls there is no state,
// no event and no field of them.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "reference/engine/effect.hpp"
#include "reference/engine/effect_records.hpp"
#include "reference/engine/response.hpp"
#include "reference/engine/wall_surface.hpp"
#include "reference/equations/eq4_collision_impulse.hpp"
#include "reference/scene/surfaces.hpp"

namespace tps::effects {

template <typename Scalar, int D>
class WallRebounds final : public Effect<Scalar, D> {
 public:
  using Vec = Vector<Scalar, D>;
  std::string_view name() const override { return "walls"; }

  explicit WallRebounds(const Scene& scene) : Effect<Scalar, D>({"work", "lost"}) {
    for (const Surface& surface : surfaces(scene)) walls_.emplace_back(surface, scene);
  }

  void begin(World<Scalar, D>&, int self) override { self_ = self; }

  void queue_known(World<Scalar, D>& world) override {
    for (int i = 0; i < world.size(); ++i) predict(world, i);
  }
  void refresh(World<Scalar, D>& world, const std::vector<int>& touched) override {
    for (const int i : touched) predict(world, i);
  }

  Moment moment(const World<Scalar, D>& world, const PendingEvent<Scalar>& event) const override {
    return wall(event.detail).moment(world, event.first);
  }

  void respond(World<Scalar, D>& world, const PendingEvent<Scalar>& event) override {
    const int i = event.first;
    const WallSurface<Scalar, D>& met = wall(event.detail);
    Record<Scalar, D> record = world.open_record("wall", i, i);
    met_.wall = met.surface().wall;
    met_.face = met.surface().face;
    record.addition = &met_;
    const auto [u_A, u_B] = met.axis(world, i);
    if (u_A == u_B)
      throw OutOfRange("the distance of " + met.with(world, i) + ", which rounding puts at one point,");
    const CollisionFrame<Scalar, D> frame =
        collision_frame<Scalar, D>(u_A, u_B, world.velocity(i), met.velocity());
    observe(world, i, met, frame);
    Vec dp = Vec::Zero();
    if (met.leaves(world, i)) {
      ++world.statistics.zero_impulse;
    } else {
      if (met.is_inside() ? frame.v_n > Scalar(0) : frame.v_n < Scalar(0)) dp = impulse(world, i, met, frame);
      push(world, i, met, u_A, u_B, dp);
    }
    record.dp = dp;
    world.close_record(record);
  }

 private:
  const WallSurface<Scalar, D>& wall(int n) const { return walls_[static_cast<std::size_t>(n)]; }

  /// The first wall that a particle meets; where exact order decides, all of them.
  void predict(World<Scalar, D>& world, int i) {
    if (world.fixed(i)) return;
    std::optional<PendingEvent<Scalar>> first;
    for (std::size_t n = 0; n < walls_.size(); ++n) {
      const std::optional<Time<Scalar>> t = walls_[n].next(world, i);
      if (!t) continue;
      const PendingEvent<Scalar> event = world.pending(*t, Rank::wall, i, i, static_cast<int>(n), self_);
      if (world.timing.certified()) {
        world.queue.push(event);
      } else if (!first || event < *first) {
        first = event;
      }
    }
    if (first) world.queue.push(*first);
  }

  /// Δp of eq. (4) on the particle, and what it costs. Throws OutOfRange where it underflows.
  Vec impulse(World<Scalar, D>& world, int i, const WallSurface<Scalar, D>& met,
              const CollisionFrame<Scalar, D>& frame) {
    const Scalar infinite = std::numeric_limits<Scalar>::infinity();
    const Vec dp = collision_impulse<Scalar, D>(frame, world.mass(i), infinite, met.c_rebound());
    if (dp == Vec::Zero())
      throw OutOfRange("the impulse between " + met.with(world, i) + ", which underflows,");
    require_normal_impulse<Scalar, D>(world.scene, i, dp, world.mass(i), world.velocity(i));
    const Scalar c = met.c_rebound();
    const Scalar loss = world.mass(i) / Scalar(2) * (Scalar(1) - c * c) * frame.v_n * frame.v_n;
    world.coupling->lose(world, loss);
    const Scalar unit = world.coupling->velocity_unit(world.now);  // speeds of the run to those of the scene
    this->add_energy(1, loss * unit * unit);
    return dp;
  }

  /// Eq. (3), rounded so that the particle leaves the wall the right way (D22).
  void push(World<Scalar, D>& world, int i, const WallSurface<Scalar, D>& met, const Vec& u_A, const Vec& u_B,
            const Vec& dp) {
    const Scalar infinite = std::numeric_limits<Scalar>::infinity();
    const Leaving leaving = met.is_inside() ? Leaving::together : Leaving::apart;
    const PairVelocities<Scalar, D> v =
        apply_impulse<Scalar, D>(world.mass(i), infinite, world.velocity(i), met.velocity(), dp);
    const PairVelocities<Scalar, D> after =
        directed<Scalar, D>(u_A, u_B, world.mass(i), infinite, v, leaving);
    if (after.v_A != v.v_A) world.ledger.add_change(world.mass(i), v.v_A, after.v_A, world.frame_velocity());
    world.set_velocity(i, after.v_A);
    world.ledger.add_from_walls(dp);
    // In its own frame a wall does no work; in that of the ledger one that moves does.
    const Vec V = met.velocity() - world.frame_velocity();
    if (V == Vec::Zero()) return;
    const Scalar work = dp.dot(V);
    world.ledger.work += work;
    this->add_energy(0, work);
  }

  void observe(World<Scalar, D>& world, int i, const WallSurface<Scalar, D>& met,
               const CollisionFrame<Scalar, D>& frame) const {
    Statistics<Scalar>& s = world.statistics;
    const Scalar beyond = met.beyond(world, i, world.now);
    Scalar& worst = met.is_inside() ? s.worst_outer_excess : s.worst_inner_excess;
    worst = std::max(worst, beyond);
    if (!met.is_inside() && met.below_rounding(world, i, frame) && s.noise++ == 0)
      s.first_noise = world.events + 1;
  }

  std::vector<WallSurface<Scalar, D>> walls_;
  Addition<Scalar, D> met_;
  int self_ = 0;
};

struct walls {
  static EffectCall call(const Scene& scene) {
    EffectCall call{"walls",
                    "particles rebound from planes, spheres and boxes of infinite mass, eqs. 3-4",
                    {},
                    "\"walls\"",
                    {}};
    for (std::size_t n = 0; n < scene.walls.size(); ++n) {
      constexpr const char* names[] = {"plane", "sphere", "box"};
      const Wall& wall = scene.walls[n];
      const char* side = wall.shape == Wall::Shape::plane ? ""
                         : wall.inside                    ? "inside of a "
                                                          : "outside of a ";
      call.because.push_back(
          {"wall " + std::to_string(n) + " (" + side + names[static_cast<std::size_t>(wall.shape)] + ")",
           "/walls/" + std::to_string(n)});
    }
    const auto moves = [&](const Particle& p) {
      return scene.species[static_cast<std::size_t>(p.species)].mass <
             std::numeric_limits<double>::infinity();
    };
    call.cost = std::to_string(surfaces(scene).size()) + " surfaces, of which " +
                std::to_string(std::count_if(scene.particles.begin(), scene.particles.end(), moves)) +
                " particles ask when they meet the first, at each of their events";
    return call;
  }
  static EffectRecords records(const Scene&) {
    return {.kinds = {{"wall", About::particle, {"wall"}}}, .quantities = {{"walls_lost"}, {"walls_work"}}};
  }
  template <typename Scalar, int D>
  static std::unique_ptr<Effect<Scalar, D>> make(const Scene& scene) {
    return std::make_unique<WallRebounds<Scalar, D>>(scene);
  }
};

}  // namespace tps::effects

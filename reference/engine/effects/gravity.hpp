// Gravity as a sequence of impulses: at 0, δ, 2δ, … every body of finite mass gets the velocity gδ, at 0 half
// of it.
//
// Laws: (1) at kick times, before the kick, a free particle is where the parabola u + v t + ½ g t² has it
// and, as half of the kick is still to come, moves with v + g t − ½ g δ; (2) all bodies get the same change
// of velocity, bit for bit, so that the relative motion of what moves alike is kept; (3) its work is m g·Δu
// between kick times.
#pragma once

#include <limits>

#include "reference/engine/effect.hpp"
#include "reference/engine/effect_records.hpp"
#include "reference/engine/world.hpp"
#include "reference/equations/dyadic.hpp"

namespace tps::effects {

template <typename Scalar, int D>
class GravityKicks final : public Effect<Scalar, D> {
 public:
  std::string_view name() const override { return "gravity"; }

  explicit GravityKicks(const Gravity& gravity) : Effect<Scalar, D>({"work"}), gravity_(gravity) {}

  void begin(World<Scalar, D>&, int self) override { self_ = self; }
  void queue_known(World<Scalar, D>& world) override { queue_next(world); }

  /// One event for everybody: nobody is listed, since nobody is an exception.
  void respond(World<Scalar, D>& world, const PendingEvent<Scalar>&) override {
    const Vector<Scalar, D> whole = lifted<Scalar, D>(gravity_.acceleration) * Scalar(gravity_.every);
    const Vector<Scalar, D> change = done_ == 0 ? Vector<Scalar, D>(whole / Scalar(2)) : whole;
    ++done_;
    for (int i = 0; i < world.size(); ++i) {
      if (!world.fixed(i)) kick(world, i, change);
    }
    Record<Scalar, D> record;
    record.kind = "gravity";
    addition_.dv = change;
    record.addition = &addition_;
    world.close_record(record);
    queue_next(world);
  }

  std::uint64_t progress() const override { return done_; }
  void resume(World<Scalar, D>&, std::uint64_t progress) override { done_ = progress; }

 private:
  static constexpr Rank kRank{30};
  /// The correctly rounded sum, also in scalars of software, whose subtraction errs by up to 0.75 ulp: the
  /// velocity is in no line of the trace, and whoever reads it has to get the same.
  static Scalar sum(const Scalar& x, const Scalar& y) {
    if constexpr (std::is_floating_point_v<Scalar>) {
      return x + y;
    } else {
      return is_finite(x + y) ? nearest<Scalar>(dyadic(x) + dyadic(y)) : x + y;
    }
  }

  /// A body that is grounded on an infinite mass passes its share on.
  void kick(World<Scalar, D>& world, int i, const Vector<Scalar, D>& change) {
    const Vector<Scalar, D> J = world.mass(i) * change;
    world.ledger.add_from_outside(J);
    world.bring(i);
    world.touch(i);
    if (world.coupling->body_mass(world, i) == std::numeric_limits<Scalar>::infinity()) {
      world.ledger.add_from_walls(Vector<Scalar, D>(-J));
      return;
    }
    const Vector<Scalar, D> v = world.velocity(i) - world.frame_velocity();
    const Scalar work = J.dot(v) + J.dot(change) / Scalar(2);
    world.ledger.work += work;
    this->add_energy(0, work);
    Vector<Scalar, D> after = world.velocity(i);
    for (int k = 0; k < D; ++k) after[k] = sum(after[k], change[k]);
    if (!is_finite<Scalar, D>(after))
      throw OutOfRange("the velocity of " + particle_name(world.scene, i) + " after gravity");
    world.set_velocity(i, after);
  }

  void queue_next(World<Scalar, D>& world) {
    const Scalar t = Scalar(static_cast<double>(done_) * gravity_.every);
    world.queue.push(world.pending({t, Scalar(0)}, kRank, -1, -1, 0, self_));
  }

  Gravity gravity_;
  Addition<Scalar, D> addition_;
  std::uint64_t done_ = 0;
  int self_ = 0;
};

struct gravity {
  static EffectCall call(const Scene& scene) {
    EffectCall call{"gravity", "impulses m g δ on every finite mass, every δ", {}, "\"gravity\"", {}};
    if (scene.gravity) call.because.push_back(key_of_scene("gravity"));
    call.cost = "an event every δ, which predicts every pair again";
    return call;
  }
  static EffectRecords records(const Scene& scene) {
    constexpr std::uint64_t kNoEnd = std::numeric_limits<std::uint64_t>::max();
    return {.kinds = {{"gravity", About::everybody, {"dv"}}},
            .known = {{scene.gravity ? kNoEnd : 0, "is more than the events of the run"}},
            .quantities = {{"gravity_work"}}};
  }
  template <typename Scalar, int D>
  static std::unique_ptr<Effect<Scalar, D>> make(const Scene& scene) {
    return std::make_unique<GravityKicks<Scalar, D>>(scene.gravity.value());
  }
};

}  // namespace tps::effects

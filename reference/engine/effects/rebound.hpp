// Rebound: two approaching particles at their inner limit, eqs. (3) and (4); a tether may form (semantics
// §3).
#pragma once

#include <memory>

#include "reference/engine/effect.hpp"
#include "reference/engine/effect_records.hpp"
#include "reference/engine/response.hpp"
#include "reference/equations/eq4_collision_impulse.hpp"

namespace tps::effects {

template <typename Scalar, int D>
class Rebound final : public Effect<Scalar, D> {
 public:
  std::string_view name() const override { return "rebound"; }
  bool predicts_pairs() const override { return true; }

  std::optional<LimitQuestion<Scalar>> asks(const World<Scalar, D>& world, int i, int j) const override {
    const auto& blocking = world.law(i, j).blocking;
    if (!blocking) return std::nullopt;
    const bool has_responded = world.responded.contains(i, j, Limit::inner);
    if (has_responded && !world.box) return std::nullopt;
    return LimitQuestion<Scalar>{TimingKind::block, blocking->distance, has_responded};
  }

  void respond(World<Scalar, D>& world, const PendingEvent<Scalar>& event) override {
    const int i = event.first;
    const int j = event.second;
    const auto& blocking = *world.law(i, j).blocking;
    Record<Scalar, D> record = world.open_record("rebound", i, j);
    Collision<Scalar, D> collision = collision_now(world, i, j, Limit::inner);
    observe_collision(world, collision, blocking.distance);
    // Exactly: a pair that approaches by less than v_n resolves is turned, if only by directed rounding.
    const PairPlaces<Scalar, D> places = world.places(i, j);
    const bool approaching = normal_sign<Scalar, D>(places.u_i, places.u_j, world.velocity(i),
                                                    world.velocity(j), places.exact()) < 0;
    const Scalar c = blocking.c_rebound;
    if (approaching && collision.frame.v_n < Scalar(0)) {
      collision.dp = collision_impulse<Scalar, D>(collision.frame, collision.mass_i, collision.mass_j, c);
    }
    form_tether(world, i, j, record);
    const Scalar mu = reduced_mass<Scalar>(collision.mass_i, collision.mass_j);
    collision.loss = mu / Scalar(2) * (Scalar(1) - c * c) * collision.frame.v_n * collision.frame.v_n;
    answer(world, collision, approaching, record);
    world.close_record(record);
  }

 private:
  static bool has_room(const World<Scalar, D>& world, int i) {
    const auto& capacity = world.scene.species[World<Scalar, D>::index(world.species(i))].max_tethers;
    return !capacity || world.tethers.count(i) < static_cast<std::size_t>(*capacity);
  }

  /// A full particle forms nothing and consumes no draw.
  static void form_tether(World<Scalar, D>& world, int i, int j, Record<Scalar, D>& record) {
    const auto& tethering = world.law(i, j).tethering;
    if (!tethering || tethering->permanent || tethering->form.when == FormRule::When::never) return;
    if (world.tethers.contains(i, j) || !has_room(world, i) || !has_room(world, j)) return;
    if (tethering->form.when == FormRule::When::probability) {
      record.draw = world.draw(Purpose::tether_form, i, j);
      if (*record.draw >= tethering->form.probability) return;
    }
    world.tethers.add(i, j);
    record.tether = TetherChange::formed;
  }
};

struct rebound {
  static EffectCall call(const Scene& scene) {
    EffectCall call{
        "rebound", "approaching particles block each other, eqs. 3-4", {}, "a pair with \"blocking\"", {}};
    for (const PairLaw& pair : scene.pairs) {
      if (pair.blocking) call.because.push_back(between(scene, pair));
    }
    call.cost =
        std::to_string(interacting_pairs(scene, [](const PairLaw& p) { return p.blocking.has_value(); })) +
        " pairs with a blocking time";
    return call;
  }
  static EffectRecords records(const Scene&) { return {.kinds = {{"rebound", About::pair}}}; }
  template <typename Scalar, int D>
  static std::unique_ptr<Effect<Scalar, D>> make(const Scene&) {
    return std::make_unique<Rebound<Scalar, D>>();
  }
};

}  // namespace tps::effects

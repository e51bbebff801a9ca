// Tethering: two separating tethered particles at their outer limit are retracted, eqs. (3) and (4), or
// revolve, eq. (5); the tether may break instead (semantics §3).
#pragma once

#include <cmath>
#include <memory>
#include <optional>

#include "reference/engine/effect.hpp"
#include "reference/engine/effect_records.hpp"
#include "reference/engine/response.hpp"
#include "reference/equations/tether_response.hpp"
#include "reference/equations/weighted_square.hpp"

namespace tps::effects {

template <typename Scalar, int D>
class Tethering final : public Effect<Scalar, D> {
 public:
  std::string_view name() const override { return "tethering"; }
  bool predicts_pairs() const override { return true; }

  std::optional<LimitQuestion<Scalar>> asks(const World<Scalar, D>& world, int i, int j) const override {
    if (!world.tethered(i, j)) return std::nullopt;
    return LimitQuestion<Scalar>{TimingKind::tether, world.law(i, j).tethering->distance,
                                 world.responded.contains(i, j, Limit::outer)};
  }

  void respond(World<Scalar, D>& world, const PendingEvent<Scalar>& event) override {
    const int i = event.first;
    const int j = event.second;
    const auto& law = *world.law(i, j).tethering;
    Record<Scalar, D> record = world.open_record("retract", i, j);
    Collision<Scalar, D> collision = collision_now(world, i, j, Limit::outer);
    observe_collision(world, collision, law.distance);
    const std::optional<TetherResponse<Scalar, D>> pulled = response_of(collision, law);
    if (pulled) {
      collision.dp = pulled->dp;
      collision.loss = energy_lost(collision, law, pulled->kind);
      if (pulled->kind == TetherResponseKind::revolve) record.kind = "revolve";
    }
    if (breaks(world, law, collision, record)) {
      record.kind = "break";
      record.tether = TetherChange::broken;
      world.tethers.remove(i, j);
    } else {
      answer(world, collision, pulled.has_value(), record);
    }
    world.close_record(record);
  }

 private:
  using TetheringOfPair = typename Law<Scalar>::Tethering;

  /// The response of a collision; nothing (Δp = 0) where there is no tangential motion and v_n has the wrong
  /// sign.
  ///
  /// Real arithmetic has v_n ≥ 0 here. v_n < 0 is the rounding of a perpendicular pair, which eq. (5) answers
  /// whatever the sign of v_n. With Δp = 0 instead, such a pair stalls (at c = 0 its next `hit` is so near
  /// that no coordinate moves) or, where its path misses the inside, is never pulled again and leaves.
  static std::optional<TetherResponse<Scalar, D>> response_of(const Collision<Scalar, D>& c,
                                                              const TetheringOfPair& law) {
    if (c.frame.v_n >= Scalar(0)) {
      return tether_response<Scalar, D>(c.frame, c.mass_i, c.mass_j, law.c_retract, law.c_revolve,
                                        law.theta_revolve_deg);
    }
    if ((c.frame.v_w.array() == Scalar(0)).all()) return std::nullopt;
    return TetherResponse<Scalar, D>{
        TetherResponseKind::revolve,
        revolution_impulse<Scalar, D>(c.frame, c.mass_i, c.mass_j, law.c_revolve, law.theta_revolve_deg)};
  }

  /// By eq. (4): ½ μ (1 − c²) v_n²; by eq. (5): ½ μ (1 − c^(2θ/π)) |v_AB|².
  static Scalar energy_lost(const Collision<Scalar, D>& c, const TetheringOfPair& law,
                            TetherResponseKind kind) {
    using std::pow;
    const Scalar half_mu = reduced_mass<Scalar>(c.mass_i, c.mass_j) / Scalar(2);
    if (kind == TetherResponseKind::retract) {
      return half_mu * (Scalar(1) - law.c_retract * law.c_retract) * c.frame.v_n * c.frame.v_n;
    }
    const Scalar kept = pow(law.c_revolve, Scalar(law.theta_revolve_deg / Scalar(90)));
    return weighted_square<Scalar, D>(half_mu * (Scalar(1) - kept), c.frame.v_AB);
  }

  static bool breaks(World<Scalar, D>& world, const TetheringOfPair& law, const Collision<Scalar, D>& c,
                     Record<Scalar, D>& record) {
    switch (law.breaks.when) {
      case BreakRule::When::never:
        return false;
      case BreakRule::When::always:
        return true;
      case BreakRule::When::probability:
        record.draw = world.draw(Purpose::tether_break, c.i, c.j);
        return *record.draw < law.breaks.probability;
      case BreakRule::When::impulse_above:
        return norm<Scalar, D>(c.dp) * world.coupling->velocity_unit(world.now) >
               Scalar(law.breaks.threshold);
    }
    return false;
  }
};

struct tethering {
  static EffectCall call(const Scene& scene) {
    EffectCall call{"tethering",
                    "tethered particles are retracted or revolve, eqs. 3-5",
                    {},
                    "a pair with \"tethering\"",
                    {}};
    for (const PairLaw& pair : scene.pairs) {
      if (pair.tethering) call.because.push_back(between(scene, pair));
    }
    const auto permanent = [](const PairLaw& p) {
      return p.tethering && p.tethering->form.when == FormRule::When::permanent;
    };
    call.cost = std::to_string(interacting_pairs(scene, permanent)) + " pairs tethered for ever, " +
                std::to_string(scene.tethers.size()) + " at the start; others as they form";
    return call;
  }
  static EffectRecords records(const Scene&) {
    return {.kinds = {{"retract", About::pair}, {"revolve", About::pair}, {"break", About::pair}}};
  }
  template <typename Scalar, int D>
  static std::unique_ptr<Effect<Scalar, D>> make(const Scene&) {
    return std::make_unique<Tethering<Scalar, D>>();
  }
};

}  // namespace tps::effects

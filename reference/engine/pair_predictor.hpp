// The next event of one pair. Every detector asks it, so that they differ in whom they ask and in nothing
// else.
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "reference/engine/effect.hpp"
#include "reference/engine/miss_filter.hpp"
#include "reference/engine/world.hpp"

namespace tps {

template <typename Scalar, int D>
class PairPredictor {
 public:
  using Effects = std::vector<std::unique_ptr<Effect<Scalar, D>>>;

  static constexpr int kUnasked = -1;  ///< in the place of an effect

  /// The effects must outlive it.
  explicit PairPredictor(const Effects& effects) {
    for (std::size_t n = 0; n < effects.size(); ++n) {
      if (effects[n]->predicts_pairs()) predictors_.push_back({effects[n].get(), static_cast<int>(n)});
    }
  }

  /// The earliest event of a pair, i < j. Its time is a function of the two stored states alone: the later of
  /// the two clocks, to which the other particle is advanced, plus the answer of eq. (2). A time beyond the
  /// range of the scalar is never(): there is an event, which no clock reaches. Throws OutOfRange.
  /// In a periodic box it is the event with the image that is nearest at time `t`: a function of the stored
  /// states and the image.
  std::optional<PendingEvent<Scalar>> earliest(const World<Scalar, D>& world, int i, int j,
                                               const Time<Scalar>& t) const {
    if (!can_meet(world, i, j)) return std::nullopt;
    if (world.box) return earliest(world, world.imaged_view(i, j, t));
    return earliest(world, world.view(i, j));
  }

  /// One particle, i, whose pairs are asked for at one time t, whoever the others are. Most are asked in
  /// vain: what it takes to say so is computed once. Valid while no state changes.
  class Asker {
   public:
    Asker(const PairPredictor& predictor, const World<Scalar, D>& world, int i, const Time<Scalar>& t)
        : predictor_(predictor),
          world_(world),
          i_(i),
          t_(t),
          filter_(world.particles[world.index(i)], t, world.box.get()),
          tethered_(world.tethers.of(i)) {}

    /// The earliest event of the pair of i and j ≠ i: the answer of PairPredictor::earliest().
    std::optional<PendingEvent<Scalar>> earliest(int j) const {
      if (glance(j).misses) return std::nullopt;
      return asked(j);
    }

    /// The same; or, with `kUnasked` in the place of its effect, a time before which it has none, which takes
    /// less than to know its event. Most events never come: before they are due, one of the two is touched.
    std::optional<PendingEvent<Scalar>> foreseen(int j) const {
      const auto [misses, not_before] = glance(j);
      if (misses) return std::nullopt;
      if (!(not_before > Scalar(0))) return asked(j);
      return world_.pending(after(t_, not_before), Rank::collision, std::min(i_, j), std::max(i_, j), 0,
                            kUnasked);
    }

   private:
    std::optional<PendingEvent<Scalar>> asked(int j) const {
      return predictor_.earliest(world_, std::min(i_, j), std::max(i_, j), t_);
    }

    /// What the filter says of a pair. One that has no tether has one limit.
    Foresight<Scalar> glance(int j) const {
      const Law<Scalar>& law = world_.law(i_, j);
      if (!law.blocking || world_.timing.literal()) return {false, Scalar(0)};
      if (law.tethering && (law.tethering->permanent || is_tethered_to(j))) return {false, Scalar(0)};
      return filter_.foresee(world_.particles[world_.index(j)], law.blocking->distance);
    }
    bool is_tethered_to(int j) const {
      return std::find(tethered_.begin(), tethered_.end(), j) != tethered_.end();
    }

    const PairPredictor& predictor_;
    const World<Scalar, D>& world_;
    int i_;
    Time<Scalar> t_;
    MissFilter<Scalar, D> filter_;
    const std::vector<int>& tethered_;
  };

  Asker asker(const World<Scalar, D>& world, int i, const Time<Scalar>& t) const {
    return {*this, world, i, t};
  }

  /// Whether two particles have a law, and do not move as one.
  static bool can_meet(const World<Scalar, D>& world, int i, int j) {
    const Law<Scalar>& law = world.law(i, j);
    return (law.blocking || law.tethering) && !world.coupling->together(i, j);
  }

 private:
  template <typename View>
  std::optional<PendingEvent<Scalar>> earliest(const World<Scalar, D>& world, const View& pair) const {
    const int i = pair.i;
    const int j = pair.j;
    require_range(world, pair);
    std::optional<Scalar> earliest;
    int effect = 0;
    for (const Predictor& predictor : predictors_) {
      const std::optional<LimitQuestion<Scalar>> question = predictor.effect->asks(world, i, j);
      if (!question || is_done(pair, *question)) continue;
      const std::optional<Scalar> dt = world.timing.next(pair, *question);
      if (dt && !(*dt >= Scalar(0))) throw OutOfRange("the time of " + pair_name(world.scene, i, j));
      if (dt && *dt < (std::numeric_limits<Scalar>::min)()) require_resolved(world, pair, question->distance);
      if (!dt || (earliest && !(*dt < *earliest))) continue;
      earliest = dt;
      effect = predictor.index;
    }
    if (!earliest) return std::nullopt;
    return world.pending(after(pair.start, *earliest), Rank::collision, i, j, 0, effect);
  }

  /// Whether a pair that has rebounded is not asked. In a periodic box it may meet another image next, where
  /// exactly it approaches; its own leaves, by the directed rounding of its response (D28).
  static bool is_done(const PairView<Scalar, D>&, const LimitQuestion<Scalar>&) { return false; }
  static bool is_done(const ImagedPairView<Scalar, D>& pair, const LimitQuestion<Scalar>& question) {
    return question.kind == TimingKind::block && question.has_responded &&
           normal_sign<Scalar, D>(pair.stored_i, pair.stored_j, pair.v_i, pair.v_j, &pair.image) >= 0;
  }

  /// A time below the normal numbers is one of a pair at its limit, or one that underflowed: then the time in
  /// which the pair crosses its limit does so, too.
  [[gnu::noinline]] static void require_resolved(const World<Scalar, D>& world,
                                                 const PairView<Scalar, D>& pair, const Scalar& distance) {
    const Scalar least = (std::numeric_limits<Scalar>::min)();
    if (Scalar(distance / norm<Scalar, D>(pair.v_j - pair.v_i)) < least)
      throw OutOfRange("the time in which " + pair_name(world.scene, pair.i, pair.j) +
                       " meet, which underflows,");
  }

  static void require_range(const World<Scalar, D>& world, const PairView<Scalar, D>& pair) {
    const auto finite = [](const Vector<Scalar, D>& x) { return is_finite<Scalar, D>(x); };
    if (finite(pair.u_j - pair.u_i) && finite(pair.v_j - pair.v_i)) return;
    for (const int i : {pair.i, pair.j}) {
      if (!finite(world.position(i, pair.start))) {
        throw OutOfRange("the position of " + particle_name(world.scene, i));
      }
    }
    const char* what = finite(pair.u_j - pair.u_i) ? "the relative velocity of " : "the distance of ";
    throw OutOfRange(what + pair_name(world.scene, pair.i, pair.j));
  }

  struct Predictor {
    const Effect<Scalar, D>* effect;
    int index;
  };
  std::vector<Predictor> predictors_;
};

}  // namespace tps

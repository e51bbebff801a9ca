// The textbook detector: every pair is asked for its next event once, and again when one of the two changes.
#pragma once

#include <memory>
#include <vector>

#include "reference/engine/effect.hpp"
#include "reference/engine/world.hpp"

namespace tps {

template <typename Scalar, int D>
class AllPairs {
 public:
  using Effects = std::vector<std::unique_ptr<Effect<Scalar, D>>>;

  explicit AllPairs(const Effects& effects) {
    for (std::size_t n = 0; n < effects.size(); ++n) {
      if (effects[n]->predicts_pairs()) predictors_.push_back({effects[n].get(), static_cast<int>(n)});
    }
  }

  /// N(N − 1)/2 pairs, once.
  void predict_all(World<Scalar, D>& world) const {
    for (int i = 0; i < world.size(); ++i) {
      for (int j = i + 1; j < world.size(); ++j) predict(world, i, j);
    }
  }

  /// The pairs of the particles that an event touched (ascending), each once.
  void predict_touched(World<Scalar, D>& world, const std::vector<int>& touched) {
    is_touched_.assign(world.particles.size(), false);
    for (const int i : touched) is_touched_[static_cast<std::size_t>(i)] = true;
    for (const int i : touched) {
      for (int j = 0; j < world.size(); ++j) {
        if (j == i || (j < i && is_touched_[static_cast<std::size_t>(j)])) continue;
        predict(world, std::min(i, j), std::max(i, j));
      }
    }
  }

 private:
  /// Queues the earliest event of a pair. Its time is a function of the two stored states alone: the later of
  /// the two clocks, to which the other particle is advanced, plus the answer of eq. (2). A time beyond the
  /// range of the scalar is queued as never: there is an event, which no clock reaches. Throws OutOfRange.
  void predict(World<Scalar, D>& world, int i, int j) const {
    const Law<Scalar>& law = world.law(i, j);
    if (!law.blocking && !law.tethering) return;
    if (world.coupling->together(i, j)) return;
    const PairView<Scalar, D> pair = world.view(i, j);
    require_range(world, pair);
    std::optional<Scalar> earliest;
    int effect = 0;
    for (const Predictor& predictor : predictors_) {
      const std::optional<LimitQuestion<Scalar>> question = predictor.effect->asks(world, i, j);
      if (!question) continue;
      const std::optional<Scalar> dt = world.timing.next(pair, *question);
      if (dt && !(*dt >= Scalar(0))) throw OutOfRange("the time of " + pair_name(world.scene, i, j));
      if (!dt || (earliest && !(*dt < *earliest))) continue;
      earliest = dt;
      effect = predictor.index;
    }
    if (!earliest) return;
    const Time<Scalar> time = after(pair.start, *earliest);
    world.queue.push(world.pending(time, Rank::collision, i, j, 0, effect));
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
  std::vector<bool> is_touched_;
};

}  // namespace tps

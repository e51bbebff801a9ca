// Who certainly passes a particle by: what most questions about pairs come to, told from the stored states
// for one particle and all its neighbours in turn (docs/scale.md, "Asked in vain").
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "reference/engine/particle_state.hpp"
#include "reference/engine/periodic_box.hpp"

namespace tps {

/// What is certain about the next event of a pair without asking for it.
template <typename Scalar>
struct Foresight {
  bool misses;        ///< it has none
  Scalar not_before;  ///< it has none before so long after t; 0: that is not known
};

/// A filter for the verdict of eq. (2) at an inner limit L: one particle as it is at a time t, beside others.
///
/// Notation: r, v the relative state at t, by the nearest image; a = v·v, h = r·v, D = h² − a (r² − L²); δ
/// how long before t the question stands, at the later of the two clocks; S the sum of the sizes of whatever
/// coordinates r came from, and of L. Then h − aδ, which is h at the clock, errs by less than 41 u S√a, and
/// D by less than 64 u a S²; used are 128 and 256.
template <typename Scalar, int D, bool kOfHardware = std::is_floating_point_v<Scalar>>
class MissFilter {
 public:
  using State = ParticleState<Scalar, D>;

  /// `box` is null where space is unbounded. It must outlive the filter.
  MissFilter(const State& own, const Time<Scalar>& t, const PeriodicBox<Scalar, D>* box)
      : t_(t), box_(box), velocity_(own.velocity) {
    using std::abs;
    age_ = since(own.clock);
    doubt_ = Limits::epsilon() * abs(t.hi);
    largest_ = box == nullptr ? kLargest : std::min(kLargest, box->farthest());
    size_ = box == nullptr ? Scalar(0) : box->edges().sum();
    for (int k = 0; k < D; ++k) {
      place_[k] = own.position[k] + own.velocity[k] * age_;
      size_ += abs(own.position[k]) + abs(own.velocity[k]) * (abs(age_) + doubt_);
      speed_ += abs(own.velocity[k]);
    }
  }

  /// What is certain about the next event of the pair with another particle at L, whichever formula is asked,
  /// but the literal one.
  ///
  /// None, where the pair parts (h > 0) or passes by (D < 0, so that a c > h² ≥ 0). Where it approaches from
  /// well outside, c > 2²² ε S², none before c/(√(D + 256u a S²) − h) from t on, less a 2⁻¹⁵th. In either
  /// case every number of the pair is finite, and in a box its image is known until then.
  Foresight<Scalar> foresee(const State& other, const Scalar& L) const {
    using std::abs;
    constexpr Scalar epsilon = Limits::epsilon();
    const Scalar age = since(other.clock);
    const Scalar longest = abs(age) + doubt_;
    Scalar a(0), h(0), r_squared(0), S = size_ + L;
    bool is_nearest = true;
    for_each_axis<D>([&](int k) __attribute__((always_inline)) {
      const Scalar u = other.position[k], velocity = other.velocity[k];
      S += abs(u) + abs(velocity) * longest;
      Scalar r = u + velocity * age - place_[k];
      if (box_ != nullptr) is_nearest = is_nearest & box_->bring_near(k, r);
      const Scalar v = velocity - velocity_[k];
      a += v * v;
      h += r * v;
      r_squared += r * r;
    });
    const Scalar c = r_squared - L * L;
    const Scalar h_then = h - a * std::min(age, age_);
    const Scalar scale = a * S * S;
    const Scalar doubt = Scalar(128) * epsilon * scale;
    const Scalar discriminant = h * h - a * c;
    // Without branches: half of all pairs part, in no order that a processor could guess.
    const bool parts = (h_then > Scalar(0)) & (h_then * h_then > Scalar(4096) * epsilon * epsilon * scale);
    const bool passes_by = -discriminant > doubt;
    const bool in_range =
        (a > kSmallest * kSmallest) & (a < kLargest * kLargest) & (S > kSmallest) & (S < largest_);
    if ((parts | passes_by) & in_range & is_nearest) return {true, Scalar(0)};
    const bool is_outside = c > Scalar(0x1p22) * epsilon * S * S;
    if (!(in_range & is_nearest & is_outside) || !(h < Scalar(0))) return {false, Scalar(0)};
    const Scalar dt = c / (std::sqrt(discriminant + doubt) - h);
    if (box_ != nullptr && !(S + Scalar(2) * dt * (speed_ + other.velocity.cwiseAbs().sum()) < largest_))
      return {false, Scalar(0)};
    return {false, dt * Scalar(1 - 0x1p-15)};
  }

 private:
  using Limits = std::numeric_limits<Scalar>;

  static constexpr Scalar power_of_two(int n) {
    Scalar x(1);
    for (; n > 0; --n) x *= 2;
    for (; n < 0; ++n) x /= 2;
    return x;
  }
  /// A product of four numbers between these neither overflows nor underflows.
  static constexpr Scalar kSmallest = power_of_two(Limits::min_exponent / 5);
  static constexpr Scalar kLargest = power_of_two(Limits::max_exponent / 5);

  /// t − clock, within 2u of itself and 4u² t.
  Scalar since(const Time<Scalar>& clock) const { return (t_.hi - clock.hi) + (t_.lo - clock.lo); }

  Time<Scalar> t_;
  const PeriodicBox<Scalar, D>* box_;
  Vector<Scalar, D> place_, velocity_;
  Scalar age_, doubt_, size_, largest_, speed_{0};
};

/// Scalars of software, whose operations are not all within u, are spared nothing.
template <typename Scalar, int D>
class MissFilter<Scalar, D, false> {
 public:
  MissFilter(const ParticleState<Scalar, D>&, const Time<Scalar>&, const PeriodicBox<Scalar, D>*) {}
  Foresight<Scalar> foresee(const ParticleState<Scalar, D>&, const Scalar&) const {
    return {false, Scalar(0)};
  }
};

}  // namespace tps

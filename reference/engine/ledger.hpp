// What a run must conserve, added up event by event from the formulas and not from the velocities, so that
// the difference between the two measures the run.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "reference/equations/vector.hpp"

namespace tps {

/// A running sum that also carries what rounding took away (Neumaier 1974).
template <typename Scalar>
class Sum {
 public:
  Sum() = default;
  Sum(const Scalar& total, const Scalar& rest) : total_(total), rest_(rest) {}

  Sum& operator+=(const Scalar& x) {
    using std::abs;
    const Scalar sum = total_ + x;
    rest_ += abs(total_) >= abs(x) ? Scalar((total_ - sum) + x) : Scalar((x - sum) + total_);
    total_ = sum;
    return *this;
  }
  Scalar value() const { return total_ + rest_; }
  const Scalar& total() const { return total_; }
  const Scalar& rest() const { return rest_; }

 private:
  Scalar total_{0};
  Scalar rest_{0};
};

/// Energies and momenta of a run. Energies are kinetic ones in the frame of the infinite masses (of the
/// scene, where there is none): there a wall does no work.
///
/// Law: kinetic + stored + lost − work = kinetic at the start, up to `energy_bound`; momentum of the finite
/// masses − from_walls − from_outside = that at the start, up to `momentum_bound` (docs/ledger.md).
template <typename Scalar, int D>
struct Ledger {
  Scalar kinetic_at_start{0};
  Vector<Scalar, D> momentum_at_start = Vector<Scalar, D>::Zero();
  Sum<Scalar> lost;  ///< Σ ½ μ (1 − c²) v_n² by eq. (4), ½ μ (1 − c^(2θ/π)) |v_AB|² by eq. (5)
  Sum<Scalar> stored;                                               ///< Σ over live nodes of |Δp_AB|²/2μ
  Sum<Scalar> work;                                                 ///< of impulses from outside
  std::array<Sum<Scalar>, static_cast<std::size_t>(D)> from_walls;  ///< momentum that infinite masses gave
  std::array<Sum<Scalar>, static_cast<std::size_t>(D)>
      from_outside;  ///< momentum that impulses from outside gave
  Scalar energy_bound{0};
  Scalar momentum_bound{0};

  void add_from_walls(const Vector<Scalar, D>& impulse) {
    for (int k = 0; k < D; ++k) from_walls[static_cast<std::size_t>(k)] += impulse[k];
  }
  void add_from_outside(const Vector<Scalar, D>& impulse) {
    for (int k = 0; k < D; ++k) from_outside[static_cast<std::size_t>(k)] += impulse[k];
  }

  /// Adds what rounding may have done at one event to a particle of mass m, whose velocity it changes:
  /// 64 u m s to a momentum and 64 u m s max(s, s_V) to an energy, u = ε/2, s = |v| + |v'|,
  /// s_V = |v − V| + |v' − V|. docs/ledger.md counts the roundings.
  /// Where products underflow, each rounding loses up to the smallest number: of m v, of m times v², or of an
  /// impulse times a speed.
  void add_rounding(const Scalar& mass, const Vector<Scalar, D>& before, const Vector<Scalar, D>& after,
                    const Vector<Scalar, D>& V) {
    using Limits = std::numeric_limits<Scalar>;
    const Scalar speeds = norm<Scalar, D>(before) + norm<Scalar, D>(after);
    const Scalar in_frame = norm<Scalar, D>(before - V) + norm<Scalar, D>(after - V);
    const Scalar larger = in_frame > speeds ? in_frame : speeds;
    const Scalar units = Scalar(kRoundings / 2) * Limits::epsilon();
    const Scalar underflow = Scalar(kRoundings) * Limits::denorm_min() * (Scalar(1) + mass);
    momentum_bound += units * (mass * speeds) + underflow;
    energy_bound +=
        units * (mass * speeds * larger) + underflow + Scalar(kRoundings) * Limits::denorm_min() * larger;
  }

  /// Adds what directed rounding did to a velocity: m |v' − v| to a momentum, and m |v' − v| (|v'| + |v|) to
  /// an energy, speeds relative to V.
  void add_change(const Scalar& mass, const Vector<Scalar, D>& before, const Vector<Scalar, D>& after,
                  const Vector<Scalar, D>& V) {
    const Scalar change = mass * norm<Scalar, D>(after - before);
    momentum_bound += change;
    energy_bound += change * (norm<Scalar, D>(before - V) + norm<Scalar, D>(after - V));
  }

  static constexpr int kRoundings = 64;
};

}  // namespace tps

// Where a particle is along an axis when it first comes within a distance of a point, an edge or a face: by
// the signs of exact numbers, without the time. docs/effects.md, "The outside of a box".
#pragma once

#include <array>
#include <cstddef>

#include "reference/equations/dyadic.hpp"
#include "reference/equations/vector.hpp"

namespace tps {

/// A particle B that comes within the distance L of A, distances being measured along some axes alone: one
/// for a plane, two for an edge along the third.
///
/// With r = u_B − u_A and w = v_B − v_A along those axes, it touches at the smaller root t* of |r + w t| = L,
/// or at once where |r| ≤ L. A plane c along axis k, which moves with A, is crossed at τ = −d/w_k, d = u_B[k]
/// − c. Then t* < τ where |r + w τ| < L, or where B parts from A at τ; both are signs of polynomials, after
/// multiplication by |w_k|.
/// Laws: (1) all lengths, or all velocities, times 2^k keep the sides; (2) what is common to both velocities
/// changes nothing where adding it is exact; (3) a plane that is never crossed keeps its side.
template <typename Scalar, int D>
class FirstTouch {
 public:
  using Vec = Vector<Scalar, D>;

  /// REQUIRES finite numbers, L > 0.
  FirstTouch(const Vec& u_A, const Vec& u_B, const Vec& v_A, const Vec& v_B, const Scalar& L,
             const std::array<bool, 3>& measured)
      : u_B_(u_B), v_A_(v_A), v_B_(v_B), L_(dyadic(L)), measured_(measured) {
    Dyadic square;
    for (int k = 0; k < D; ++k) {
      if (!is_measured(k)) continue;
      r_[at(k)] = dyadic(Scalar(u_B[k])) - dyadic(Scalar(u_A[k]));
      w_[at(k)] = dyadic(Scalar(v_B[k])) - dyadic(Scalar(v_A[k]));
      square = square + r_[at(k)] * r_[at(k)];
    }
    const Dyadic beyond = square - L_ * L_;
    at_once_ = beyond.sign() <= 0;
    touches_ = at_once_ || comes_within(beyond);
  }

  /// Whether B touches: it is within L at once, or approaches and comes nearer than L. Who flies past at L
  /// exactly does not (docs/semantics.md, `tangent`).
  bool happens() const { return touches_; }

  /// The sign of u_B[k] − c − v_A[k] t at the touch: −1 before the plane, 0 on it, 1 behind. REQUIRES
  /// happens().
  int side(int k, const Scalar& c) const {
    const int now = compare(u_B_[k], c);
    const int way = compare(v_B_[k], v_A_[k]);
    if (at_once_ || way == 0 || now == way) return now;
    if (now == 0) return way;
    const Dyadic d = size(dyadic(Scalar(u_B_[k])) - dyadic(c));
    const Dyadic speed = size(dyadic(Scalar(v_B_[k])) - dyadic(Scalar(v_A_[k])));
    Dyadic square, along;
    for (int j = 0; j < D; ++j) {
      if (!is_measured(j)) continue;
      const Dyadic R = r_[at(j)] * speed + w_[at(j)] * d;
      square = square + R * R;
      along = along + R * w_[at(j)];
    }
    const Dyadic limit = L_ * speed;
    const int beyond = (square - limit * limit).sign();
    if (beyond < 0 || along.sign() > 0) return now;
    return beyond == 0 ? 0 : way;
  }

 private:
  /// h < 0 and h² > a c.
  bool comes_within(const Dyadic& c) const {
    Dyadic a, h;
    for (std::size_t k = 0; k < measured_.size(); ++k) {
      a = a + w_[k] * w_[k];
      h = h + r_[k] * w_[k];
    }
    return h.sign() < 0 && (h * h - a * c).sign() > 0;
  }
  static std::size_t at(int k) { return static_cast<std::size_t>(k); }
  bool is_measured(int k) const { return measured_[at(k)]; }
  static int compare(const Scalar& x, const Scalar& y) { return x < y ? -1 : x > y ? 1 : 0; }
  static Dyadic size(const Dyadic& x) { return x.sign() < 0 ? -x : x; }

  Vec u_B_, v_A_, v_B_;
  Dyadic L_;
  std::array<bool, 3> measured_;
  std::array<Dyadic, 3> r_, w_;  ///< along the measured axes
  bool at_once_ = false, touches_ = false;
};

}  // namespace tps

// Two bodies in affine arithmetic: eqs. (1) to (5) on sets of numbers. Heavy header: only sources of the
// enclosed run include it.
#pragma once

#include <string>
#include <vector>

#include "verify/cost/affine_form.hpp"

namespace tps::cost {

using AffineVector = std::vector<AffineForm>;  ///< of three

AffineVector operator+(const AffineVector& x, const AffineVector& y);
AffineVector operator-(const AffineVector& x, const AffineVector& y);
AffineVector operator*(const AffineForm& factor, const AffineVector& x);

/// u(t) = offset + velocity · t, between two changes of its velocity.
struct Body {
  int id;
  double mass;
  AffineVector offset, velocity;
  int changes = 0;  ///< of the velocity, so far
};

/// A distance at which two bodies meet.
struct Limit {
  std::size_t i, j;
  bool blocks;  ///< else it tethers
  double distance;
  double c;  ///< c_rebound or c_retract
  double c_revolve, theta_revolve_deg;
  int changes_i = -1, changes_j = -1;  ///< those of the bodies behind the pair's last rebound
};

/// The quadratic a s² + 2 h s + c of |r + v s|² − L², s from a moment `base` on, and D = h² − a c.
struct PairMotion {
  /// r = u_B − u_A at base, v = v_B − v_A.
  PairMotion(AffineVector r, AffineVector v, double distance, long bits);

  /// Where the limit is met: the smaller root for a blocking limit, the larger one for a tether. REQUIRES a
  /// and D certainly positive.
  AffineForm root(bool blocks) const;

  /// A lower bound of the time of any contact: the gap between the limits over the speed.
  double earliest_contact(double base) const;

  double L;
  AffineVector r, v;
  AffineForm a, h, c, D;
};

/// What happens at a limit.
struct Response {
  std::string kind;   ///< rebound, retract, revolve; empty where it depends on the start
  AffineVector lost;  ///< v_AB − v_AB'
};

/// Eqs. (4) and (5), by what holds at the limit: |r| = L, so û = r/L and v_n = ∓√D/L.
Response response_of(const Limit& limit, const PairMotion& motion, long bits);

}  // namespace tps::cost

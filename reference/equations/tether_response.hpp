// The response of a pair at its tethering distance: eq. (4) if a retraction suffices, else (5) (docs/eq5.md).
#pragma once

#include <type_traits>

#include "reference/equations/eq4_collision_impulse.hpp"
#include "reference/equations/eq5_revolution_impulse.hpp"

namespace tps {

enum class TetherResponseKind { retract, revolve };

/// What a tethered pair does at its outer limit.
template <typename Scalar, int D>
struct TetherResponse {
  TetherResponseKind kind;
  Vector<Scalar, D> dp;  ///< impulse on A, to be applied by eq. (3)
};

/// Retraction or revolution of a tethered pair at Δu_tethering (paper: the condition between eqs. 4 and 5).
///
/// @param frame the collision seen from A, with v_n ≥ 0 (separating or perpendicular).
/// Laws: (1) those of the equation that answers; (2) afterwards the pair closes at an angle of at least θ
/// from perpendicular (strictly more after a retraction) unless it is at rest; (3) the condition decides,
/// beyond rounding; (4) momentum is conserved by eq. (3); (5) energy never rises; (6) A and B may be
/// exchanged, bitwise.
template <typename Scalar, int D>
TetherResponse<Scalar, D> tether_response(const CollisionFrame<Scalar, D>& frame,
                                          const std::type_identity_t<Scalar>& m_A,
                                          const std::type_identity_t<Scalar>& m_B,
                                          const std::type_identity_t<Scalar>& c_retract,
                                          const std::type_identity_t<Scalar>& c_revolve,
                                          const std::type_identity_t<Scalar>& theta_revolve_deg) {
  if (retraction_suffices<Scalar, D>(frame, c_retract, tan_degrees<Scalar>(theta_revolve_deg))) {
    return {TetherResponseKind::retract, collision_impulse<Scalar, D>(frame, m_A, m_B, c_retract)};
  }
  return {TetherResponseKind::revolve,
          revolution_impulse<Scalar, D>(frame, m_A, m_B, c_revolve, theta_revolve_deg)};
}

}  // namespace tps

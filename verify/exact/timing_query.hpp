// The question: two stored states, a limit, and which kind of limit it is.
#pragma once

#include <array>

namespace tps::exact {

/// Blocking (smaller root, approaching) or tethering (larger root, separating).
enum class Kind { block, tether };

using Vec3 = std::array<double, 3>;

/// When do A and B next reach the distance L? Positions u and velocities v at one instant, in any one
/// consistent set of units. Planar states have z = 0; that is exact.
struct TimingQuery {
  Kind kind;
  Vec3 u_A, u_B;  ///< positions
  Vec3 v_A, v_B;  ///< velocities
  double L;       ///< limiting distance: Δu_blocking or Δu_tethering
};

/// Whether the query has an answer: every number finite and L > 0.
bool valid(const TimingQuery& query);

/// Whether the pair does not move relative to itself: v = 0. A difference of doubles is zero only if they
/// are equal, so comparing them is exact.
constexpr bool is_static(const TimingQuery& query) {
  return query.v_A[0] == query.v_B[0] && query.v_A[1] == query.v_B[1] && query.v_A[2] == query.v_B[2];
}

}  // namespace tps::exact

// A timing query in doubles: two stored states, a limit, and which kind of limit it is; and the moment of a
// run that its answer stands for (docs/eq2.md).
#pragma once

#include <array>
#include <cmath>
#include <optional>

namespace tps {

/// Blocking (smaller root, approaching) or tethering (larger root, separating) of two particles; or a plane
/// wall A that B approaches, n·(u_B − u_A) = L, which is linear in time.
enum class TimingKind { block, tether, plane };

/// When do A and B next reach the distance L? Positions u and velocities v at one instant, in any one
/// consistent set of units. Planar states have z = 0; that is exact.
struct TimingQuery {
  TimingKind kind;
  std::array<double, 3> u_A, u_B;  ///< positions
  std::array<double, 3> v_A, v_B;  ///< velocities
  double L;                        ///< limiting distance: Δu_blocking or Δu_tethering
  std::array<double, 3> normal{};  ///< n of a plane, as stored; A is any of its points
  std::array<double, 3> image{};   ///< in a periodic box B is meant displaced by so many edges, integers
  std::array<double, 3> edges{};   ///< of the box; 0 along an open axis
};

/// Whether the query has an answer: every number finite and L > 0.
inline bool valid(const TimingQuery& query) {
  double zero = 0 * query.L;  // a number times zero is zero, infinity and NaN are not
  for (std::size_t k = 0; k < 3; ++k) {
    zero += 0 * query.u_A[k] + 0 * query.u_B[k] + 0 * query.v_A[k] + 0 * query.v_B[k];
    zero += 0 * query.normal[k] + 0 * query.image[k] + 0 * query.edges[k];
  }
  return zero == 0 && query.L > 0;
}

/// Whether B is meant itself, and no image of it.
constexpr bool is_at_home(const TimingQuery& query) {
  return query.image[0] == 0 && query.image[1] == 0 && query.image[2] == 0;
}

/// Whether the pair does not move relative to itself: v = 0. A difference of doubles is zero only if they
/// are equal, so comparing them is exact.
constexpr bool is_static(const TimingQuery& query) {
  return query.v_A[0] == query.v_B[0] && query.v_A[1] == query.v_B[1] && query.v_A[2] == query.v_B[2];
}

/// A moment of a run as exactly as it is known: hi + lo + multiple · t with the exact t of the query; hi + lo
/// alone where there is none.
struct Moment {
  double hi = 0;  ///< hi + lo is when the query is asked
  double lo = 0;
  std::optional<TimingQuery> query;
  int multiple = 1;  ///< 2 where a pair that has responded is taken to be at its limit (semantics §1)
};

}  // namespace tps

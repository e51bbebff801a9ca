// What a run's summary counts while it runs.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace tps {

template <typename Scalar>
struct Statistics {
  std::map<std::string, std::uint64_t, std::less<>> by_kind;
  /// Collisions whose approach is below what rounding leaves of a difference of velocities:
  /// |v_n| ≤ 4ε max(|v_A|, |v_B|). In real arithmetic they would not be there, or be another moment.
  std::uint64_t noise = 0;
  std::uint64_t zero_impulse = 0;   ///< collisions that stood with Δp = 0
  Scalar worst_inner_excess{0};     ///< most that a pair was nearer than its inner limit, in ulps
  Scalar worst_outer_excess{0};     ///< most that a pair was farther than its outer limit, in ulps
  std::uint64_t largest_group = 0;  ///< particles
  Scalar oldest_group{0};           ///< age at its restitution, in units of time
};

}  // namespace tps

// What a run's summary counts while it runs.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace tps {

template <typename Scalar>
struct Statistics {
  std::map<std::string, std::uint64_t, std::less<>> by_kind;
  void count(std::string_view kind) {
    const auto known = by_kind.find(kind);
    if (known != by_kind.end()) {
      ++known->second;
    } else {
      by_kind.emplace(kind, 1);
    }
  }
  /// Rebounds whose approach is no more than what rounding can have made of velocities and axis
  /// (`below_rounding`): in real arithmetic they may be other ones, more, fewer, or none.
  std::uint64_t noise = 0;
  std::uint64_t first_noise = 0;    ///< number of the first such event; 0: none
  std::uint64_t zero_impulse = 0;   ///< collisions that stood with Δp = 0
  Scalar worst_inner_excess{0};     ///< most that a pair was nearer than its inner limit, in ulps
  Scalar worst_outer_excess{0};     ///< most that a pair was farther than its outer limit, in ulps
  std::uint64_t largest_group = 0;  ///< particles
  Scalar oldest_group{0};           ///< age at its restitution, in units of time
};

}  // namespace tps

// Whether regions are as wide as they should be, told by what happens in them: sizes come from the pair laws,
// and only where few are found while many cross do they grow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tps {

/// Counts, level by level, what particles cost that leave their regions and particles that are touched.
///
/// A region twice as wide is left half as often, and up to 2^D times as many are found from it. It pays where
/// crossing is nearly all that happens and hardly anyone is found; a cluster finds many, so that its regions
/// stay as they are.
class RegionWidths {
 public:
  void reset(std::size_t particles) {
    patience_ = 64 + 4 * static_cast<std::uint64_t>(particles);  // as dear as filing everyone anew, or dearer
    counts_.clear();
  }

  /// A particle of a level has left its region and found so many to ask. @return whether wider regions pay.
  bool crossed(int level, std::size_t found) {
    Count& count = of(level);
    count.found_crossing += found;
    if (++count.crossings < patience_) return false;
    const bool is_idle = count.crossings > kCrossingsPerTouch * count.touches;
    const bool finds_few =
        count.found_crossing < kFew * count.crossings && count.found_touched <= kFew * count.touches;
    count = {};
    return is_idle && finds_few;
  }

  /// A particle of a level was touched and has found so many. @return whether narrower regions do.
  bool touched(int level, std::size_t found) {
    Count& count = of(level);
    count.found_touched += found;
    if (++count.touches < patience_) return false;
    const bool finds_many = count.found_touched > kMany * count.touches;
    count = {};
    return finds_many;
  }

 private:
  static constexpr std::uint64_t kCrossingsPerTouch = 16;
  static constexpr std::uint64_t kFew = 4;
  static constexpr std::uint64_t kMany = 64;  ///< more than 2^3 times few: nothing is widened to and fro

  struct Count {
    std::uint64_t crossings = 0, found_crossing = 0, touches = 0, found_touched = 0;
  };
  Count& of(int level) {
    const auto n = static_cast<std::size_t>(level);
    if (counts_.size() <= n) counts_.resize(n + 1);
    return counts_[n];
  }

  std::uint64_t patience_ = 0;
  std::vector<Count> counts_;
};

}  // namespace tps

// A sum of doubles without rounding.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "verify/exact/double_word.hpp"

namespace tps::check {

/// The sum of the doubles that were added, kept as doubles that do not overlap (Shewchuk, "Adaptive precision
/// floating-point arithmetic and fast robust geometric predicates", 1997). Exact as long as nothing
/// overflows.
class ExactSum {
 public:
  void add(double x) {
    std::size_t kept = 0;
    for (const double part : parts_) {
      const exact::DoubleWord sum = exact::two_sum(x, part);
      if (sum.lo != 0) parts_[kept++] = sum.lo;
      x = sum.hi;
    }
    parts_.resize(kept);
    if (x != 0) parts_.push_back(x);
  }

  /// The nearest double, to even in the middle.
  double rounded() const {
    std::size_t n = parts_.size();
    if (n == 0) return 0;
    double hi = parts_[--n];
    double lo = 0;
    while (n > 0 && lo == 0) {
      const exact::DoubleWord sum = exact::two_sum(hi, parts_[--n]);
      hi = sum.hi;
      lo = sum.lo;
    }
    // In the middle between two doubles what is left decides.
    const bool outwards = n > 0 && lo != 0 && std::signbit(lo) == std::signbit(parts_[n - 1]);
    const double other = hi + 2 * lo;
    return outwards && other - hi == 2 * lo ? other : hi;
  }

 private:
  std::vector<double> parts_;  ///< by growing magnitude, none of them zero
};

}  // namespace tps::check

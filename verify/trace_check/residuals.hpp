// Signed sums of residuals, and how far chance may have taken them.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "verify/trace_check/lazy_table.hpp"

namespace tps::check {

/// The least-squares estimate of b in y = b x + rounding, with a standard error that regular motion does not
/// fool.
///
/// A ball in a circle meets the same chord at every hit, another way round: the residuals are all those of
/// one rounding and not independent, though no two are the same. Residuals of like events, whose `size`
/// agrees in 24 bits, are therefore added up first, and the error is that of these sums (White's estimator
/// for clustered data). It means something where there are many of them: `independent` is (Σ x²)²/Σ (Σ x² of
/// a cluster)². Clusters share 2^16 places, which adds up some that have nothing to do with each other; that
/// changes no expectation.
class Residuals {
 public:
  void add(double y, double x, double size) {
    Sums& sums = clusters_[place_of(size)];
    sums.xy += x * y;
    sums.xx += x * x;
    ++count_;
  }

  /// Asks memory for what adding a residual of that size takes.
  void expect(double size) const { clusters_.fetch(place_of(size)); }

  /// Adds up what was added to another one.
  void take_over(const Residuals& other) {
    clusters_.each_with(other.clusters_, [](Sums& mine, const Sums& others) {
      mine.xy += others.xy;
      mine.xx += others.xx;
    });
    count_ += other.count_;
  }

  std::uint64_t count() const { return count_; }
  double mean() const {
    const Sums all = total();
    return all.xx > 0 ? all.xy / all.xx : 0;
  }
  double standard_error() const {
    const Sums all = total();
    const double m = mean();
    double variance = 0;
    clusters_.each([&](const Sums& s) { variance += (s.xy - m * s.xx) * (s.xy - m * s.xx); });
    return all.xx > 0 ? std::sqrt(variance) / all.xx : 0;
  }
  double independent() const {
    const Sums all = total();
    double squares = 0;
    clusters_.each([&](const Sums& s) { squares += s.xx * s.xx; });
    return squares > 0 ? all.xx * all.xx / squares : 0;
  }

 private:
  struct Sums {
    double xy = 0, xx = 0;
  };
  static std::uint16_t place_of(double size) {
    const std::uint64_t like = std::bit_cast<std::uint64_t>(std::fabs(size)) >> 29U;
    return static_cast<std::uint16_t>((like * 0x9e3779b97f4a7c15U) >> 48U);
  }
  Sums total() const {
    Sums all;
    clusters_.each([&](const Sums& s) {
      all.xy += s.xy;
      all.xx += s.xx;
    });
    return all;
  }

  std::uint64_t count_ = 0;
  LazyTable<Sums> clusters_;
};

}  // namespace tps::check

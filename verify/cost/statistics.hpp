// Statistics of the study: quantiles, intervals of proportions, bootstrap intervals of ratios.
#pragma once

#include <cstdint>
#include <vector>

namespace tps::cost {

/// Five numbers of a sample.
struct Quantiles {
  double min, q1, median, q3, max;
};

/// The p-quantile by linear interpolation between order statistics (Hyndman and Fan's type 7).
/// REQUIRES a sorted sample that is not empty, 0 ≤ p ≤ 1.
double quantile(const std::vector<double>& sorted, double p);

Quantiles quantiles(std::vector<double> sample);

struct Interval {
  double low, high;
};

/// The interval of Clopper and Pearson (1934) for a proportion: covers it with at least the given confidence,
/// whatever it is. For no success in n the upper end is 1 − (α/2)^(1/n).
Interval proportion_interval(std::uint64_t successes, std::uint64_t trials, double confidence);

/// Percentile bootstrap of the median of x over the median of y, where x[i] and y[i] were measured in the
/// same repetition: repetitions are drawn, not times, so that what disturbed both cancels. REQUIRES samples
/// of one size, not empty.
Interval ratio_interval(const std::vector<double>& x, const std::vector<double>& y, double confidence,
                        std::uint64_t seed);

}  // namespace tps::cost

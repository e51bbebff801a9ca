#include "verify/cost/statistics.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>

#include "verify/vectors/random.hpp"

namespace tps::cost {
namespace {

constexpr int kResamples = 1000;

double median_of(std::vector<double>& sample) {
  std::sort(sample.begin(), sample.end());
  return quantile(sample, 0.5);
}

/// Where a condition that holds at 1 and not at 0 begins to hold, by bisection. (gsl_cdf_beta_Pinv, which
/// would be the quantile in one call, gives up on some of these.)
template <typename Condition>
double first_where(const Condition& holds) {
  double below = 0;
  double above = 1;
  for (double middle = 0.5; below < middle && middle < above; middle = below + (above - below) / 2) {
    (holds(middle) ? above : below) = middle;
    if (above - below < 1e-12 * above) break;
  }
  return above;
}

}  // namespace

double quantile(const std::vector<double>& sorted, double p) {
  const double place = p * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

Quantiles quantiles(std::vector<double> sample) {
  std::sort(sample.begin(), sample.end());
  return {sample.front(), quantile(sample, 0.25), quantile(sample, 0.5), quantile(sample, 0.75),
          sample.back()};
}

Interval proportion_interval(std::uint64_t successes, std::uint64_t trials, double confidence) {
  if (trials == 0) return {0, 1};
  const auto n = static_cast<unsigned>(trials);
  const auto k = static_cast<unsigned>(successes);
  const double tail = (1 - confidence) / 2;
  const double low =
      k == 0 ? 0 : first_where([&](double p) { return gsl_cdf_binomial_Q(k - 1, p, n) >= tail; });
  const double high = k == n ? 1 : first_where([&](double p) { return gsl_cdf_binomial_P(k, p, n) <= tail; });
  return {low, high};
}

Interval ratio_interval(const std::vector<double>& x, const std::vector<double>& y, double confidence,
                        std::uint64_t seed) {
  vectors::Random random(seed);
  std::vector<double> ratios, drawn_x(x.size()), drawn_y(x.size());
  for (int sample = 0; sample < kResamples; ++sample) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const auto which = static_cast<std::size_t>(random.integer(0, static_cast<int>(x.size()) - 1));
      drawn_x[i] = x[which];
      drawn_y[i] = y[which];
    }
    ratios.push_back(median_of(drawn_x) / median_of(drawn_y));
  }
  std::sort(ratios.begin(), ratios.end());
  return {quantile(ratios, (1 - confidence) / 2), quantile(ratios, (1 + confidence) / 2)};
}

}  // namespace tps::cost

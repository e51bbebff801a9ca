#include <algorithm>
#include <cmath>
#include <numeric>

#include "reference/process/thread_time.hpp"
#include "verify/cost/measure.hpp"
#include "verify/cost/questions.hpp"
#include "verify/vectors/random.hpp"

namespace tps::cost {
namespace {

/// A loop that is shorter is repeated until it is so long: reading the clock takes a part of a microsecond.
constexpr double kShortest = 50'000;  // ns
constexpr double kConfidence = 0.95;

/// Of this thread alone; or of the wall, where somebody else answers.
double now_ns(bool elsewhere) {
  return 1e9 * (elsewhere ? seconds_of(CLOCK_MONOTONIC) : thread_seconds());
}

using Loop = std::function<void(std::span<const TimingQuery>)>;

double ns_of(const Loop& loop, bool elsewhere, std::span<const TimingQuery> queries, int passes) {
  const double start = now_ns(elsewhere);
  for (int pass = 0; pass < passes; ++pass) loop(queries);
  return (now_ns(elsewhere) - start) / (passes * static_cast<double>(queries.size()));
}

/// The first pass also warms caches and branch predictors.
int passes_for(const Variant& variant, std::span<const TimingQuery> queries) {
  const double once =
      ns_of(variant.throughput, variant.elsewhere, queries, 1) * static_cast<double>(queries.size());
  return std::max(1, static_cast<int>(std::ceil(kShortest / std::max(once, 1.0))));
}

struct Samples {
  int passes = 1;
  std::vector<double> throughput, latency;
};

/// Every variant in every repetition, each time in another order.
std::vector<Samples> interleaved(const std::vector<Variant>& variants,
                                 const std::vector<TimingQuery>& queries, const StudyOptions& options) {
  std::vector<Samples> samples(variants.size());
  for (std::size_t i = 0; i < variants.size(); ++i) {
    samples[i].passes = passes_for(variants[i], queries);
  }
  std::vector<std::size_t> order(variants.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  vectors::Random random(options.seed);
  for (int repetition = 0; repetition < options.repetitions; ++repetition) {
    for (std::size_t i = order.size(); i > 1; --i) {
      std::swap(order[i - 1], order[static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1))]);
    }
    for (const std::size_t i : order) {
      samples[i].throughput.push_back(
          ns_of(variants[i].throughput, variants[i].elsewhere, queries, samples[i].passes));
      samples[i].latency.push_back(
          ns_of(variants[i].latency, variants[i].elsewhere, queries, samples[i].passes));
    }
  }
  return samples;
}

/// The questions by the stage that settled them, and what those of each stage cost.
std::vector<Path> paths_of(const Variant& variant, const std::vector<TimingQuery>& queries, int repetitions) {
  std::vector<TimingQuery> by_stage[3];
  for (const TimingQuery& query : queries) {
    const exact::Counters counts = variant.counted({&query, 1});
    const bool integers = counts.verdict.exact + counts.time.exact > 0;
    const bool beyond_first = counts.verdict.uncertain + counts.time.uncertain > 0;
    by_stage[integers ? 2 : beyond_first ? 1 : 0].push_back(query);
  }
  const char* const names[] = {"first", "double-words", "integers"};
  std::vector<Path> paths;
  for (std::size_t stage = 0; stage < 3; ++stage) {
    Path path{names[stage], by_stage[stage].size(), 0};
    if (path.questions > 0) {
      const int passes = passes_for(variant, by_stage[stage]);
      std::vector<double> ns;
      for (int n = 0; n < repetitions; ++n)
        ns.push_back(ns_of(variant.throughput, variant.elsewhere, by_stage[stage], passes));
      path.ns = quantiles(ns).median;
    }
    paths.push_back(path);
  }
  return paths;
}

}  // namespace

void measure_times(StratumResult& result, const StudyOptions& options, const std::vector<Variant>& variants) {
  const std::vector<TimingQuery> queries = questions(result.stratum, options.seed, options.timed);
  const std::vector<Samples> samples = interleaved(variants, queries, options);
  const std::vector<double>& baseline = samples.front().throughput;
  for (std::size_t i = 0; i < variants.size(); ++i) {
    Times times{quantiles(samples[i].throughput), quantiles(samples[i].latency), 1, {1, 1}};
    times.ratio = times.throughput.median / quantiles(baseline).median;
    times.ratio_interval = ratio_interval(samples[i].throughput, baseline, kConfidence, options.seed);
    result.cells[i].times = times;
    if (variants[i].counted) {
      result.cells[i].paths = paths_of(variants[i], queries, options.repetitions);
    }
  }
}

}  // namespace tps::cost

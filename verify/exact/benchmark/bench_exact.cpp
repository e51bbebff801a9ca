// What certainty costs: literal double, exact verdict, correctly rounded time, exact order, and 50 digits, in
// one program, with one set of flags, on the same queries.
//
//   tps_bench_exact [--benchmark_…]     times are per query (per pair for the orders)
//
// Counters beside the times are the share of questions that left the double filter, and that needed integers.
#include <benchmark/benchmark.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

#include "verify/exact/benchmark/literal.hpp"
#include "verify/exact/exact_verdict.hpp"
#include "verify/exact/rounded_time.hpp"
#include "verify/exact/time_order.hpp"
#include "verify/vectors/timing_strata.hpp"

namespace tps::exact {
namespace {

using Fifty = boost::multiprecision::cpp_bin_float_50;

constexpr std::size_t kQueries = 4096;

/// Random pairs of which about half of the blocking ones approach: branches fall as they do in a scene.
const std::vector<TimingQuery>& random_queries() {
  static const std::vector<TimingQuery> queries = [] {
    strata::Random random(1);
    std::vector<TimingQuery> made;
    while (made.size() < kQueries) {
      made.push_back(strata::plain(random, made.size() % 2 == 0 ? Kind::block : Kind::tether));
    }
    return made;
  }();
  return queries;
}

/// Grazes: limits passed at L (1 ∓ 2^-5 … 2^-53), from 1 to 2^20 L away.
const std::vector<TimingQuery>& grazing_queries() {
  static const std::vector<TimingQuery> queries = strata::all(2, static_cast<int>(kQueries))[1].queries;
  return queries;
}

using Queries = const std::vector<TimingQuery>& (*)();

void report(::benchmark::State& state, const StageCounts& counts) {
  const auto share = [&](std::uint64_t n) {
    return counts.calls == 0 ? 0.0 : static_cast<double>(n) / static_cast<double>(counts.calls);
  };
  state.counters["uncertain"] = share(counts.uncertain);
  state.counters["exact"] = share(counts.exact);
}

template <typename Answer>
void each(::benchmark::State& state, Queries queries, const Answer& answer) {
  const std::vector<TimingQuery>& all = queries();
  for (auto _ : state) {
    for (const TimingQuery& query : all) ::benchmark::DoNotOptimize(answer(query));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(all.size()));
}

template <typename Answer>
void each_pair(::benchmark::State& state, Queries queries, const Answer& answer) {
  const std::vector<TimingQuery>& all = queries();
  for (auto _ : state) {
    for (std::size_t i = 0; i + 1 < all.size(); i += 2)
      ::benchmark::DoNotOptimize(answer(all[i], all[i + 1]));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(all.size() / 2));
}

void literal_double(::benchmark::State& state, Queries queries) {
  each(state, queries, [](const TimingQuery& query) { return benchmark::literal_time<double>(query); });
}

void literal_50_digits(::benchmark::State& state, Queries queries) {
  each(state, queries, [](const TimingQuery& query) { return benchmark::literal_time<Fifty>(query); });
}

void verdict(::benchmark::State& state, Queries queries) {
  Counters counters;
  each(state, queries, [&](const TimingQuery& query) { return exact_verdict(query, counters); });
  report(state, counters.verdict);
}

void time(::benchmark::State& state, Queries queries) {
  Counters counters;
  each(state, queries, [&](const TimingQuery& query) { return rounded_time(query, counters); });
  report(state, counters.time);
}

void times_together(::benchmark::State& state, Queries queries) {
  Counters counters;
  const std::vector<TimingQuery>& all = queries();
  std::vector<TimingAnswer> answers(all.size());
  for (auto _ : state) {
    rounded_times(all, answers, counters);
    ::benchmark::DoNotOptimize(answers.data());
    ::benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(all.size()));
  report(state, counters.time);
}

/// Two literal evaluations and a comparison.
template <typename Scalar>
void literal_order(::benchmark::State& state, Queries queries) {
  each_pair(state, queries, [](const TimingQuery& first, const TimingQuery& second) {
    return benchmark::literal_time<Scalar>(first) < benchmark::literal_time<Scalar>(second);
  });
}

void literal_order_double(::benchmark::State& state, Queries queries) {
  literal_order<double>(state, queries);
}
void literal_order_50_digits(::benchmark::State& state, Queries queries) {
  literal_order<Fifty>(state, queries);
}

void order(::benchmark::State& state, Queries queries) {
  Counters counters;
  each_pair(state, queries, [&](const TimingQuery& first, const TimingQuery& second) {
    return time_order(first, second, counters);
  });
  report(state, counters.order);
}

BENCHMARK_CAPTURE(literal_double, random, random_queries);
BENCHMARK_CAPTURE(verdict, random, random_queries);
BENCHMARK_CAPTURE(time, random, random_queries);
BENCHMARK_CAPTURE(times_together, random, random_queries);
BENCHMARK_CAPTURE(literal_50_digits, random, random_queries);
BENCHMARK_CAPTURE(literal_order_double, random, random_queries);
BENCHMARK_CAPTURE(order, random, random_queries);
BENCHMARK_CAPTURE(literal_order_50_digits, random, random_queries);
BENCHMARK_CAPTURE(literal_double, grazing, grazing_queries);
BENCHMARK_CAPTURE(verdict, grazing, grazing_queries);
BENCHMARK_CAPTURE(time, grazing, grazing_queries);
BENCHMARK_CAPTURE(times_together, grazing, grazing_queries);
BENCHMARK_CAPTURE(literal_50_digits, grazing, grazing_queries);
BENCHMARK_CAPTURE(literal_order_double, grazing, grazing_queries);
BENCHMARK_CAPTURE(order, grazing, grazing_queries);
BENCHMARK_CAPTURE(literal_order_50_digits, grazing, grazing_queries);

}  // namespace
}  // namespace tps::exact

BENCHMARK_MAIN();

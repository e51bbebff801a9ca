// Events a second of the engine, by system, number of particles, detector and timing; no trace is written.
//
//   tps_bench_engine [--benchmark_filter=REGEX] [--benchmark_out=FILE]     `./run bench` plots it
//
// Counters: events a second of processor time; timing queries and candidates an event; bytes a particle that
// the simulation took (Linux).
#include <benchmark/benchmark.h>

#include <fstream>
#include <string>

#include "reference/engine/simulation.hpp"
#include "verify/certified/exact_timing.hpp"
#include "verify/scale/systems.hpp"

namespace tps::scale {
namespace {

/// What the process has in memory; 0 where that is not told.
double resident_bytes() {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word) {
    if (word != "VmRSS:") continue;
    double kilobytes = 0;
    status >> kilobytes;
    return 1024 * kilobytes;
  }
  return 0;
}

/// Events before the measurement: the lattice of the start melts.
std::uint64_t warm_up(int particles) {
  return std::min<std::uint64_t>(100'000 + static_cast<std::uint64_t>(particles), 1'000'000);
}

void measure(benchmark::State& state, const Scene& scene, Timing timing, DetectorKind detector) {
  const int particles = static_cast<int>(scene.particles.size());
  const bool all_pairs = detector == DetectorKind::all_pairs;
  const std::uint64_t events = all_pairs ? 2'000'000 / static_cast<std::uint64_t>(particles) + 100 : 200'000;
  certified::ExactTiming certifier;
  const double before = resident_bytes();
  Simulation<double, 3> simulation(scene, {timing, &certifier}, detector);
  const double taken = resident_bytes() - before;
  const auto advance = [&](std::uint64_t more) {
    const std::uint64_t end = simulation.world().events + more;
    while (simulation.world().events < end) simulation.step();
  };
  if (!all_pairs) advance(warm_up(particles));
  const std::uint64_t calls = certifier.counters().verdict.calls;
  std::uint64_t measured = 0;
  for (auto _ : state) {
    advance(events);
    measured += events;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(measured));
  state.counters["particles"] = particles;
  state.counters["queries_per_event"] =
      static_cast<double>(certifier.counters().verdict.calls - calls) / static_cast<double>(measured);
  if (taken > 0) state.counters["bytes_per_particle"] = taken / particles;
}

template <typename Build>
void add(const std::string& system, int size, Build build, Timing timing = Timing::certified,
         DetectorKind detector = DetectorKind::cells) {
  std::string name = system + "/" + std::to_string(size);
  if (timing == Timing::stable) name += "/stable";
  if (detector == DetectorKind::all_pairs) name += "/all-pairs";
  benchmark::RegisterBenchmark(
      name.c_str(), [=](benchmark::State& state) { measure(state, build(size), timing, detector); })
      ->Unit(benchmark::kMillisecond)
      ->Iterations(1);
}

void add_all() {
  const auto gas = [](int n) { return hard_spheres(n, 0.30); };
  const auto dense = [](int n) { return hard_spheres(n, 0.49); };
  const auto periodic = [](int n) { return periodic_spheres(n, 0.30); };
  const auto periodic_dense = [](int n) { return periodic_spheres(n, 0.49); };
  for (const int n : {1372, 10976, 97556, 1'000'000}) {
    add("spheres-0.30", n, gas);
    add("spheres-0.49", n, dense);
    add("periodic-0.30", n, periodic);
    add("periodic-0.49", n, periodic_dense);
  }
  add("periodic-0.30", 1372, periodic, Timing::stable);
  add("spheres-0.30", 1372, gas, Timing::stable);
  add("spheres-0.30", 97556, gas, Timing::stable);
  for (const int n : {1372, 10976}) add("spheres-0.30", n, gas, Timing::certified, DetectorKind::all_pairs);
  // Few spheres do not fill more of a membrane.
  const auto few = [](int n) { return hard_spheres(n, 0.20); };
  for (const int n : {8, 16, 32, 64}) {
    add("spheres-0.20", n, few);
    add("spheres-0.20", n, few, Timing::certified, DetectorKind::all_pairs);
  }
  for (const int n : {1000, 10'000, 100'000}) {
    add("chains-of-4", n, [](int size) { return chains(size, 4); });
    add("one-chain", n, [](int size) { return chains(size, size); });
  }
  for (const int n : {1000, 10'000}) {
    add("terminal", n, [](int size) { return terminal(size, false); });
    add("terminal-grouped", n, [](int size) { return terminal(size, true); });
  }
  for (const int n : {10'000, 100'000}) {
    add("sheet", n, [](int size) { return sheet(size, false); });
    add("sheet-grouped", n, [](int size) { return sheet(size, true); });
  }
}

}  // namespace
}  // namespace tps::scale

int main(int argc, char** argv) {
  tps::scale::add_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

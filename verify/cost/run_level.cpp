#include "verify/cost/run_level.hpp"

#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>

#include "reference/process/thread_time.hpp"
#include "reference/run/run.hpp"
#include "verify/cost/enclosed_run.hpp"
#include "verify/cost/traced_run.hpp"
#include "verify/cost/wanted.hpp"
#include "verify/scenes/gas.hpp"
#include "verify/scenes/three_body.hpp"

namespace tps::cost {
namespace {

constexpr int kSpheres = 20;

struct Measured {
  TracedRun traced;
  double events_per_second;
};

Measured run(const Scene& scene, const std::string& scalar, Timing timing, const RunLevelOptions& options) {
  RunOptions choice;
  choice.scalar = *scalar_kind(scalar);
  choice.timing = timing;
  choice.max_events = options.events;
  const double start = thread_seconds();
  const RunSummary timed = timed_run(scene, choice);
  const double seconds = thread_seconds() - start;
  return {traced_run(scene, choice), static_cast<double>(timed.events) / seconds};
}

RunRow row_of(const std::string& name, const std::string& scalar, Timing timing, const Measured& run,
              const TracedRun& truth) {
  const RunSummary& s = run.traced.summary;
  RunRow row;
  row.scene = name;
  row.scalar = scalar;
  row.timing = timing_names()[static_cast<std::size_t>(timing)];
  row.bits = bits_of(scalar);
  row.end = s.end;
  row.events = s.events;
  row.events_per_second = run.events_per_second;
  row.momentum_drift = s.momentum_drift;
  row.energy_remainder = s.energy_remainder;
  row.worst_excess = std::max(s.worst_inner_excess, s.worst_outer_excess);
  row.horizon = horizon(run.traced.events, truth.events);
  return row;
}

ProvenRow proven_row(const std::string& name, const Scene& scene, const EnclosedRunOptions& how,
                     const TracedRun& truth) {
  const EnclosedRun run = enclosed_run(scene, how);
  ProvenRow row{name, how.starts == Starts::rounding, static_cast<int>(how.bits), run.events.size(),
                run.ends_by};
  const std::size_t both = std::min(run.events.size(), truth.events.size());
  const auto parts = std::mismatch(run.events.begin(), run.events.begin() + static_cast<std::ptrdiff_t>(both),
                                   truth.events.begin());
  if (parts.second != truth.events.begin() + static_cast<std::ptrdiff_t>(both)) {
    row.parts_at = static_cast<std::uint64_t>(parts.first - run.events.begin());
  }
  return row;
}

/// Wide enough that half an ulp of a double, not the arithmetic, is what ends the proof.
constexpr long kBitsForEveryStart = 256;

void prove(RunLevel& level, const std::string& name, const Scene& scene, const RunLevelOptions& options,
           const TracedRun& truth) {
  std::vector<EnclosedRunOptions> ways = {{Starts::rounding, kBitsForEveryStart, options.events}};
  if (options.proves_stored) {
    for (const char* scalar : {"double", "quad", "mp100"})
      ways.push_back({Starts::stored, bits_of(scalar), options.events});
  }
  for (const EnclosedRunOptions& way : ways) {
    options.announce(name + " in enclosures, " + std::to_string(way.bits) + " bits");
    level.proven.push_back(proven_row(name, scene, way, truth));
  }
}

void add_scene(RunLevel& level, const std::string& name, const Scene& scene, const RunLevelOptions& options) {
  options.announce(name + " in mp100");
  const Measured truth = run(scene, "mp100", Timing::stable, options);
  std::vector<RunRow> rows;
  for (const std::string& scalar : scalar_names()) {
    options.announce(name + " in " + scalar);
    for (const Timing timing : {Timing::paper, Timing::stable, Timing::certified}) {
      if (!can_be_timed(*scalar_kind(scalar), timing)) continue;
      const bool is_truth = scalar == "mp100" && timing == Timing::stable;
      rows.push_back(
          row_of(name, scalar, timing, is_truth ? truth : run(scene, scalar, timing, options), truth.traced));
    }
  }
  prove(level, name, scene, options, truth.traced);
  level.rows.insert(level.rows.end(), rows.begin(), rows.end());
  const auto horizons = std::count_if(rows.begin(), rows.end(),
                                      [](const RunRow& r) { return r.timing == "stable" && r.horizon; });
  if (horizons >= 3) level.fits.push_back(fit_horizons(name, rows));
}

}  // namespace

int bits_of(const std::string& scalar) {
  return significant_bits(scalar_kind(scalar).value());
}

double HorizonFit::exponent() const {
  return std::log(2.0) / events_per_bit;
}

double HorizonFit::exponent_error() const {
  return exponent() * standard_error / events_per_bit;
}

HorizonFit fit_horizons(const std::string& scene, const std::vector<RunRow>& rows) {
  std::vector<double> bits, horizons;
  for (const RunRow& row : rows) {
    if (row.scene != scene || row.timing != "stable" || !row.horizon) continue;
    bits.push_back(row.bits);
    horizons.push_back(static_cast<double>(*row.horizon));
  }
  double intercept = 0, slope = 0, cov00 = 0, cov01 = 0, cov11 = 0, residual = 0;
  gsl_fit_linear(bits.data(), 1, horizons.data(), 1, bits.size(), &intercept, &slope, &cov00, &cov01, &cov11,
                 &residual);
  return {scene, static_cast<int>(bits.size()), slope, std::sqrt(cov11)};
}

std::vector<std::string> run_scenes() {
  return {"gas", "three-body"};
}

RunLevel measure_runs(const RunLevelOptions& options) {
  RunLevel level;
  level.seed = options.seed;
  level.events = options.events;
  GasParams gas;
  gas.particles = kSpheres;
  gas.seed = options.seed;
  gas.duration = 1e6;
  for (const std::string& name : run_scenes()) {
    if (!is_wanted(options.scenes, name)) continue;
    add_scene(level, name, name == "gas" ? build_gas(gas) : build_three_body({}), options);
  }
  return level;
}

}  // namespace tps::cost

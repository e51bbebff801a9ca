#include "verify/cost/run_level.hpp"

#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "verify/cost/traced_run.hpp"
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
  const RunSummary timed = timed_run(scene, choice);
  return {traced_run(scene, choice), static_cast<double>(timed.events) / timed.seconds};
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
  level.rows.insert(level.rows.end(), rows.begin(), rows.end());
  const auto horizons = std::count_if(rows.begin(), rows.end(),
                                      [](const RunRow& r) { return r.timing == "stable" && r.horizon; });
  if (horizons >= 3) level.fits.push_back(fit_horizons(name, rows));
}

}  // namespace

int bits_of(const std::string& scalar) {
  static const std::map<std::string, int> bits = {{"float", 24}, {"double", 53}, {"long-double", 64},
                                                  {"quad", 113}, {"mp50", 168},  {"mp100", 334}};
  return bits.at(scalar);
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

RunLevel measure_runs(const RunLevelOptions& options) {
  RunLevel level;
  level.seed = options.seed;
  level.events = options.events;
  GasParams gas;
  gas.particles = kSpheres;
  gas.seed = options.seed;
  gas.duration = 1e6;
  add_scene(level, "gas", build_gas(gas), options);
  add_scene(level, "three-body", build_three_body({}), options);
  return level;
}

}  // namespace tps::cost

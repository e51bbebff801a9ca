#include "verify/cost/run_level.hpp"

#include <fmt/format.h>
#include <gsl/gsl_fit.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>

#include "reference/process/interrupt.hpp"
#include "verify/certified/exact_timing.hpp"
#include "verify/scenes/gas.hpp"
#include "verify/scenes/three_body.hpp"

namespace tps::cost {
namespace {

constexpr int kSpheres = 20;
const std::map<std::string, int> kBits = {{"float", 24}, {"double", 53}, {"long-double", 64},
                                          {"quad", 113}, {"mp50", 168},  {"mp100", 334}};

/// A file that is gone with its owner.
class TemporaryFile {
 public:
  TemporaryFile() : path_((std::filesystem::temp_directory_path() / "tps-cost-XXXXXX").string()) {
    const int file = mkstemp(path_.data());
    if (file < 0) throw std::runtime_error("no temporary file can be made in " + path_);
    close(file);
  }
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Kind and pair of each event of a trace, as its lines spell them.
std::vector<std::string> events_of(const std::string& trace) {
  std::vector<std::string> events;
  std::ifstream file(trace);
  for (std::string line; std::getline(file, line);) {
    const std::size_t from = line.find("\"kind\":");
    if (!line.starts_with("{\"k\":") || from == std::string::npos) continue;
    events.push_back(line.substr(from, line.find(",\"pre\"", from) - from));
  }
  return events;
}

struct Run {
  RunRow row;
  std::vector<std::string> events;
};

Run run(const std::string& name, const Scene& scene, const std::string& scalar, Timing timing,
        const RunLevelOptions& options) {
  interrupt::check();
  const TemporaryFile trace;
  certified::ExactTiming certifier;
  RunOptions choice;
  choice.scalar = *scalar_kind(scalar);
  choice.timing = timing;
  if (timing == Timing::certified) choice.certifier = &certifier;
  choice.max_events = options.events;
  // Timed without a trace, which costs more than the events.
  const RunSummary summary = run_scene(scene, choice);
  choice.trace = trace.path();
  run_scene(scene, choice);
  Run result{{}, events_of(trace.path())};
  result.row.scene = name;
  result.row.scalar = scalar;
  result.row.timing = timing_names()[static_cast<std::size_t>(timing)];
  result.row.bits = kBits.at(scalar);
  result.row.events = summary.events;
  result.row.events_per_second = static_cast<double>(summary.events) / summary.seconds;
  result.row.momentum_drift = summary.momentum_drift;
  result.row.energy_remainder = summary.energy_remainder;
  return result;
}

void add_scene(RunLevel& level, const std::string& name, const Scene& scene, const RunLevelOptions& options) {
  const Run truth = run(name, scene, "mp100", Timing::stable, options);
  std::vector<RunRow> rows;
  for (const std::string& scalar : scalar_names()) {
    for (const Timing timing : {Timing::paper, Timing::stable, Timing::certified}) {
      if (!can_be_timed(*scalar_kind(scalar), timing)) continue;
      Run one =
          scalar == "mp100" && timing == Timing::stable ? truth : run(name, scene, scalar, timing, options);
      const auto [at, other] =
          std::mismatch(one.events.begin(), one.events.end(), truth.events.begin(), truth.events.end());
      if (at != one.events.end() || other != truth.events.end()) {
        one.row.horizon = static_cast<std::uint64_t>(at - one.events.begin());
      }
      rows.push_back(one.row);
    }
  }
  level.rows.insert(level.rows.end(), rows.begin(), rows.end());
  const auto horizons = std::count_if(rows.begin(), rows.end(),
                                      [](const RunRow& r) { return r.timing == "stable" && r.horizon; });
  if (horizons >= 3) level.fits.push_back(fit_horizons(name, rows));
}

}  // namespace

double HorizonFit::exponent() const {
  return std::log(2.0) / events_per_bit;
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
  GasParams gas;
  gas.particles = kSpheres;
  gas.seed = options.seed;
  gas.duration = 1e6;
  add_scene(level, "gas", build_gas(gas), options);
  add_scene(level, "three-body", build_three_body({}), options);
  return level;
}

std::string runs_text(const RunLevel& level) {
  std::string text = fmt::format("{:<12}{:<13}{:<11}{:>7}{:>11}{:>10}{:>14}{:>14}\n", "scene", "scalar",
                                 "timing", "events", "events/s", "horizon", "momentum off", "energy off");
  for (const RunRow& row : level.rows) {
    text += fmt::format("{:<12}{:<13}{:<11}{:>7}{:>11.3g}{:>10}{:>14.1e}{:>14.1e}\n", row.scene, row.scalar,
                        row.timing, row.events, row.events_per_second,
                        row.horizon ? std::to_string(*row.horizon) : "all", row.momentum_drift,
                        row.energy_remainder);
  }
  for (const HorizonFit& fit : level.fits) {
    text += fmt::format(
        "{}: {:.2f} +- {:.2f} events a bit ({} scalars): disturbances grow by exp({:.3f}) an event\n",
        fit.scene, fit.events_per_bit, fit.standard_error, fit.points, fit.exponent());
  }
  return text;
}

}  // namespace tps::cost

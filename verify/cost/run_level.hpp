// What a run costs in each scalar and timing, and how long it stays the run that a hundred digits make of the
// same scene.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reference/run/run.hpp"

namespace tps::cost {

/// One run of a scene.
struct RunRow {
  std::string scene, scalar, timing;
  int bits = 0;
  std::string end;  ///< as in RunSummary
  std::uint64_t events = 0;
  double events_per_second = 0;
  double momentum_drift = 0, energy_remainder = 0;  ///< as in RunSummary
  double worst_excess = 0;  ///< beyond a limit at an event, in ulps of the pair's largest coordinate
  /// Events, in order, that are those of the run in mp100 (kind and pair); absent where all are.
  std::optional<std::uint64_t> horizon = std::nullopt;
};

/// A straight line through the horizons of one scene under stable timing, by least squares.
struct HorizonFit {
  std::string scene;
  int points = 0;
  double events_per_bit = 0, standard_error = 0;

  /// A disturbance doubles in events_per_bit events: the exponent of its growth an event (Lyapunov's), …
  double exponent() const;
  /// … and its standard error, to first order: exponent · standard_error / events_per_bit.
  double exponent_error() const;
};

/// The events of a scene that are proven (enclosed_run.hpp).
struct ProvenRow {
  std::string scene;
  bool every_start = true;  ///< for every start that rounds to the stored one; else for the stored one alone
  int bits = 0;             ///< of the arithmetic
  std::uint64_t events = 0;
  std::string ends_by;  ///< as in EnclosedRun
  /// Of these, in order, the events that the run in mp100 has, too; absent where it has all that it is long
  /// enough for.
  std::optional<std::uint64_t> parts_at = std::nullopt;
};

struct RunLevel {
  std::uint64_t seed = 1;
  std::uint64_t events = 0;  ///< at most, of each run
  std::vector<RunRow> rows;
  std::vector<ProvenRow> proven;
  std::vector<HorizonFit> fits;  ///< of scenes with three horizons or more
};

/// Told before each piece of work what it is.
using Announce = std::function<void(const std::string&)>;

struct RunLevelOptions {
  std::uint64_t seed = 1;
  std::uint64_t events = 3000;  ///< at most, of each run
  bool proves_stored = true;    ///< also what the stored start proves, in 53, 113 and 334 bits: two minutes
  std::vector<std::string> scenes;  ///< of run_scenes(); empty: all
  Announce announce = [](const std::string&) {};
};

/// Bits of the significand of a scalar, by its name in scalar_names().
int bits_of(const std::string& scalar);

/// A gas of twenty spheres, and the paper's X-Y-Z.
std::vector<std::string> run_scenes();

RunLevel measure_runs(const RunLevelOptions& options);

/// REQUIRES three rows with a horizon or more.
HorizonFit fit_horizons(const std::string& scene, const std::vector<RunRow>& rows);

}  // namespace tps::cost

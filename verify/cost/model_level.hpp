// What the two numbers that the paper leaves to whoever models cost and buy: Δt_restitute of grouping (eqs. 6
// and 7) and θ_revolve of revolution (eq. 5).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "verify/cost/run_level.hpp"

namespace tps::cost {

/// One run of a scene, grouped with dt_restitute.
struct GroupingRow {
  std::string scene;
  double dt_restitute = 0;
  std::string end;               ///< as in RunSummary
  std::uint64_t collisions = 0;  ///< rebounds, retractions, revolutions
  std::uint64_t events = 0;      ///< those, restitutions, and what the scene brings from outside
  std::uint64_t largest_group = 0;
  /// The largest |v' − v| of a particle at the end, the first one having come with 1; v is the scene's
  /// truth. Absent where trajectories are chaotic: there no particle's velocity says anything.
  std::optional<double> distance;
  /// Collisions, in order, that are those of the ungrouped run; absent where all are, and where that run has
  /// no end.
  std::optional<std::uint64_t> horizon;
  double kinetic = 0;  ///< at the end, over that at the start
};

/// What grouped runs of a scene are compared with.
struct GroupingTruth {
  std::string scene, what;
  std::string end;               ///< of the ungrouped run
  std::uint64_t collisions = 0;  ///< of the ungrouped run
  double kinetic = 0;            ///< at its end, over that at its start
};

/// A pair that circles on a taut tether, from a tangential start, with c_retract = 1/2.
///
/// In real arithmetic 180°/θ revolutions (eq. 5) make one turn; a turn takes 1 − c_revolve² of the energy and
/// 1 − c_revolve of the angular momentum; and the first one, which bends a tangent by θ, takes
/// 1 − c_revolve^(θ/π) cos θ of the angular momentum once.
struct RevolutionRow {
  double theta_deg = 0, c_revolve = 1;
  std::uint64_t events = 0;      ///< simulated, behind the first
  double events_a_turn = 0;      ///< by the angle between the first two
  double energy_a_turn = 0;      ///< share lost; by all of them
  double momentum_a_turn = 0;    ///< share of the angular momentum lost; by all of them
  double momentum_at_first = 0;  ///< share of the angular momentum lost at the first
};

struct ModelLevel {
  std::uint64_t seed = 1;
  std::vector<GroupingTruth> truths;
  std::vector<GroupingRow> grouping;
  std::vector<RevolutionRow> revolution;
};

struct ModelLevelOptions {
  std::uint64_t seed = 1;
  std::vector<std::string> scenes;  ///< of model_scenes(); empty: all
  Announce announce = [](const std::string&) {};
};

/// Those of grouping, and "revolution".
std::vector<std::string> model_scenes();

/// Scenes of grouping: X-Y-Z with c = 1, whose truth has 70 collisions, and c = 1/2, which collapses; the
/// cradle; the terminal.
ModelLevel measure_model(const ModelLevelOptions& options);

/// The parts of it: grouping_level.cpp, revolution_level.cpp.
void measure_grouping(ModelLevel& level, const ModelLevelOptions& options);
void measure_revolution(ModelLevel& level, const ModelLevelOptions& options);

}  // namespace tps::cost

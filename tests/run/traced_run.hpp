// A run with its trace read back, so that tests look at what a reader of the file would see.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reference/run/run.hpp"
#include "reference/scene/scene.hpp"

namespace tps::testing {

struct TracedParticle {
  std::vector<double> position, velocity;  ///< to the nearest double
  std::vector<std::string> exact_position, exact_velocity;
};

struct TracedEvent {
  std::uint64_t k = 0;
  std::string exact_t, exact_dt, exact_s, kind, tether;
  double t = 0, dt = 0, s = 0;  ///< under drag dt is that of s
  int i = -1, j = -1;
  std::map<int, TracedParticle> pre, post;  ///< by id
  std::vector<double> dp, dp_stored;
  std::optional<double> draw;
  std::vector<int> members;
  int phase = -1;
};

struct TracedRun {
  RunSummary summary;
  std::string bytes;  ///< the whole trace
  std::vector<std::string> lines;
  std::vector<TracedEvent> events;
};

/// A file name of the running test's own.
std::string scratch(const std::string& name);
std::string read_bytes(const std::string& path);
void write_bytes(const std::string& path, const std::string& bytes);

/// Runs a scene with a trace in a scratch file. Options as for run_scene.
TracedRun traced(const Scene& scene, RunOptions options = {});
TracedRun traced(const Scene& scene, const std::string& scalar, std::optional<std::uint64_t> max_events = {});
/// The bytes of its trace alone, which nobody has to read back.
std::string traced_bytes(const Scene& scene, RunOptions options);

/// The events of a trace.
std::vector<TracedEvent> events_of(const std::string& bytes);

/// From the last full state of a trace, each particle brought to its time, in the order of ids.
std::vector<Coordinates> positions_at_the_end(const TracedRun& run);

/// Runs that end by event count (max_events).
RunOptions options_for(const std::string& scalar, std::optional<std::uint64_t> max_events = {});

/// A scene in 2-D (without duration limit) with one species "p" of mass 1 and radius 0.5 and no law.
Scene plain_scene(int dimension = 2);
/// Adds a species and gives its index.
int add_species(Scene& scene, const std::string& name, double mass, double radius);
/// Adds a particle of a species and gives its index (which is its id).
int add_particle(Scene& scene, int species, Coordinates position, Coordinates velocity = {});
/// Blocks species a and b at the sum of their radii.
PairLaw& block(Scene& scene, int a, int b, double c_rebound = 1);
/// Gives the pair of species a tether.
PairLaw& tether(Scene& scene, int a, int b, double distance, double c_retract = 1,
                FormRule::When form = FormRule::When::never);

}  // namespace tps::testing

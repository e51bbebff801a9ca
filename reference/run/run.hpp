// A whole run: scene in, trace and summary out, in whichever scalar the caller names.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/engine/detector_kind.hpp"
#include "reference/engine/timing.hpp"
#include "reference/scalar_kind.hpp"
#include "reference/scene/scene.hpp"

namespace tps {

/// "paper", "stable", "certified", in the order of Timing.
const std::vector<std::string>& timing_names();
/// Nothing for an unknown name.
std::optional<Timing> timing_named(std::string_view name);
/// "automatic", "all-pairs", "cells", in the order of DetectorKind.
const std::vector<std::string>& detector_names();
/// Nothing for an unknown name.
std::optional<DetectorKind> detector_named(std::string_view name);
/// Whether runs in a scalar can be timed so: certified timing is for float and double.
bool can_be_timed(ScalarKind scalar, Timing timing);

struct RunOptions {
  ScalarKind scalar = ScalarKind::double_;
  Timing timing = Timing::stable;
  CertifiedTiming* certifier = nullptr;             ///< answers for Timing::certified, and counts
  DetectorKind detector = DetectorKind::automatic;  ///< changes how long a run takes and nothing else
  std::optional<double> until;                      ///< instead of the scene's duration
  std::optional<std::uint64_t> max_events;          ///< ends after the first step that reaches it
  std::uint64_t state_every = 0;  ///< a full state every so many events; 0: default_state_every
  std::string trace;              ///< file to write, "-" for standard output, empty for none
  std::string checkpoint;         ///< file that always holds the latest full state, empty for none
  const std::atomic<bool>* interrupt = nullptr;  ///< ends the run, in good order, once it is true

  struct Progress {
    double t, duration;  ///< since the start, to about a double's precision
    std::uint64_t events;
  };
  std::function<void(const Progress&)> progress;  ///< called about ten times a second
};

/// 1000, or 10 N for scenes of more than 100 particles: states stay a small part of the trace.
std::uint64_t default_state_every(const Scene& scene);

/// Clusters at one moment: connected components of tethers with at least so many particles of a species.
/// Sizes are of all of them; extent and speeds are of one: the largest or, around an impulse, the one that
/// holds the particle pushed.
struct ClusterSample {
  double t = 0;          ///< since the start
  std::string occasion;  ///< "sample", or "before impulse", "after impulse", "later" with the particle's id;
                         ///< "end" in a summary, where a run was cut short
  std::vector<int> sizes;     ///< particles of the observed species, descending
  int described = 0;          ///< size of the cluster that the rest is about; 0: none
  int particles = 0;          ///< of any species in it
  double mass = 0;            ///< of those of finite mass, as everything below
  double extent = 0;          ///< root mean square distance from the centre of mass, weighted by mass
  double relative_speed = 0;  ///< root mean square velocity relative to the centre's, weighted by mass
  double centre_speed = 0;    ///< of its centre of mass
  std::array<double, 3> centre_velocity{};  ///< of its centre of mass
};

/// What one effect has done to the energy of a run: "work" or "heat" that it gave, what was "lost" at it,
/// what it has "taken" or "stored" (docs/ledger.md, "Effect by effect").
struct EffectEnergy {
  std::string effect, what;
  double energy = 0;
};

/// What `tps run` says at the end. Energies are relative to the infinite masses (ledger.hpp).
struct RunSummary {
  std::string title, scalar, end;
  double t = 0;         ///< of the end, since the start
  std::string exact_t;  ///< the same on the scene's clock, hexadecimal
  std::uint64_t events = 0;
  std::map<std::string, std::uint64_t> by_kind;
  double seconds = 0;                       ///< of this process
  std::uint64_t events_here = 0;            ///< of this process
  std::optional<TimingCounters> certified;  ///< of this process, under certified timing

  double momentum_drift = 0, momentum_bound = 0;
  double kinetic_at_start = 0, kinetic = 0, stored = 0, lost = 0, work = 0;
  std::optional<double> drag_taken;           ///< kinetic energy that drag has taken, where there is drag
  std::optional<double> spin_at_start, spin;  ///< energy of spins, where particles keep them
  std::vector<EffectEnergy> by_effect;        ///< of the effects that the scene calls for
  double energy_remainder = 0, energy_bound = 0;
  double worst_inner_excess = 0,
         worst_outer_excess = 0;  ///< in ulps of the pair's largest coordinate, at events
  double audit_inner_excess = 0, audit_outer_excess = 0;  ///< the same over all pairs at the end

  bool observes_clusters = false;
  std::string cluster_species;
  std::vector<ClusterSample> clusters;

  bool grouping = false;
  double dt_restitute = 0;
  std::uint64_t largest_group = 0;
  double oldest_group = 0;
  std::uint64_t live_groups = 0;
  std::uint64_t noise = 0, first_noise = 0, zero_impulse = 0;  ///< as in Statistics
  std::uint64_t particles = 0;

  struct Final {
    std::int32_t id;
    std::string species;
    std::vector<std::string> position, velocity;  ///< decimal, to the scalar's precision
  };
  std::vector<Final> final_states;  ///< at the end, where there are at most kFewParticles
  static constexpr std::size_t kFewParticles = 12;

  std::string out_of_range;  ///< which number left the range of the scalar, where that ended the run
  std::vector<std::string>
      stalled_on;  ///< ids and species of the particles of the last events, if the run stalled
};

/// Simulates a scene. Throws OutputError when a result cannot be written, InputError where the scene cannot
/// be held in the scalar. REQUIRES can_be_timed(), and a certifier where the timing is certified.
RunSummary run_scene(const Scene& scene, const RunOptions& options);

/// What a trace or a checkpoint says before its first event.
struct TraceHead {
  Scene scene;
  int semantics = 0;
  ScalarKind scalar = ScalarKind::double_;
  Timing timing = Timing::stable;
  std::uint64_t state_every = 0;
};

/// Reads the first line of a trace or checkpoint. Throws InputError.
TraceHead read_trace_head(const std::string& path);

/// Goes on from the last full state of a trace or checkpoint. Scene, scalar, timing and state_every are the
/// file's;
/// events behind that state are simulated again, with the same result. The trace goes to options.trace, which
/// may be the same file. REQUIRES a certifier, which a file with certified timing needs. Throws InputError,
/// OutputError.
RunSummary resume_run(const std::string& path, const RunOptions& options);

}  // namespace tps

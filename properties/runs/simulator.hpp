// What a law of runs asks of an implementation: simulate a scene, and tell what happened in a trace.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "properties/runs/judge.hpp"
#include "properties/runs/trace.hpp"
#include "reference/scene/scene.hpp"

namespace tps::properties::runs {

/// Where a run ends, how often its trace holds a full state (0: as the implementation likes), and how its
/// collisions are found (empty: as the implementation likes).
struct Extent {
  std::uint64_t max_events = 100;
  std::uint64_t state_every = 0;
  std::string detector = {};
};

/// An implementation, in one scalar and one way of timing.
class Simulator {
 public:
  virtual ~Simulator() = default;
  virtual std::string name() const = 0;
  virtual std::string scalar() const = 0;  ///< as in the header of a trace
  virtual std::string timing() const = 0;  ///< as in the header of a trace

  /// Its ways of finding collisions, where it has several: values of Extent::detector.
  virtual std::vector<std::string> detectors() const { return {}; }

  /// The whole trace of a run of a valid scene.
  virtual std::string simulate(const Scene& scene, const Extent& extent) = 0;

  /// The whole trace of the run that goes on from the beginning of a trace; nothing where it cannot.
  virtual std::optional<std::string> go_on(const std::string& beginning, const Extent& extent) = 0;

  /// The same. Throws MinimalTrace where it is one.
  std::string full_trace(const Scene& scene, const Extent& extent) {
    std::string bytes = simulate(scene, extent);
    if (is_minimal(bytes)) throw MinimalTrace(std::move(bytes));
    return bytes;
  }
  RunTrace run(const Scene& scene, const Extent& extent = {}) {
    return read_trace(full_trace(scene, extent));
  }
  Real roundoff() const { return judged_roundoff(scalar()); }
};

/// The reference in this process. `timing` may be paper or stable, and certified for float and double.
/// REQUIRES known names.
std::unique_ptr<Simulator> reference_simulator(const std::string& scalar, const std::string& timing);

/// What a command has for one run of a generated scene, which the reference ends in well below a second.
constexpr std::chrono::milliseconds kTimeOfARun{60'000};

/// Any command that simulates as `tps run` does: COMMAND SCENE -o TRACE --scalar … --timing … --max-events …
/// [--state-every …], and COMMAND --resume TRACE -o OTHER --max-events …. Its traces are read as they come,
/// so a command that fails, writes something else or does not end in time throws std::runtime_error with the
/// command and its end. REQUIRES words, the first not empty; no shell reads them.
std::unique_ptr<Simulator> command_simulator(const std::vector<std::string>& words, const std::string& scalar,
                                             const std::string& timing,
                                             std::chrono::milliseconds limit = kTimeOfARun);

}  // namespace tps::properties::runs

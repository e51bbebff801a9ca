// Runs that are cut and taken up again, and runs that are turned round.
#include <algorithm>
#include <cmath>

#include "properties/runs/laws.hpp"
#include "properties/runs/reversal.hpp"

namespace tps::properties::runs {
namespace {

/// Cut within a line as well as between lines; behind the first full state, which every trace has at its
/// start.
RunVerdict resumes(const Scene& scene, Simulator& simulator) {
  const Extent extent{.max_events = 60, .state_every = 7};
  const std::string whole = simulator.full_trace(scene, extent);
  const std::size_t start = whole.find('\n', whole.find("\n{\"state\":") + 1) + 1;
  for (std::size_t parts = 0; parts <= 3; ++parts) {
    const std::size_t cut = start + (whole.size() - start) * parts / 3;
    const std::optional<std::string> resumed = simulator.go_on(whole.substr(0, cut), extent);
    if (!resumed) return RunVerdict::not_asked();
    if (*resumed != whole)
      return RunVerdict::broken("a trace of " + std::to_string(whole.size()) +
                                " bytes goes on otherwise behind its first " + std::to_string(cut));
  }
  return {};
}

/// Every detector from the start, and from every full state one of them in turn.
RunVerdict same_with_every_detector(const Scene& scene, Simulator& simulator) {
  const std::vector<std::string> detectors = simulator.detectors();
  if (detectors.empty()) return RunVerdict::not_asked();
  Extent extent{.max_events = 40, .state_every = 13, .detector = detectors.front()};
  const std::string whole = simulator.full_trace(scene, extent);
  for (const std::string& detector : detectors) {
    extent.detector = detector;
    if (simulator.full_trace(scene, extent) != whole)
      return RunVerdict::broken("detector " + detector + " and " + detectors.front() + " differ");
  }
  std::size_t turn = 0;
  for (std::size_t at = whole.find("\n{\"state\":"); at != std::string::npos;
       at = whole.find("\n{\"state\":", at + 1)) {
    const std::string beginning = whole.substr(0, whole.find('\n', at + 1) + 1);
    extent.detector = detectors[++turn % detectors.size()];
    const std::optional<std::string> resumed = simulator.go_on(beginning, extent);
    if (!resumed) return RunVerdict::not_asked();
    if (*resumed != whole)
      return RunVerdict::broken("a run resumed by detector " + extent.detector + " behind byte " +
                                std::to_string(beginning.size()) + " goes on otherwise");
  }
  return {};
}

bool same_course(const RunTrace& a, const RunTrace& b) {
  return std::ranges::equal(a.events, b.events, [](const TracedEvent& x, const TracedEvent& y) {
    return x.kind == y.kind && x.i == y.i && x.j == y.j;
  });
}

Real largest_number(const Scene& scene) {
  double largest = 0;
  for (const Particle& p : scene.particles) {
    for (std::size_t k = 0; k < 3; ++k)
      largest = std::max({largest, std::abs(p.position[k]), std::abs(p.velocity[k])});
  }
  return largest;
}

/// The scene with a duration in which its run has fewer events than a run is given; nothing where all happen
/// at the start.
std::optional<Scene> finishing(const Scene& scene, Simulator& simulator, const Extent& extent) {
  const RunTrace run = simulator.run(scene, extent);
  if (run.end == "duration") return scene;
  Scene shorter = scene;
  shorter.duration = static_cast<double>(run.end_time.hi * 0.999L);
  if (!(shorter.duration > 0)) return std::nullopt;
  return shorter;
}

/// There and back. The growth of errors is measured on the way back: a run from a state √u beside the one
/// where the run was turned parts from it by `growth` √u. An event errs by at most 64 u (docs/ledger.md,
/// docs/eq2.md), so 2n of them by 128 n u growth; the one direction in which growth was measured can miss the
/// steepest by 128.
RunVerdict returns(const Scene& scene, Simulator& simulator) {
  const Extent extent{.max_events = 100, .state_every = 0};
  const Extent back{.max_events = 300, .state_every = 0};
  const Real u = roundoff_of(simulator.scalar());
  const std::optional<Scene> finite = finishing(scene, simulator, extent);
  if (u == 0 || !finite) return RunVerdict::not_asked();
  const RunTrace there = simulator.run(*finite, extent);
  const auto reversible = [](const TracedEvent& e) { return e.kind == "rebound" || e.kind == "retract"; };
  if (there.end != "duration" || there.events.empty() || !std::ranges::all_of(there.events, reversible))
    return RunVerdict::not_asked();

  const Real size = largest_number(*finite), shift = std::sqrt(u) * size;
  const auto going_back = [&](Real by) {
    return simulator.go_on(turned_round(there, *finite, simulator.scalar(), by), back);
  };
  const std::optional<std::string> turned = going_back(0), beside = going_back(shift);
  if (!turned || !beside) return RunVerdict::not_asked();
  const RunTrace returned = read_trace(*turned), neighbour = read_trace(*beside);
  const Real growth = std::max(Real(1), parted(returned, neighbour, *finite) / shift);
  if (growth * shift > size / 1000 || !same_course(returned, neighbour)) return RunVerdict::not_asked();

  const Real error = away_from_start(returned, *finite);
  return RunVerdict::of(beyond(
      "after " + std::to_string(there.events.size()) + " events and back the largest distance from the start",
      error, 128 * 128 * Real(there.events.size()) * u * growth * size));
}

}  // namespace

std::vector<RunLaw> continuation_laws() {
  Wanted reversible;
  reversible.grouping = Wanted::Choice::never;
  reversible.outside = reversible.draws = reversible.dissipation = reversible.changing_tethers =
      reversible.ties = false;
  RunLaw resume{19,
                "Resume",
                "A trace cut anywhere behind its first full state goes on to the same bytes.",
                "docs/trace.md",
                of({}),
                resumes};
  resume.compares_runs = true;
  RunLaw reversal{20,
                  "Reversal",
                  "With c = 1, without groups, revolution and outside, a run whose velocities are reversed "
                  "comes back to its start, as closely as its scalar and the growth of errors allow.",
                  "docs/engine.md",
                  of(reversible),
                  returns};
  reversal.compares_runs = true;
  RunLaw detectors{
      23,
      "Detectors",
      "Whom the detector asks changes no byte of a trace, from the start or from any full state.",
      "docs/scale.md",
      of({}),
      same_with_every_detector};
  detectors.compares_runs = true;
  return {resume, reversal, detectors};
}

}  // namespace tps::properties::runs

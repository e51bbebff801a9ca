// Clusters of vesicles form from isolated vesicles and pairs of synapsins.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "verify/claims/claim.hpp"
#include "verify/claims/runs.hpp"
#include "verify/claims/terminal_runs.hpp"

namespace tps::claims {

Claim clusters() {
  Claim claim{
      "clusters",
      "Clusters form during the run from isolated vesicles and pairs of synapsins inside a rigid membrane.",
      "Deformable biological structures, Figure 1",
      scene_and_run("terminal", "terminal"),
      {}};
  for (const std::uint64_t seed : kTerminalSeeds) {
    const RunSummary& run = terminal_run(seed);
    const auto figure = [seed](const char* what) { return fmt::format("{}, seed {}", what, seed); };
    const std::vector<int>& at_start = run.clusters.front().sizes;
    const std::vector<int>& at_end = run.clusters.back().sizes;
    claim.figures.push_back(same(figure("end"), "duration", "no stall", run.end));
    claim.figures.push_back(exactly(figure("clusters at the start"), 0, "vesicles have no tether",
                                    static_cast<long long>(at_start.size())));
    claim.figures.push_back(between(figure("clusters at the end"), 1, 16, "48 vesicles, at least 3 a cluster",
                                    static_cast<double>(at_end.size()), 3));
    claim.figures.push_back(between(figure("vesicles in clusters at the end"), 24, 48,
                                    "at least half of 48 (our reading of the picture)",
                                    std::accumulate(at_end.begin(), at_end.end(), 0), 3));
    claim.figures.push_back(between(figure("energy not accounted for, over its bound"), 0, 1,
                                    "the ledger is closed (docs/ledger.md)",
                                    std::abs(run.energy_remainder) / run.energy_bound, 1));
    const double excess = std::max(
        {run.worst_inner_excess, run.worst_outer_excess, run.audit_inner_excess, run.audit_outer_excess});
    // Each coordinate of each of the two is rounded on its way to the event, by time and by place.
    claim.figures.push_back(between(figure("distances beyond a limit, in ulps"), 0, 8,
                                    "roundings of time and places at an event", excess, 2));
  }
  return claim;
}

}  // namespace tps::claims

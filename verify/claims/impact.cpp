// How a cluster takes an impact.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "verify/claims/claim.hpp"
#include "verify/claims/runs.hpp"
#include "verify/claims/terminal_runs.hpp"
#include "verify/scenes/terminal.hpp"

namespace tps::claims {
namespace {

/// The cluster of a vesicle before, just after and some time after an impulse on it.
struct Hit {
  ClusterSample before, after, later;
};

/// The impacts of a run that hit a cluster.
std::vector<Hit> hits(const RunSummary& run) {
  std::vector<Hit> found;
  for (const ClusterSample& sample : run.clusters) {
    const std::string before = "before impulse", after = "after impulse", later = "later";
    if (sample.occasion.rfind(before, 0) != 0 || sample.described == 0) continue;
    const std::string particle = sample.occasion.substr(before.size());
    const auto at = [&](const std::string& occasion) {
      return *std::find_if(run.clusters.begin(), run.clusters.end(),
                           [&](const ClusterSample& other) { return other.occasion == occasion + particle; });
    };
    found.push_back({sample, at(after), at(later)});
  }
  return found;
}

double length(const std::array<double, 3>& v) {
  return std::hypot(v[0], v[1], v[2]);
}

void add_hit(Claim& claim, const std::string& place, const Hit& hit) {
  const TerminalParams params;
  const ClusterSample& before = hit.before;
  const double J = params.impact, M = before.mass, m = params.vesicle_mass;
  // The centre: J changes the momentum of the cluster, whatever the inside does.
  std::array<double, 3> error{};
  for (std::size_t k = 0; k < 3; ++k) {
    error[k] = hit.after.centre_velocity[k] - before.centre_velocity[k] - (k == 0 ? J / M : 0);
  }
  // A mean of n velocities has n roundings, of partial sums that weigh no more than all speeds; the vesicle
  // hit adds J/m. Speeds are below the thermal 1 or the impact's J/m = 10.
  const double tolerance = before.particles * std::numeric_limits<double>::epsilon() * (J / m);
  claim.figures.push_back(between("jump of the centre's velocity − J/M, " + place, 0, tolerance,
                                  fmt::format("J/M = {:.4g} along x; n ε J/m", J / M), length(error), 2));
  // The inside: M s² changes by 2 J·w + J² (1/m − 1/M), w the velocity of the vesicle relative to the centre,
  // of which m |w|² (1 + m/(M − m)) ≤ M s² is known.
  const double s = before.relative_speed;
  const double w = s * std::sqrt((M - m) / m);
  const auto speed = [&](double cross) {
    return std::sqrt(std::max(0.0, s * s + (2 * J * cross + J * J * (1 / m - 1 / M)) / M));
  };
  claim.figures.push_back(between("relative speed at once, " + place, speed(-w), speed(w),
                                  fmt::format("from {:.3g}; exact but for the vesicle's own motion", s),
                                  hit.after.relative_speed, 3));
  claim.figures.push_back(between("relative speed later, " + place, 0, hit.after.relative_speed,
                                  "collisions inside cost energy", hit.later.relative_speed, 3));
  constexpr double kDeformation = 0.15;
  claim.figures.push_back(between("extent later, " + place, (1 - kDeformation) * before.extent,
                                  (1 + kDeformation) * before.extent,
                                  "deforms by some per cent, holds together", hit.later.extent, 4));
  claim.figures.push_back(between("vesicles in it later, " + place, before.described, params.vesicles,
                                  "no tether breaks", hit.later.described, 3));
}

}  // namespace

Claim impact() {
  Claim claim{"impact",
              "Clusters react realistically to impacts.",
              "Deformable biological structures, Figure 1",
              scene_and_run("terminal --seed 2", "terminal"),
              {}};
  for (const std::uint64_t seed : kTerminalSeeds) {
    const std::vector<Hit> found = hits(terminal_run(seed));
    claim.figures.push_back(between(fmt::format("impacts on a cluster, seed {}", seed), 1, 3,
                                    "three impacts on given vesicles, most of which are in clusters",
                                    static_cast<double>(found.size()), 3));
    for (const Hit& hit : found) {
      add_hit(claim, fmt::format("seed {}, t = {:g}", seed, hit.before.t), hit);
    }
  }
  return claim;
}

}  // namespace tps::claims

// Four collisions a revolution at 45 degrees, each keeping 0.5^(1/4) of the speed.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "verify/claims/claim.hpp"
#include "verify/claims/runs.hpp"
#include "verify/scenes/pair.hpp"

namespace tps::claims {
namespace {

RunSummary after_events(std::uint64_t events) {
  RunOptions options;
  options.max_events = events;
  return run_scene(build_pair({}), options);
}

struct Relative {
  double speed, direction;  ///< |v|, and its angle in radians
};

Relative relative_motion(const RunSummary& s) {
  const auto difference = [&](std::size_t k) {
    return std::stod(s.final_states.at(1).velocity.at(k)) - std::stod(s.final_states.at(0).velocity.at(k));
  };
  return {std::hypot(difference(0), difference(1)), std::atan2(difference(1), difference(0))};
}

}  // namespace

Claim revolution() {
  Claim claim{
      "revolution",
      "At θ = 45° and c_revolve = 0.5 four collisions make a revolution, and each keeps 0.84 of the speed.",
      "Collision response",
      scene_and_run("pair", "pair"),
      {}};
  constexpr int kEvents = 5;
  const double factor = std::pow(0.5, 0.25);
  // Decimal output carries 15 digits; five events of at most 16 roundings each stay below that.
  constexpr double kTolerance = 1e-14;
  double time = 0;
  double turned = 0;
  Relative before{};
  for (int k = 1; k <= kEvents; ++k) {
    const RunSummary run = after_events(static_cast<std::uint64_t>(k));
    const Relative now = relative_motion(run);
    const double speed = std::pow(factor, k);
    claim.figures.push_back(within(fmt::format("time of event {}", k), time, kTolerance * 10,
                                   "previous + 2 sin θ/|v|, times below 10", run.t, 7));
    claim.figures.push_back(within(fmt::format("speed after event {}", k), speed, kTolerance,
                                   "0.5^(kθ/π), θ/π = 1/4", now.speed, 6));
    if (k > 1) turned += std::remainder(now.direction - before.direction, 2 * std::numbers::pi);
    before = now;
    time += 2 * std::sin(std::numbers::pi / 4) / speed;
  }
  claim.figures.push_back(within("turn over 4 events, in revolutions", 1, kTolerance, "4 · 2θ = 360°",
                                 std::abs(turned) / (2 * std::numbers::pi), 6));
  claim.figures.push_back(within("speed kept by one collision", 0.84, 0.005, "the paper: approximately 0.84",
                                 relative_motion(after_events(1)).speed, 6));
  return claim;
}

}  // namespace tps::claims

// Grouping conserves momentum, and loses no energy that (4) and (5) do not account for.
#include <cmath>

#include "verify/claims/claim.hpp"
#include "verify/claims/runs.hpp"
#include "verify/claims/terminal_runs.hpp"
#include "verify/scenes/gas.hpp"

namespace tps::claims {
namespace {

void add_ledger(Claim& claim, const std::string& scene, const RunSummary& run) {
  claim.figures.push_back(between("largest group, " + scene, 2, static_cast<double>(run.particles) / 10,
                                  "groups exist, and none holds a tenth of the particles",
                                  static_cast<double>(run.largest_group), 3));
  claim.figures.push_back(between("momentum drift, " + scene, 0, run.momentum_bound,
                                  "sum of what rounding may do, event by event (docs/ledger.md)",
                                  run.momentum_drift, 2));
  claim.figures.push_back(between("energy not accounted for, " + scene, 0, run.energy_bound,
                                  "sum of what rounding may do, event by event (docs/ledger.md)",
                                  std::abs(run.energy_remainder), 2));
}

}  // namespace

Claim conservation() {
  GasParams gas;
  gas.particles = 100;
  gas.grouped = 1e-3;
  gas.restitution = 0.9;
  Claim claim{"conservation",
              "Grouping obeys conservation of momentum.",
              "Nearly-simultaneous collisions",
              scene_and_run("gas --particles 100 --restitution 0.9 --grouped 0.001", "gas"),
              {}};
  add_ledger(claim, "gas", run_scene(build_gas(gas), {}));
  add_ledger(claim, "terminal", terminal_run(1));
  return claim;
}

}  // namespace tps::claims

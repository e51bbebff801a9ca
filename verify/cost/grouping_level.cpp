// Δt_restitute from far above the time between nearly simultaneous collisions to far below an ulp of t.
#include <algorithm>
#include <cmath>

#include "verify/cost/model_level.hpp"
#include "verify/cost/traced_run.hpp"
#include "verify/cost/wanted.hpp"
#include "verify/scenes/cradle.hpp"
#include "verify/scenes/terminal.hpp"
#include "verify/scenes/three_body.hpp"

namespace tps::cost {
namespace {

/// A grouped scene that has come to rest in its groups renews nothing; one that stalls is told by the engine.
/// None of these scenes needs as many.
constexpr std::uint64_t kMostEvents = 200'000;

struct Subject {
  std::string name, what;
  Scene scene;                                    ///< without grouping
  std::optional<std::vector<double>> velocities;  ///< along x, of the truth; none where that is chaotic
};

std::vector<double> velocities_of(const RunSummary& run) {
  std::vector<double> result;
  for (const RunSummary::Final& particle : run.final_states)
    result.push_back(std::stod(particle.velocity.at(0)));
  return result;
}

TracedRun run_of(const Scene& scene) {
  RunOptions options;
  options.max_events = kMostEvents;
  return traced_run(scene, options);
}

double largest_difference(const std::vector<double>& x, const std::vector<double>& y) {
  double largest = 0;
  for (std::size_t k = 0; k < x.size(); ++k) largest = std::max(largest, std::fabs(x[k] - y[k]));
  return largest;
}

Scene three_body(double c) {
  ThreeBodyParams params;
  params.restitution = c;
  return build_three_body(params);
}

std::vector<Subject> subjects(std::uint64_t seed) {
  TerminalParams terminal;  // without grouping, one impact in the middle
  terminal.grouped = 0;
  terminal.duration = 20;
  terminal.impact_at = 10;
  terminal.impacts = 1;
  terminal.seed = seed;
  CradleParams cradle;
  cradle.duration = 1;
  const double together = 1 / (2 + ThreeBodyParams{}.middle_mass);  // momentum over mass
  std::vector<Subject> all;
  all.push_back({"three-body", "X-Y-Z, c = 1: against the ungrouped run", three_body(1), {}});
  all.push_back({"collapse",
                 "X-Y-Z, c = 1/2: against the limit of ever more collisions, all three at one velocity",
                 three_body(0.5), std::vector<double>(3, together)});
  all.push_back({"cradle", "five touching balls, c = 1: against the last one leaving with what the first had",
                 build_cradle(cradle), std::vector<double>{0, 0, 0, 0, 1}});
  all.push_back({"terminal",
                 "the presynaptic terminal until t = 20: against the ungrouped run",
                 build_terminal(terminal),
                 {}});
  return all;
}

/// From above the time gap/v_load = 0.01564 between the first two collisions of X-Y-Z to an ulp of t = 1, and
/// on to where even the low part of t, a sum of two doubles, ends.
std::vector<double> steps() {
  std::vector<double> result;
  for (const double near : {1e-1, 3e-2, 1.6e-2, 1.5e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 1e-6})
    result.push_back(near);
  for (const double small : {1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-14, 1e-16}) result.push_back(small);
  for (const double nothing : {1e-18, 1e-20, 1e-25, 1e-30, 1e-33, 1e-40}) result.push_back(nothing);
  return result;
}

std::uint64_t collisions(const RunSummary& run) {
  std::uint64_t sum = 0;
  for (const char* kind : {"rebound", "retract", "revolve"}) {
    const auto found = run.by_kind.find(kind);
    if (found != run.by_kind.end()) sum += found->second;
  }
  return sum;
}

}  // namespace

void measure_grouping(ModelLevel& level, const ModelLevelOptions& options) {
  for (Subject& subject : subjects(options.seed)) {
    if (!is_wanted(options.scenes, subject.name)) continue;
    options.announce(subject.name);
    const TracedRun truth = run_of(subject.scene);
    if (subject.name == "three-body") subject.velocities = velocities_of(truth.summary);
    const double start = truth.summary.kinetic_at_start;
    level.truths.push_back({subject.name, subject.what, truth.summary.end, collisions(truth.summary),
                            truth.summary.kinetic / start});
    const std::vector<std::string> all = collisions_of(truth);
    Scene scene = subject.scene;
    // Grouped scenes without an end of their own are over when the last group is.
    if (std::isinf(scene.duration)) scene.duration = 1000;
    for (const double dt : steps()) {
      scene.grouping = Grouping{dt};
      const TracedRun run = run_of(scene);
      GroupingRow row;
      row.scene = subject.name;
      row.dt_restitute = dt;
      row.end = run.summary.end;
      row.collisions = collisions(run.summary);
      row.events = run.summary.events;
      row.largest_group = run.summary.largest_group;
      if (subject.velocities)
        row.distance = largest_difference(velocities_of(run.summary), *subject.velocities);
      if (truth.summary.end != "stalled") row.horizon = horizon(collisions_of(run), all);
      row.kinetic = run.summary.kinetic / start;
      level.grouping.push_back(row);
    }
  }
}

std::vector<std::string> model_scenes() {
  return {"three-body", "collapse", "cradle", "terminal", "revolution"};
}

ModelLevel measure_model(const ModelLevelOptions& options) {
  ModelLevel level;
  level.seed = options.seed;
  measure_grouping(level, options);
  if (is_wanted(options.scenes, "revolution")) measure_revolution(level, options);
  return level;
}

}  // namespace tps::cost

#include "verify/cost/traced_run.hpp"

#include <algorithm>
#include <fstream>

#include "reference/process/interrupt.hpp"
#include "reference/text/scratch_file.hpp"
#include "verify/certified/exact_timing.hpp"

namespace tps::cost {
namespace {

std::vector<std::string> events_of(const std::string& trace) {
  std::vector<std::string> events;
  std::ifstream file(trace);
  for (std::string line; std::getline(file, line);) {
    const std::size_t from = line.find("\"kind\":");
    if (!line.starts_with("{\"k\":") || from == std::string::npos) continue;
    events.push_back(line.substr(from, line.find(",\"pre\"", from) - from));
  }
  return events;
}

RunSummary run(const Scene& scene, RunOptions options) {
  interrupt::check();
  certified::ExactTiming certifier;
  if (options.timing == Timing::certified) options.certifier = &certifier;
  return run_scene(scene, options);
}

}  // namespace

TracedRun traced_run(const Scene& scene, const RunOptions& options) {
  const ScratchFile trace;
  RunOptions traced = options;
  traced.trace = trace.path();
  TracedRun result{run(scene, traced), {}};
  result.events = events_of(trace.path());
  return result;
}

RunSummary timed_run(const Scene& scene, const RunOptions& options) {
  return run(scene, options);
}

std::vector<std::string> collisions_of(const TracedRun& run) {
  std::vector<std::string> collisions;
  std::copy_if(run.events.begin(), run.events.end(), std::back_inserter(collisions),
               [](const std::string& event) { return event.find("\"restitute\"") == std::string::npos; });
  return collisions;
}

std::optional<std::uint64_t> horizon(const std::vector<std::string>& events,
                                     const std::vector<std::string>& truth) {
  const auto [at, other] = std::mismatch(events.begin(), events.end(), truth.begin(), truth.end());
  if (at == events.end() && other == truth.end()) return std::nullopt;
  return static_cast<std::uint64_t>(at - events.begin());
}

}  // namespace tps::cost

#include "verify/cost/traced_run.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "reference/process/interrupt.hpp"
#include "verify/certified/exact_timing.hpp"

namespace tps::cost {
namespace {

/// A file that is gone with its owner.
class TemporaryFile {
 public:
  TemporaryFile() : path_((std::filesystem::temp_directory_path() / "tps-cost-XXXXXX").string()) {
    const int file = mkstemp(path_.data());
    if (file < 0) throw std::runtime_error("no temporary file can be made in " + path_);
    close(file);
  }
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

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
  const TemporaryFile trace;
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

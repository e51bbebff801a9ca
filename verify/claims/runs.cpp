#include "verify/claims/runs.hpp"

#include <fmt/format.h>

namespace tps::claims {

RunSummary run_three_body(const ThreeBodyParams& params, ScalarKind scalar,
                          std::optional<std::uint64_t> max_events) {
  RunOptions options;
  options.scalar = scalar;
  options.max_events = max_events;
  return run_scene(build_three_body(params), options);
}

long long count(const RunSummary& summary, const std::string& kind) {
  const auto found = summary.by_kind.find(kind);
  return found == summary.by_kind.end() ? 0 : static_cast<long long>(found->second);
}

const std::string& final_vx(const RunSummary& summary, std::size_t particle) {
  return summary.final_states.at(particle).velocity.at(0);
}

std::string count_or_stall(const RunSummary& summary) {
  return summary.end == "stalled" ? summary.end : std::to_string(count(summary, "rebound"));
}

std::string scene_and_run(const std::string& scene, const std::string& file, const std::string& options) {
  return fmt::format("tps scene {} -o {}.json && tps run {}.json{}{}", scene, file, file,
                     options.empty() ? "" : " ", options);
}

std::string text(double x) {
  return fmt::format("{}", x);
}

}  // namespace tps::claims

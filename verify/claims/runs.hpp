// Runs that several claims share.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "reference/run/run.hpp"
#include "verify/scenes/three_body.hpp"

namespace tps::claims {

/// Runs the paper's X-Y-Z, to its end or up to so many events.
RunSummary run_three_body(const ThreeBodyParams& params, ScalarKind scalar = ScalarKind::double_,
                          std::optional<std::uint64_t> max_events = std::nullopt);

/// How often a kind of event happened.
long long count(const RunSummary& summary, const std::string& kind);

/// The x-velocity of a particle at the end.
const std::string& final_vx(const RunSummary& summary, std::size_t particle);

/// "1960", or "stalled" where the run did.
std::string count_or_stall(const RunSummary& summary);

/// `tps scene SCENE -o F.json && tps run F.json OPTIONS`
std::string scene_and_run(const std::string& scene, const std::string& file, const std::string& options = "");

/// A number's shortest text.
std::string text(double x);

}  // namespace tps::claims

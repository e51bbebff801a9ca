// Whoever simulates a scene: a command, or a program that has the operation `simulate`.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "properties/implementation.hpp"
#include "reference/scene/scene.hpp"

namespace tps::properties::conform {

/// What came of a run.
struct Run {
  enum class Kind {
    traced,
    refused,   ///< no scene for this simulator
    endless,   ///< a hang, a flood
    failed,    ///< a crash, a breach of the protocol
    no_trace,  ///< an answer that is none
  };
  Kind kind = Kind::traced;
  std::string trace = {};  ///< of a run that has no end or failed, what came before
  std::string problem = {};
};

struct RunSource {
  std::string name;
  std::function<Run(const Scene&)> run;
  /// What asks it again about the scene, which is in scene.json too; for people.
  std::function<std::string(const Scene&)> command_for_scene;
  std::optional<std::uint64_t> most_events =
      {};  ///< after which it may end a run; null: it is asked for all of it
};

/// The path of a scene file is added to the words; the trace comes on standard output. Exit codes: 0, 6 for a
/// run that stalled, 3 for a scene that is refused.
RunSource command_runs(const std::vector<std::string>& words, std::chrono::milliseconds timeout);

/// {"op":"simulate","in":{"scene":…}} → {"out":{"trace":[line, …]}}, lines as objects. The subject outlives
/// it.
RunSource operation_runs(Implementation& subject, std::function<std::string(const Question&)> command_of);

/// Ten times what the reference has in a scene: who has more of them is wrong, and does not need to go on.
constexpr std::uint64_t kMostEventsOfARun = 1000;

}  // namespace tps::properties::conform

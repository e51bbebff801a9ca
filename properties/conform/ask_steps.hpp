// Single steps: the next event from states of the reference, so that an early slip does not hide what comes
// after it.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "properties/conform/verdict.hpp"
#include "properties/implementation.hpp"

namespace tps::properties::conform {

struct StepPlan {
  std::vector<std::string> features;                     ///< of the scenes (random_scene.hpp)
  std::uint64_t scenes = 50, steps = 20;                 ///< so many of each scene at most
  std::uint64_t seed = 2;                                ///< other scenes than those of whole runs
  std::function<bool(const std::string& row)> is_asked;  ///< by the name of its row
  std::function<std::vector<std::string>(const Question&)> commands_of;
  std::function<bool()> stops = [] { return false; };
  std::function<void(const std::string& doing)> progress = [](const std::string&) {};
};

/// The names of all rows that there may be.
std::vector<std::string> step_rows();

/// Random scenes without grouping, draws, phases or impulses, each followed event by event by certified
/// answers: at every state the subject is asked `next_event`. Its answer is judged as a trace of one event
/// (docs/check.md); those who have no part in it must fly on. Adds a row for each kind of event that is
/// right.
void ask_steps(Implementation& subject, const StepPlan& plan, Verdict& verdict);

}  // namespace tps::properties::conform

// Whether a full state can be one of its scene.
#pragma once

#include <string>
#include <vector>

#include "reference/scene/scene.hpp"
#include "reference/trace/state_data.hpp"

namespace tps {

/// Something that no run of the scene leaves behind.
struct StateProblem {
  std::string pointer;  ///< in the line
  std::string message;
};

/// Our runs go on from their states, summary included; another program's may lack what only that counts.
enum class StateOf { our_run, any_program };

/// What is wrong with a full state, the first `kMostStateProblems` of it; `digits` are the bits of the
/// scalar. It is judged by itself: whether it is the state that the events lead to is for the trace check.
/// Resuming and the trace check both refuse by this.
///
/// (1) Numbers are finite; times are sums hi + lo in their one spelling, none after `now`, and `t` is
///     start_time + now. (2) Every particle of the scene stands once, vectors have its dimension. (3) Tethers
///     are of pairs that can have one, each once, within the capacity of both. (4) Pairs that have responded
///     have that limit. (5) A body is a tree of loads over its members, each in one body, all with one
///     velocity (a break renews the clocks of its pair alone); its masses are sums of theirs, to the rounding
///     of the scalar; it was born before now and expires no earlier than now. (6) Draws are of pairs with a
///     tethering; progress is no further than the scene has phases and impulses; the counts of events by kind
///     add up to the number of events; quantities are those of the ledger.
std::vector<StateProblem> state_problems(const Scene& scene, const StateData& state, int digits,
                                         StateOf whose = StateOf::our_run);

inline constexpr std::size_t kMostStateProblems = 20;

}  // namespace tps

// The catalogue: every operation that can be asked, of us or of anybody's program, its name, what it takes
// and what it answers. Nowhere else are they listed.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/equations/timing_query.hpp"

namespace tps::operations {

/// In the order of the paper; then what takes more than numbers.
enum class Op {
  distance,
  paper_time,
  block_time,
  tether_time,
  apply_impulse,
  collision_impulse,
  revolution_impulse,
  tether_response,
  load,
  restitution_impulse,
  wall_time,
  drag_time,
  rough_impulse,
  order,
  group,
  next_event,
  simulate,
};

/// What kind of answer it is (docs/protocol.md).
enum class Answers {
  number,    ///< of no verdict: the distance
  time,      ///< a verdict, and t where something happens
  response,  ///< impulses and velocities, and which kind of response it is
  order,     ///< a word
  group,     ///< velocities of every body, loaded and restituted
  event,     ///< who, when, and the state after it
  trace,
};

struct Operation {
  Op op;
  std::string_view name;
  std::string_view rule = {};  ///< of the paper: "(4)"; of an effect its name; empty where there are many
  std::string_view what;
  Answers answers;
  std::vector<std::string> keys = {};  ///< of its numbers, where it takes nothing else
  std::string_view input = {};         ///< the shape of its object, for people, where it takes more
  std::string_view part;               ///< of the system: "equations", "timing", "response", …
  std::string_view page;               ///< of docs/
  int accepted_k = 0;        ///< of K(k), within which known answers are met (docs/vectors.md); 0: R alone
  bool needs_axis = false;   ///< û is needed: the positions must differ
  bool is_certified = true;  ///< the protocol answers it
  std::string_view precision = "certified";  ///< of the protocol's answer
};

/// All of them, in the order of Op.
const std::vector<Operation>& catalogue();

const Operation& operation(Op op);

/// Null for an unknown name.
const Operation* find(std::string_view name);

/// "block_time".
std::string_view name(Op op);

/// Whether it takes numbers alone, so that it can be evaluated in any scalar.
bool is_of_numbers(const Operation& operation);

/// "eq. (4)", "effect walls". REQUIRES is_of_numbers().
std::string rule_name(const Operation& operation);

/// Which limit a certified timing query is about; none for every other operation, drag_time among them.
std::optional<TimingKind> timing_kind(Op op);

/// The operation that asks for the time at a limit.
Op timing_of(TimingKind kind);

}  // namespace tps::operations

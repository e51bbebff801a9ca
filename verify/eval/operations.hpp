// The equations that `tps eval` answers: one table of operations, and of what their numbers may be.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tps::eval {

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
};

/// What a number or vector of the input may be.
enum class Domain {
  vector,              ///< 2 or 3 finite numbers, as many as in every other vector
  direction,           ///< a vector of length 1, to 2^-10: so that short formats have one, too
  spin,                ///< an angular velocity: one finite number in the plane, three in space
  number,              ///< finite
  length,              ///< finite, above 0
  rate,                ///< 1/time: finite, above 0
  not_negative,        ///< finite, at least 0
  mass,                ///< above 0, "inf" allowed
  coefficient,         ///< in [0, 1]
  signed_coefficient,  ///< in [-1, 1]
  angle,               ///< degrees in [1e-6, 90 − 1e-6]
};

struct Operation {
  Op op;
  std::string_view name;
  std::string_view equation;  ///< "(4)"; of an effect beyond the paper its name
  std::string_view what;
  std::vector<std::string> keys;
  std::string_view part;     ///< of the system: "equations", "timing", "response"
  std::string_view page;     ///< of docs/
  bool needs_axis = false;   ///< û is needed: the positions must differ
  bool is_certified = true;  ///< the protocol answers it
};

const std::vector<Operation>& operations();

/// Null for an unknown name.
const Operation* find_operation(std::string_view name);

std::vector<std::string> operation_names();

/// Of what an operation answers: a time with a verdict, or impulses and velocities.
bool is_timing(Op op);

/// "eq. (4)", "effect walls".
std::string rule_name(const Operation& operation);

Domain domain_of(std::string_view key);

}  // namespace tps::eval

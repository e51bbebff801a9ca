// Ways to break a good trace, each with the rule of the checker that has to see it.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "tests/trace_check/retold.hpp"
#include "verify/trace_check/rule.hpp"

namespace tps::mutation {

/// The number of the first event that is wrong in the broken trace; 0 where the header or the first state is.
/// Before it there is nothing to find. Nothing where the mutation does not apply to the trace.
using Broken = std::optional<std::uint64_t>;

struct Mutation {
  std::string_view name;
  std::string_view sentence;  ///< what was done to the trace
  check::Rule owner;          ///< has to report it, whoever else does
  /// Breaks the trace; at which of the places where that is possible, the number decides.
  Broken (*apply)(Trace& trace, std::uint64_t number);
};

/// By what is broken, each list in a file of its own.
const std::vector<Mutation>& broken_lines();
const std::vector<Mutation>& broken_times();
const std::vector<Mutation>& broken_sequences();
const std::vector<Mutation>& broken_impulses();
const std::vector<Mutation>& broken_velocities();
const std::vector<Mutation>& broken_tethers();
const std::vector<Mutation>& broken_groups();
const std::vector<Mutation>& broken_loads();
const std::vector<Mutation>& broken_plans();
const std::vector<Mutation>& broken_states();
const std::vector<Mutation>& broken_ends();
const std::vector<Mutation>& broken_standstills();

/// All of them, in the order above.
std::vector<Mutation> mutations();

/// A change that the rules allow: the trace stays right.
struct Legal {
  std::string_view name;
  std::string_view sentence;
  bool (*apply)(Trace& trace, std::uint64_t number);
};
const std::vector<Legal>& legal_changes();

}  // namespace tps::mutation

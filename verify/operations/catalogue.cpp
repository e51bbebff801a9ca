#include "verify/operations/catalogue.hpp"

#include <algorithm>

namespace tps::operations {
namespace {

using Keys = std::vector<std::string>;

Keys pair_and(std::initializer_list<const char*> others) {
  Keys keys{"u_A", "u_B", "v_A", "v_B"};
  keys.insert(keys.end(), others.begin(), others.end());
  return keys;
}

std::vector<Operation> table() {
  return {
      {.op = Op::distance,
       .name = "distance",
       .rule = "(1)",
       .what = "distance after free flight",
       .answers = Answers::number,
       .keys = pair_and({"dt"}),
       .part = "equations",
       .page = "docs/eq1.md",
       .is_certified = false},
      {.op = Op::paper_time,
       .name = "paper_time",
       .rule = "(2)",
       .what = "roots and rule as printed",
       .answers = Answers::number,
       .keys = pair_and({"L"}),
       .part = "timing",
       .page = "docs/eq2.md",
       .is_certified = false},
      {.op = Op::block_time,
       .name = "block_time",
       .rule = "(2)",
       .what = "at distance L and approaching",
       .answers = Answers::time,
       .keys = pair_and({"L"}),
       .part = "timing",
       .page = "docs/eq2.md",
       .accepted_k = 8},
      {.op = Op::tether_time,
       .name = "tether_time",
       .rule = "(2)",
       .what = "at distance L and separating",
       .answers = Answers::time,
       .keys = pair_and({"L"}),
       .part = "timing",
       .page = "docs/eq2.md",
       .accepted_k = 8},
      {.op = Op::apply_impulse,
       .name = "apply_impulse",
       .rule = "(3)",
       .what = "velocities after an impulse",
       .answers = Answers::response,
       .keys = {"m_A", "m_B", "v_A", "v_B", "dp"},
       .part = "equations",
       .page = "docs/eq3.md",
       .accepted_k = 16},
      {.op = Op::collision_impulse,
       .name = "collision_impulse",
       .rule = "(4)",
       .what = "impulse of a rebound or a retraction",
       .answers = Answers::response,
       .keys = pair_and({"m_A", "m_B", "c"}),
       .part = "equations",
       .page = "docs/eq4.md",
       .accepted_k = 16,
       .needs_axis = true},
      {.op = Op::revolution_impulse,
       .name = "revolution_impulse",
       .rule = "(5)",
       .what = "impulse of a revolution",
       .answers = Answers::response,
       .keys = pair_and({"m_A", "m_B", "c_revolve", "theta_revolve_deg"}),
       .part = "equations",
       .page = "docs/eq5.md",
       .accepted_k = 16,
       .needs_axis = true},
      {.op = Op::tether_response,
       .name = "tether_response",
       .rule = "(4) or (5)",
       .what = "retraction where it suffices, else revolution",
       .answers = Answers::response,
       .keys = pair_and({"m_A", "m_B", "c_retract", "c_revolve", "theta_revolve_deg"}),
       .part = "response",
       .page = "docs/eq5.md",
       .accepted_k = 16,
       .needs_axis = true},
      {.op = Op::load,
       .name = "load",
       .rule = "(6)",
       .what = "common velocity of two grouped bodies",
       .answers = Answers::response,
       .keys = {"m_A", "m_B", "v_A", "v_B"},
       .part = "equations",
       .page = "docs/eq6.md",
       .accepted_k = 16},
      {.op = Op::restitution_impulse,
       .name = "restitution_impulse",
       .rule = "(7)",
       .what = "impulse kept while grouped",
       .answers = Answers::response,
       .keys = {"m_A", "m_B", "v_A", "v_B", "dp"},
       .part = "equations",
       .page = "docs/eq7.md",
       .accepted_k = 16},
      {.op = Op::wall_time,
       .name = "wall_time",
       .rule = "walls",
       .what = "at distance L of a plane and approaching",
       .answers = Answers::time,
       .keys = pair_and({"L", "normal"}),
       .part = "timing",
       .page = "docs/effects.md",
       .accepted_k = 8},
      {.op = Op::drag_time,
       .name = "drag_time",
       .rule = "drag",
       .what = "the time of the clock s under drag",
       .answers = Answers::time,
       .keys = {"gamma", "s"},
       .part = "timing",
       .page = "docs/effects.md",
       .accepted_k = 8},
      {.op = Op::rough_impulse,
       .name = "rough_impulse",
       .rule = "friction",
       .what = "rebound of rough particles that turn",
       .answers = Answers::response,
       .keys = pair_and({"spin_A", "spin_B", "m_A", "m_B", "R_A", "R_B", "c", "mu", "beta0"}),
       .part = "response",
       .page = "docs/effects.md",
       .accepted_k = 16,
       .needs_axis = true},
      {.op = Op::order,
       .name = "order",
       .what = "which of two events comes first",
       .answers = Answers::order,
       .input = R"({"first":{"kind":"block"|"tether",u_A,u_B,v_A,v_B,L},"second":…})",
       .part = "order",
       .page = "docs/exact.md"},
      {.op = Op::group,
       .name = "group",
       .what = "velocities of bodies grouped by collisions, eqs. (3)-(7)",
       .answers = Answers::group,
       .input = R"({"bodies":[{m,u,v},…],"collisions":[{i,j,"limit":"inner",c},…]})",
       .part = "grouping",
       .page = "docs/protocol.md",
       .accepted_k = 64},
      {.op = Op::next_event,
       .name = "next_event",
       .what = "the next event of a scene and the state after it",
       .answers = Answers::event,
       .input = R"({"scene":…})",
       .part = "engine",
       .page = "docs/protocol.md",
       .accepted_k = 16},
      {.op = Op::simulate,
       .name = "simulate",
       .what = "the trace of a scene's run",
       .answers = Answers::trace,
       .input = R"({"scene":…,"max_events":…})",
       .part = "whole runs",
       .page = "docs/check.md",
       .precision = "double, certified timing"},
  };
}

}  // namespace

const std::vector<Operation>& catalogue() {
  static const std::vector<Operation> all = table();
  return all;
}

const Operation& operation(Op op) {
  return catalogue().at(static_cast<std::size_t>(op));
}

const Operation* find(std::string_view name) {
  const auto& all = catalogue();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Operation& o) { return o.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::string_view name(Op op) {
  return operation(op).name;
}

bool is_of_numbers(const Operation& operation) {
  return !operation.keys.empty();
}

std::string rule_name(const Operation& operation) {
  const char* prefix = operation.rule.starts_with('(') ? "eq. " : "effect ";
  return prefix + std::string(operation.rule);
}

std::optional<TimingKind> timing_kind(Op op) {
  for (const TimingKind kind : {TimingKind::block, TimingKind::tether, TimingKind::plane}) {
    if (op == timing_of(kind)) return kind;
  }
  return std::nullopt;
}

Op timing_of(TimingKind kind) {
  return kind == TimingKind::block    ? Op::block_time
         : kind == TimingKind::tether ? Op::tether_time
                                      : Op::wall_time;
}

}  // namespace tps::operations

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

Operation evaluated_only(Operation operation) {
  operation.is_certified = false;
  return operation;
}
Operation with_axis(Operation operation) {
  operation.needs_axis = true;
  return operation;
}

std::vector<Operation> table() {
  const Keys at_limit = pair_and({"L"}), impulse{"m_A", "m_B", "v_A", "v_B", "dp"};
  std::vector<Operation> all;
  const auto add = [&](Operation operation) { all.push_back(std::move(operation)); };
  add(evaluated_only({Op::distance, "distance", "(1)", "distance after free flight", Answers::number,
                      pair_and({"dt"}), "", "equations", "docs/eq1.md"}));
  add(evaluated_only({Op::paper_time, "paper_time", "(2)", "roots and rule as printed", Answers::number,
                      at_limit, "", "timing", "docs/eq2.md"}));
  add({Op::block_time, "block_time", "(2)", "at distance L and approaching", Answers::time, at_limit, "",
       "timing", "docs/eq2.md", 8});
  add({Op::tether_time, "tether_time", "(2)", "at distance L and separating", Answers::time, at_limit, "",
       "timing", "docs/eq2.md", 8});
  add({Op::apply_impulse, "apply_impulse", "(3)", "velocities after an impulse", Answers::response, impulse,
       "", "equations", "docs/eq3.md", 16});
  add(with_axis({Op::collision_impulse, "collision_impulse", "(4)", "impulse of a rebound or a retraction",
                 Answers::response, pair_and({"m_A", "m_B", "c"}), "", "equations", "docs/eq4.md", 16}));
  add(with_axis({Op::revolution_impulse, "revolution_impulse", "(5)", "impulse of a revolution",
                 Answers::response, pair_and({"m_A", "m_B", "c_revolve", "theta_revolve_deg"}), "",
                 "equations", "docs/eq5.md", 16}));
  add(with_axis({Op::tether_response, "tether_response", "(4) or (5)",
                 "retraction where it suffices, else revolution", Answers::response,
                 pair_and({"m_A", "m_B", "c_retract", "c_revolve", "theta_revolve_deg"}), "", "response",
                 "docs/eq5.md", 16}));
  add({Op::load, "load", "(6)", "common velocity of two grouped bodies", Answers::response,
       Keys{"m_A", "m_B", "v_A", "v_B"}, "", "equations", "docs/eq6.md", 16});
  add({Op::restitution_impulse, "restitution_impulse", "(7)", "impulse kept while grouped", Answers::response,
       impulse, "", "equations", "docs/eq7.md", 16});
  add({Op::wall_time, "wall_time", "walls", "at distance L of a plane and approaching", Answers::time,
       pair_and({"L", "normal"}), "", "timing", "docs/effects.md", 8});
  add({Op::drag_time, "drag_time", "drag", "the time of the clock s under drag", Answers::time,
       Keys{"gamma", "s"}, "", "timing", "docs/effects.md", 8});
  add(with_axis({Op::rough_impulse, "rough_impulse", "friction", "rebound of rough particles that turn",
                 Answers::response,
                 pair_and({"spin_A", "spin_B", "m_A", "m_B", "R_A", "R_B", "c", "mu", "beta0"}), "",
                 "response", "docs/effects.md", 16}));
  add({Op::order, "order", "", "which of two events comes first", Answers::order, Keys{},
       R"({"first":{"kind":"block"|"tether",u_A,u_B,v_A,v_B,L},"second":…})", "order", "docs/exact.md"});
  add({Op::group, "group", "", "velocities of bodies grouped by collisions, eqs. (3)-(7)", Answers::group,
       Keys{}, R"({"bodies":[{m,u,v},…],"collisions":[{i,j,"limit":"inner",c},…]})", "grouping",
       "docs/protocol.md", 64});
  add({Op::next_event, "next_event", "", "the next event of a scene and the state after it", Answers::event,
       Keys{}, R"({"scene":…})", "engine", "docs/protocol.md", 16});
  add({Op::simulate, "simulate", "", "the trace of a scene's run", Answers::trace, Keys{},
       R"({"scene":…,"max_events":…})", "whole runs", "docs/check.md"});
  all.back().precision = "double, certified timing";
  return all;
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

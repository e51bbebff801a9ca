#include "verify/eval/operations.hpp"

#include <algorithm>

namespace tps::eval {

const std::vector<Operation>& operations() {
  static const std::vector<Operation> table{
      {Op::distance,
       "distance",
       "(1)",
       "distance after free flight",
       {"u_A", "u_B", "v_A", "v_B", "dt"},
       "equations",
       "docs/eq1.md",
       false,
       false},
      {Op::paper_time,
       "paper_time",
       "(2)",
       "roots and rule as printed",
       {"u_A", "u_B", "v_A", "v_B", "L"},
       "timing",
       "docs/eq2.md",
       false,
       false},
      {Op::block_time,
       "block_time",
       "(2)",
       "at distance L and approaching",
       {"u_A", "u_B", "v_A", "v_B", "L"},
       "timing",
       "docs/eq2.md"},
      {Op::tether_time,
       "tether_time",
       "(2)",
       "at distance L and separating",
       {"u_A", "u_B", "v_A", "v_B", "L"},
       "timing",
       "docs/eq2.md"},
      {Op::apply_impulse,
       "apply_impulse",
       "(3)",
       "velocities after an impulse",
       {"m_A", "m_B", "v_A", "v_B", "dp"},
       "equations",
       "docs/eq3.md"},
      {Op::collision_impulse,
       "collision_impulse",
       "(4)",
       "impulse of a rebound or a retraction",
       {"u_A", "u_B", "v_A", "v_B", "m_A", "m_B", "c"},
       "equations",
       "docs/eq4.md",
       true},
      {Op::revolution_impulse,
       "revolution_impulse",
       "(5)",
       "impulse of a revolution",
       {"u_A", "u_B", "v_A", "v_B", "m_A", "m_B", "c_revolve", "theta_revolve_deg"},
       "equations",
       "docs/eq5.md",
       true},
      {Op::tether_response,
       "tether_response",
       "(4) or (5)",
       "retraction where it suffices, else revolution",
       {"u_A", "u_B", "v_A", "v_B", "m_A", "m_B", "c_retract", "c_revolve", "theta_revolve_deg"},
       "response",
       "docs/eq5.md",
       true},
      {Op::load,
       "load",
       "(6)",
       "common velocity of two grouped bodies",
       {"m_A", "m_B", "v_A", "v_B"},
       "equations",
       "docs/eq6.md"},
      {Op::restitution_impulse,
       "restitution_impulse",
       "(7)",
       "impulse kept while grouped",
       {"m_A", "m_B", "v_A", "v_B", "dp"},
       "equations",
       "docs/eq7.md"},
      {Op::wall_time,
       "wall_time",
       "walls",
       "at distance L of a plane and approaching",
       {"u_A", "u_B", "v_A", "v_B", "L", "normal"},
       "timing",
       "docs/effects.md"},
      {Op::drag_time,
       "drag_time",
       "drag",
       "the time of the clock s under drag",
       {"gamma", "s"},
       "timing",
       "docs/effects.md"},
      {Op::rough_impulse,
       "rough_impulse",
       "friction",
       "rebound of rough particles that turn",
       {"u_A", "u_B", "v_A", "v_B", "spin_A", "spin_B", "m_A", "m_B", "R_A", "R_B", "c", "mu", "beta0"},
       "response",
       "docs/effects.md",
       true},
  };
  return table;
}

const Operation* find_operation(std::string_view name) {
  const auto& table = operations();
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const Operation& o) { return o.name == name; });
  return found == table.end() ? nullptr : &*found;
}

std::vector<std::string> operation_names() {
  std::vector<std::string> names;
  for (const Operation& o : operations()) names.emplace_back(o.name);
  return names;
}

std::string rule_name(const Operation& operation) {
  const char* prefix = operation.equation.starts_with('(') ? "eq. " : "effect ";
  return prefix + std::string(operation.equation);
}

bool is_timing(Op op) {
  return op == Op::block_time || op == Op::tether_time || op == Op::wall_time || op == Op::drag_time;
}

Domain domain_of(std::string_view key) {
  if (key == "L" || key == "R_A" || key == "R_B") return Domain::length;
  if (key == "normal") return Domain::direction;
  if (key == "spin_A" || key == "spin_B") return Domain::spin;
  if (key == "gamma") return Domain::rate;
  if (key == "s" || key == "mu") return Domain::not_negative;
  if (key == "beta0") return Domain::signed_coefficient;
  if (key == "m_A" || key == "m_B" || key == "m") return Domain::mass;
  if (key == "theta_revolve_deg") return Domain::angle;
  if (key == "dt" || key == "i" || key == "j") return Domain::number;
  if (key == "c" || key == "c_retract" || key == "c_revolve") return Domain::coefficient;
  return Domain::vector;
}

}  // namespace tps::eval

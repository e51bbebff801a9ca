#include <iostream>

#include "docs/snippets/snippets.hpp"
#include "reference/equations/eq3_apply_impulse.hpp"
#include "reference/equations/eq4_collision_impulse.hpp"
#include "reference/equations/eq6_load_velocity.hpp"
#include "reference/equations/eq7_restitution_impulse.hpp"

void tps::docs::eq7() {
  // [snippet]
  using Vec = tps::Vector<double, 2>;
  const Vec u_A(0, 0), u_B(1, 0), v_A(1, 0), v_B(-3, 0);
  const double m_A = 2, m_B = 2, c = 0.5;
  const Vec dp = tps::collision_impulse(u_A, u_B, v_A, v_B, m_A, m_B, c);
  const Vec v_load = tps::load_velocity(m_A, m_B, v_A, v_B);
  const Vec dp_AB = tps::restitution_impulse(m_A, m_B, v_A, v_B, dp);
  const auto later = tps::apply_impulse(m_A, m_B, v_load, v_load, dp_AB);
  const auto at_once = tps::apply_impulse(m_A, m_B, v_A, v_B, dp);
  std::cout << "together at " << v_load[0] << ", then " << later.v_A[0] << " and " << later.v_B[0] << "\n"
            << "ungrouped    " << at_once.v_A[0] << " and " << at_once.v_B[0] << "\n";
  // [snippet]
}

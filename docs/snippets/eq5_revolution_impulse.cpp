#include <iostream>

#include "docs/snippets/snippets.hpp"
#include "reference/equations/eq3_apply_impulse.hpp"
#include "reference/equations/tether_response.hpp"

void tps::docs::eq5() {
  // [snippet]
  using Vec = tps::Vector<double, 2>;
  const Vec u_A(0, 0), u_B(1, 0), v_A(0, 0), v_B(0, 1);  // B passes A perpendicularly
  const double m_A = 1, m_B = 1, c_retract = 0.9, c_revolve = 0.5, theta = 45;

  const auto frame = tps::collision_frame(u_A, u_B, v_A, v_B);
  const auto answer = tps::tether_response(frame, m_A, m_B, c_retract, c_revolve, theta);
  std::cout << (answer.kind == tps::TetherResponseKind::revolve ? "revolve" : "retract") << "\n";

  const auto after = tps::apply_impulse(m_A, m_B, v_A, v_B, answer.dp);
  const Vec v_AB = after.v_B - after.v_A;
  std::cout << "relative velocity " << v_AB.transpose() << ", speed " << v_AB.norm() << "\n";
  // [snippet]
}

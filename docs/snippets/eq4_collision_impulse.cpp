#include <iostream>

#include "docs/snippets/snippets.hpp"
#include "reference/equations/eq3_apply_impulse.hpp"
#include "reference/equations/eq4_collision_impulse.hpp"

void tps::docs::eq4() {
  // [snippet]
  using Vec = tps::Vector<double, 2>;
  const Vec u_A(0, 0), u_B(1, 0), v_A(1, 0), v_B(0, 0);
  const double m_A = 1, m_B = 0.001;
  for (const double c : {1.0, 0.5, 0.0}) {
    const Vec dp = tps::collision_impulse(u_A, u_B, v_A, v_B, m_A, m_B, c);
    const auto after = tps::apply_impulse(m_A, m_B, v_A, v_B, dp);
    std::cout << "c = " << c << ": A leaves at " << after.v_A[0] << ", B at " << after.v_B[0] << "\n";
  }
  // [snippet]
}

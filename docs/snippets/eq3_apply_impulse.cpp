#include <iostream>
#include <limits>

#include "docs/snippets/snippets.hpp"
#include "reference/equations/eq3_apply_impulse.hpp"

void tps::docs::eq3() {
  // [snippet]
  using Vec = tps::Vector<double, 2>;
  const Vec v_A(1, 0), v_B(0, 1), dp(4, -8);
  const auto after = tps::apply_impulse(2.0, 4.0, v_A, v_B, dp);
  std::cout << "A: " << after.v_A.transpose() << "   B: " << after.v_B.transpose() << "\n";

  const double infinite = std::numeric_limits<double>::infinity();
  const auto wall = tps::apply_impulse(infinite, 4.0, v_A, v_B, dp);
  std::cout << "A: " << wall.v_A.transpose() << "    B: " << wall.v_B.transpose() << "\n";
  // [snippet]
}

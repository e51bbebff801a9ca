#include <iostream>

#include "docs/snippets/snippets.hpp"
#include "reference/equations/eq1_distance.hpp"

void tps::docs::eq1() {
  // [snippet]
  using Vec = tps::Vector<double, 2>;
  const Vec u_A(0, 0), u_B(5, 0);  // positions
  const Vec v_A(1, 0), v_B(0, 0);  // velocities
  for (const double dt : {0.0, 4.0, 6.0}) {
    std::cout << "distance after " << dt << ": " << tps::distance_after(u_A, u_B, v_A, v_B, dt) << "\n";
  }
  // [snippet]
}

#include <iostream>

#include "docs/snippets/snippets.hpp"
#include "reference/equations/eq6_load_velocity.hpp"

void tps::docs::eq6() {
  // [snippet]
  using Vec = tps::Vector<double, 2>;
  const Vec v_X(1, 0), at_rest(0, 0);
  const double m_X = 1, m_Y = 0.001, m_Z = 1;
  const Vec v_XY = tps::load_velocity(m_X, m_Y, v_X, at_rest);
  const Vec v_XYZ = tps::load_velocity(m_X + m_Y, m_Z, v_XY, at_rest);
  std::cout << "X and Y: " << v_XY[0] << ", then with Z: " << v_XYZ[0] << "\n";
  // [snippet]
}

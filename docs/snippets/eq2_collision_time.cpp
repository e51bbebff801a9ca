#include <iostream>

#include "docs/snippets/snippets.hpp"
#include "reference/equations/eq2_collision_time.hpp"
#include "reference/equations/eq2_paper_time.hpp"

void tps::docs::eq2() {
  // [snippet]
  using Vec = tps::Vector<double, 2>;
  const Vec zero(0, 0);

  // Head-on from 5 to the limit 1 at unit speed.
  const auto hit = tps::block_time(zero, Vec(5, 0), Vec(1, 0), zero, 1.0);
  std::cout << name(hit.verdict) << " at " << *hit.t << "\n";

  // A pair that has just rebounded: it is at the limit and separates.
  const auto parted = tps::block_time(zero, Vec(1, 0), zero, Vec(1, 0), 1.0);
  std::cout << name(parted.verdict) << ", but by the literal rule at "
            << *tps::paper_time(zero, Vec(1, 0), zero, Vec(1, 0), 1.0) << "\n";

  // A tether that has just been pulled: it is at its limit and closes.
  const auto pulled = tps::tether_time(zero, Vec(2, 0), zero, Vec(-1, 0), 2.0);
  std::cout << name(pulled.verdict) << " at " << *pulled.t << ", but by the literal rule at "
            << *tps::paper_time(zero, Vec(2, 0), zero, Vec(-1, 0), 2.0) << "\n";
  // [snippet]
}

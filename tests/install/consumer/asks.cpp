// What a user of tps::properties writes: the laws, asked of an implementation.
#include <cstdio>

#include "properties/check_law.hpp"
#include "properties/implementations/reference.hpp"

int main() {
  const auto subject = tps::properties::reference("double");
  std::size_t broken = 0;
  for (const tps::properties::Law& law : tps::properties::laws()) {
    tps::properties::Tally tally;
    if (tps::properties::check_law(law, *subject, {.count = 20}, tally)) ++broken;
  }
  std::printf("%zu laws, %zu broken\n", tps::properties::laws().size(), broken);
}

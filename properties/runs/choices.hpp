// Choices inside rc::gen::exec that shrink: towards the first of a list, towards "no", towards zero. Each
// expression makes one: the order of two is the compiler's, and the scene of a number must not be.
#pragma once

#include <rapidcheck.h>

#include <initializer_list>
#include <vector>

namespace tps::properties::runs {

/// One of a list; shrinks towards the first. (rc::gen::element does not shrink.)
template <typename Item>
Item pick(std::initializer_list<Item> items) {
  const std::vector<Item> list(items);
  return list[*rc::gen::inRange<std::size_t>(0, list.size())];
}

/// True once in `many`.
inline bool once_in(int many) {
  return *rc::gen::inRange(0, many) == many - 1;
}

/// A whole number of −most … most.
inline int around_zero(int most) {
  const int n = *rc::gen::inRange(0, 2 * most + 1);
  return n % 2 == 0 ? n / 2 : -(n + 1) / 2;
}

}  // namespace tps::properties::runs

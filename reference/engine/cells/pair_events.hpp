// Events that both of a pair know.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "reference/engine/queue.hpp"

namespace tps {

/// The next event of a pair, or a time before which it has none.
template <typename Scalar>
struct Foreseen {
  int asking, asked;
  PendingEvent<Scalar> event;
};

/// Of the events from the n-th one on, all of pairs, keeps one a pair.
template <typename Scalar>
void keep_each_pair_once(std::vector<PendingEvent<Scalar>>& events, std::size_t n) {
  if (events.size() - n <= 1) return;
  using Event = PendingEvent<Scalar>;
  const auto pair_of = [](const Event& event) { return std::pair(event.first, event.second); };
  const auto begin = events.begin() + static_cast<std::ptrdiff_t>(n);
  std::sort(begin, events.end(), [&](const Event& a, const Event& b) { return pair_of(a) < pair_of(b); });
  events.erase(std::unique(begin, events.end(),
                           [&](const Event& a, const Event& b) { return pair_of(a) == pair_of(b); }),
               events.end());
}

}  // namespace tps

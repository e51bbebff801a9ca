// Memory for the next events: a large system waits for it most of its time, and a queue knows who is next.
#pragma once

#include <cstddef>
#include <vector>

#include "reference/engine/cells/neighbourhood.hpp"
#include "reference/engine/cells/outlook.hpp"
#include "reference/engine/large_pages.hpp"
#include "reference/engine/world.hpp"

namespace tps {

/// Asks memory for what the events of particles need that are due soon: they themselves, those whom they
/// meet, and the buckets around both. What says where to look further is asked for one walk earlier.
template <typename Scalar, int D>
void fetch_ahead(const World<Scalar, D>& world, const Neighbourhood<Scalar, D>& neighbourhood,
                 const LargeVector<Outlook<Scalar>>& outlooks, const std::vector<int>& soon) {
  const auto outlook = [&](int i) -> const Outlook<Scalar>& { return outlooks[static_cast<std::size_t>(i)]; };
  for (const int i : soon) {
    outlook(i).prefetch();
    world.prefetch(i);
    neighbourhood.prefetch(i);
  }
  for (const int i : soon) {
    if (outlook(i).count() == 0) continue;
    const int partner = outlook(i).partner(0).particle;
    world.prefetch(partner);
    neighbourhood.prefetch(partner);
  }
  for (const int i : soon) {
    neighbourhood.prefetch_around(world, i);
    if (outlook(i).count() > 0) neighbourhood.prefetch_around(world, outlook(i).partner(0).particle);
  }
}

/// The same for the buckets around the particles of events, from one of them on, that are about to happen.
template <typename Scalar, int D>
void fetch_around(const World<Scalar, D>& world, const Neighbourhood<Scalar, D>& neighbourhood,
                  const std::vector<PendingEvent<Scalar>>& events, std::size_t from) {
  for (std::size_t n = from; n < events.size(); ++n) {
    neighbourhood.prefetch_around(world, events[n].first);
    neighbourhood.prefetch_around(world, events[n].second);
  }
}

}  // namespace tps

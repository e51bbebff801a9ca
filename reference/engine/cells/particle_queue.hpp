// Which particle has something due first: a heap of particles in which each has one place.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "reference/engine/clock.hpp"
#include "reference/engine/large_pages.hpp"

namespace tps {

/// Every particle with the time at which it is due; never() keeps it in the heap, at the end.
/// Schedule: O(log N). Earliest: O(1).
template <typename Scalar>
class ParticleQueue {
 public:
  struct Due {
    Time<Scalar> time;
    int particle;
  };

  /// Nobody is due.
  void reset(std::size_t particles) {
    heap_.resize(particles);
    place_.resize(particles);
    for (std::size_t i = 0; i < particles; ++i) {
      heap_[i] = {Time<Scalar>::never(), static_cast<int>(i)};
      place_[i] = static_cast<std::uint32_t>(i);
    }
  }

  /// REQUIRES at least one particle.
  const Due& earliest() const { return heap_.front(); }

  void schedule(int particle, const Time<Scalar>& time) {
    const std::size_t at = place_[static_cast<std::size_t>(particle)];
    if (time == heap_[at].time) return;
    if (time < heap_[at].time) {
      rise(at, {time, particle});
    } else {
      sink(at, {time, particle});
    }
  }

  /// Appends the particles that are due at or before a time.
  void due_until(const Time<Scalar>& latest, std::vector<int>& particles) const {
    append_due(0, latest, particles);
  }

  /// Calls use(i) for some of the particles that are due soon.
  template <typename Use>
  void for_next(Use use) const {
    for (std::size_t n = 1; n <= kBranches && n < heap_.size(); ++n) use(heap_[n].particle);
  }

 private:
  static constexpr std::size_t kBranches = 4;

  void append_due(std::size_t at, const Time<Scalar>& latest, std::vector<int>& particles) const {
    if (at >= heap_.size() || latest < heap_[at].time) return;
    particles.push_back(heap_[at].particle);
    for (std::size_t n = 1; n <= kBranches; ++n) append_due(kBranches * at + n, latest, particles);
  }

  void put(std::size_t at, const Due& due) {
    heap_[at] = due;
    place_[static_cast<std::size_t>(due.particle)] = static_cast<std::uint32_t>(at);
  }

  void rise(std::size_t at, const Due& due) {
    while (at > 0) {
      const std::size_t parent = (at - 1) / kBranches;
      if (!(due.time < heap_[parent].time)) break;
      put(at, heap_[parent]);
      at = parent;
    }
    put(at, due);
  }

  void sink(std::size_t at, const Due& due) {
    for (;;) {
      const std::size_t first = kBranches * at + 1;
      if (first >= heap_.size()) break;
      const std::size_t end = std::min(first + kBranches, heap_.size());
      std::size_t least = first;
      for (std::size_t child = first + 1; child < end; ++child) {
        if (heap_[child].time < heap_[least].time) least = child;
      }
      if (!(heap_[least].time < due.time)) break;
      put(at, heap_[least]);
      at = least;
    }
    put(at, due);
  }

  LargeVector<Due> heap_;
  LargeVector<std::uint32_t> place_;
};

}  // namespace tps

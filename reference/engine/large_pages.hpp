// Where the states of many particles lie: large pages of memory, where the system has them.
#pragma once

#include <cstddef>
#include <vector>

namespace tps {
namespace detail {

/// Throws std::bad_alloc.
void* take_large_pages(std::size_t bytes, std::size_t alignment);
void give_large_pages(void* memory, std::size_t bytes, std::size_t alignment) noexcept;

}  // namespace detail

/// An allocator that asks the system to back some megabytes at once with large pages. A neighbour is
/// somewhere in them, and of small pages a processor remembers a few thousand places only
/// (docs/performance.md).
template <typename T>
struct LargePages {
  using value_type = T;

  LargePages() = default;
  template <typename U>
  LargePages(const LargePages<U>&) {}

  T* allocate(std::size_t n) { return static_cast<T*>(detail::take_large_pages(n * sizeof(T), alignof(T))); }
  void deallocate(T* memory, std::size_t n) noexcept {
    detail::give_large_pages(memory, n * sizeof(T), alignof(T));
  }
  friend bool operator==(const LargePages&, const LargePages&) { return true; }
};

/// A vector with an entry for every particle.
template <typename T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace tps

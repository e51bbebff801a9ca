#include "reference/engine/large_pages.hpp"

#include <algorithm>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace tps::detail {
namespace {

constexpr std::size_t kPage = std::size_t{2} << 20U;

/// Less would waste more than it gains.
bool is_large(std::size_t bytes) {
  return bytes >= 2 * kPage;
}

std::align_val_t alignment_of(std::size_t bytes, std::size_t alignment) {
  return std::align_val_t{is_large(bytes) ? std::max(kPage, alignment) : alignment};
}

}  // namespace

void* take_large_pages(std::size_t bytes, std::size_t alignment) {
  void* memory = ::operator new(bytes, alignment_of(bytes, alignment));
#if defined(MADV_HUGEPAGE)
  if (is_large(bytes)) static_cast<void>(::madvise(memory, bytes, MADV_HUGEPAGE));  // a wish
#endif
  return memory;
}

void give_large_pages(void* memory, std::size_t bytes, std::size_t alignment) noexcept {
  ::operator delete(memory, alignment_of(bytes, alignment));
}

}  // namespace tps::detail

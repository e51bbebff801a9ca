// A table of 2^16 places that costs what is used of it: most traces are short.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace tps::check {

/// Places begin as T().
template <typename T>
class LazyTable {
 public:
  T& operator[](std::uint16_t place) {
    std::unique_ptr<Page>& page = pages_[place / kPage];
    if (page == nullptr) page = std::make_unique<Page>();
    return (*page)[place % kPage];
  }

  /// Asks memory for a place, so that it has come when it is needed.
  void fetch(std::uint16_t place) const {
    const std::unique_ptr<Page>& page = pages_[place / kPage];
    if (page != nullptr) __builtin_prefetch(&(*page)[place % kPage], 1);
  }

  /// Goes through places in their order, without those that nobody has asked for or asked for a neighbour of.
  template <typename Visit>
  void each(Visit visit) const {
    for (const std::unique_ptr<Page>& page : pages_) {
      if (page == nullptr) continue;
      for (const T& item : *page) visit(item);
    }
  }

  /// Goes through the same places of this table and, with them, those of another one.
  template <typename Visit>
  void each_with(const LazyTable& other, Visit visit) {
    for (std::size_t n = 0; n < pages_.size(); ++n) {
      if (other.pages_[n] == nullptr) continue;
      if (pages_[n] == nullptr) pages_[n] = std::make_unique<Page>();
      for (std::size_t k = 0; k < kPage; ++k) visit((*pages_[n])[k], (*other.pages_[n])[k]);
    }
  }

 private:
  static constexpr std::size_t kPage = 64;
  using Page = std::array<T, kPage>;
  std::array<std::unique_ptr<Page>, (std::size_t{1} << 16U) / kPage> pages_{};
};

}  // namespace tps::check

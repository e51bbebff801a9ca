// Random choices that are the same on every machine: std::mt19937_64 is, the standard distributions are not.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <random>
#include <vector>

namespace tps::properties::campaign {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : bits_(seed) {}

  std::uint64_t bits() { return bits_(); }
  /// A whole number of `low` … `high`.
  int whole(int low, int high) {
    return low + static_cast<int>(bits_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool once_in(int many) { return whole(1, many) == 1; }
  /// Uniform in [0, 1), a multiple of 2^-53.
  double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }

  template <typename Item>
  Item of(std::initializer_list<Item> items) {
    return std::vector<Item>(items)[bits_() % items.size()];
  }

 private:
  std::mt19937_64 bits_;
};

}  // namespace tps::properties::campaign

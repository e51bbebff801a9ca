// A double as an odd integer times a power of two.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

namespace tps::exact {

/// x = mantissa · 2^exponent with an odd mantissa, or 0 with the largest exponent.
struct OddMultiple {
  std::int64_t mantissa;
  int exponent;
};

/// REQUIRES a finite x.
constexpr OddMultiple odd_multiple(double x) {
  constexpr int kFractionBits = 52, kBias = 1075;  // of the last bit
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto biased = static_cast<int>((bits >> kFractionBits) & 0x7ffU);
  std::uint64_t mantissa = bits & ((std::uint64_t{1} << kFractionBits) - 1);
  if (biased != 0) mantissa |= std::uint64_t{1} << kFractionBits;
  if (mantissa == 0) return {0, std::numeric_limits<int>::max()};
  const int zeros = std::countr_zero(mantissa);
  const auto odd = static_cast<std::int64_t>(mantissa >> static_cast<unsigned>(zeros));
  return {(bits >> 63U) != 0 ? -odd : odd, std::max(biased, 1) - kBias + zeros};
}

}  // namespace tps::exact

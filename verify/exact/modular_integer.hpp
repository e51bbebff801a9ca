// Integers modulo 2^256: a sum of products whose size is known is known exactly by its last 256 bits.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "verify/exact/double_word.hpp"
#include "verify/exact/odd_multiple.hpp"

namespace tps::exact {

/// Integers of up to 127 bits and a sign: what differences of the numbers of a query nearly always are.
__extension__ using ShortInteger = __int128;  // of both compilers; the standard has none

/// (y − x) / 2^unit, if that is short for sure. REQUIRES that both are integers.
constexpr std::optional<ShortInteger> short_difference(const OddMultiple& y, const OddMultiple& x, int unit) {
  constexpr int kMost = 72;  // what a mantissa of 53 bits may be shifted by for a difference of 126
  const int by_y = y.mantissa == 0 ? 0 : y.exponent - unit, by_x = x.mantissa == 0 ? 0 : x.exponent - unit;
  if (by_y > kMost || by_x > kMost) return std::nullopt;
  return (ShortInteger{y.mantissa} << by_y) - (ShortInteger{x.mantissa} << by_x);
}

/// Law: operations are those of the integers modulo 2^256.
class ModularInteger {
 public:
  constexpr ModularInteger() = default;
  explicit constexpr ModularInteger(ShortInteger x) {
    const std::uint64_t sign = x < 0 ? ~std::uint64_t{0} : 0;
    words_ = {static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(x >> 64), sign, sign};
  }
  /// (y − x) / 2^unit. REQUIRES that both are integers.
  static constexpr ModularInteger difference(double y, double x, int unit) {
    const std::optional<ShortInteger> apart = short_difference(odd_multiple(y), odd_multiple(x), unit);
    return apart ? ModularInteger(*apart) : lifted(y, unit) - lifted(x, unit);
  }
  /// x y, by four products of words instead of ten.
  static constexpr ModularInteger product(ShortInteger x, ShortInteger y) {
    const Wide a = size_of(x), b = size_of(y);
    const std::uint64_t a0 = static_cast<std::uint64_t>(a), a1 = static_cast<std::uint64_t>(a >> 64U);
    const std::uint64_t b0 = static_cast<std::uint64_t>(b), b1 = static_cast<std::uint64_t>(b >> 64U);
    const Wide low = Wide{a0} * b0, high = Wide{a1} * b1;
    const Wide cross = Wide{a1} * b0 + (low >> 64U);  // below 2^128 − 2^64
    const Wide middle = Wide{a0} * b1 + static_cast<std::uint64_t>(cross);
    const Wide top = high + (cross >> 64U) + (middle >> 64U);
    ModularInteger all;
    all.words_ = {static_cast<std::uint64_t>(low), static_cast<std::uint64_t>(middle),
                  static_cast<std::uint64_t>(top), static_cast<std::uint64_t>(top >> 64U)};
    return (x < 0) != (y < 0) ? -all : all;
  }
  /// x / 2^unit. REQUIRES that it is an integer.
  static constexpr ModularInteger lifted(double x, int unit) {
    const OddMultiple odd = odd_multiple(x);
    if (odd.mantissa == 0) return {};
    return ModularInteger(odd.mantissa).times_two_to(static_cast<unsigned>(odd.exponent - unit));
  }

  constexpr ModularInteger operator+(const ModularInteger& other) const {
    ModularInteger sum;
    Wide carry = 0;
    for (std::size_t n = 0; n < kWords; ++n) {
      carry += Wide{words_[n]} + other.words_[n];
      sum.words_[n] = static_cast<std::uint64_t>(carry);
      carry >>= 64U;
    }
    return sum;
  }
  constexpr ModularInteger operator-() const {
    ModularInteger all;
    for (std::size_t n = 0; n < kWords; ++n) all.words_[n] = ~words_[n];
    return all + ModularInteger(1);
  }
  constexpr ModularInteger operator-(const ModularInteger& other) const { return *this + -other; }
  constexpr ModularInteger operator*(const ModularInteger& other) const {
    ModularInteger product;
    for (std::size_t i = 0; i < kWords; ++i) {
      Wide carry = 0;
      for (std::size_t j = 0; i + j < kWords; ++j) {
        carry += Wide{words_[i]} * other.words_[j] + product.words_[i + j];
        product.words_[i + j] = static_cast<std::uint64_t>(carry);
        carry >>= 64U;
      }
    }
    return product;
  }
  constexpr ModularInteger times_two_to(unsigned n) const {
    ModularInteger shifted;
    const std::size_t whole = n / 64;
    const unsigned rest = n % 64;
    for (std::size_t k = whole; k < kWords; ++k) {
      shifted.words_[k] = words_[k - whole] << rest;
      if (rest != 0 && k > whole) shifted.words_[k] |= words_[k - whole - 1] >> (64 - rest);
    }
    return shifted;
  }

  constexpr bool operator==(const ModularInteger&) const = default;
  /// −1, 0 or 1: that of an integer which is known to be at most `kMostBits` bits long.
  constexpr int sign() const {
    if ((words_[kWords - 1] >> 63U) != 0) return -1;
    std::uint64_t any = 0;
    for (const std::uint64_t word : words_) any |= word;
    return any == 0 ? 0 : 1;
  }
  static constexpr int kMostBits = 255;
  static constexpr std::uint64_t kBits = 256;

  /// The absolute value, its last bits cut off: off by less than 2^-105 of it. REQUIRES not 0, at most
  /// kMostBits bits.
  DoubleWord magnitude() const {
    const ModularInteger positive = sign() < 0 ? -*this : *this;
    std::size_t n = kWords;
    while (n > 1 && positive.words_[n - 1] == 0) --n;
    const auto word = [&](std::size_t below) { return below < n ? positive.words_[n - 1 - below] : 0; };
    const auto zeros = static_cast<unsigned>(std::countl_zero(word(0)));
    Wide top = (Wide{word(0)} << 64U | word(1)) << zeros;
    if (zeros > 0) top |= word(2) >> (64 - zeros);
    constexpr int kDigits = 53;
    const auto high = static_cast<std::uint64_t>(top >> (128U - kDigits));
    const auto low =
        static_cast<std::uint64_t>(top >> (128U - 2 * kDigits)) & ((std::uint64_t{1} << kDigits) - 1);
    const int exponent = 64 * static_cast<int>(n) - static_cast<int>(zeros);
    return fast_two_sum(std::ldexp(static_cast<double>(high), exponent - kDigits),
                        std::ldexp(static_cast<double>(low), exponent - 2 * kDigits));
  }

 private:
  __extension__ using Wide = unsigned __int128;  // of both compilers; the standard has none
  static constexpr Wide size_of(ShortInteger x) {
    return x < 0 ? -static_cast<Wide>(x) : static_cast<Wide>(x);
  }
  static constexpr std::size_t kWords = 4;
  std::array<std::uint64_t, kWords> words_{};  ///< the least significant first, in two's complement
};

}  // namespace tps::exact

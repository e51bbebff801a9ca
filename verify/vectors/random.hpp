// Random numbers that are the same on every machine: a stream is a function of what it is for.
#pragma once

#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

namespace tps::vectors {

/// Draw once a statement: the order in which a compiler evaluates arguments is its own.
///
/// SplitMix64 (Steele, Lea, Flood, OOPSLA 2014): the standard's engines are portable but its distributions
/// are not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  /// The stream of one case: of this seed, this file and this number in it.
  Random(std::uint64_t seed, std::string_view purpose, std::uint64_t number) : state_(seed) {
    for (const char c : purpose) state_ = (bits() ^ static_cast<unsigned char>(c));
    state_ = bits() ^ number;
    state_ = bits();
  }

  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
  bool coin() { return (bits() & 1U) != 0; }
  double uniform(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(bits() >> 11), -53);
  }
  int integer(int low, int high) {  ///< inclusive
    return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
  }
  double any_double(int low, int high) {  ///< random sign and significand, exponent uniform in [low, high]
    const double significand = std::ldexp(static_cast<double>((bits() >> 11) | (1ULL << 52)), -52);
    const double x = std::ldexp(significand, integer(low, high));
    return coin() ? x : -x;
  }

 private:
  std::uint64_t state_;
};

/// So many numbers, each from -most to most.
inline std::vector<double> numbers_within(Random& random, int count, double most) {
  std::vector<double> x;
  for (int k = 0; k < count; ++k) x.push_back(random.uniform(-most, most));
  return x;
}

/// 1 ∓ 2^-k, k from `first` to `last`: so far beside a limit that rounding does not decide, and a tolerance
/// does.
inline double beside_one(Random& random, int first, int last) {
  const double apart = std::ldexp(1.0, -random.integer(first, last));
  return random.coin() ? 1 + apart : 1 - apart;
}

}  // namespace tps::vectors

// Counter-based random numbers: a draw is a function of what it is for, not of the order of the draws.
//
// The generator is Philox4x32-10 (Salmon et al., "Parallel random numbers: as easy as 1, 2, 3", SC11;
// the Random123 library). The seed is its key; purpose, two ids and a number within the stream are its
// counter. Every function here uses comparisons and correctly rounded operations only (no log, cos, std::
// distribution), so that the same seed gives the same doubles with every compiler and every C library.
#pragma once

#include <cstdint>

namespace tps {

/// What a draw is for. The values are part of the meaning of a seed: append, never renumber.
enum class Purpose : std::uint32_t {
  scene_position = 1,
  scene_velocity = 2,
  tether_form = 3,
  tether_break = 4,
  random_impulse = 5,
  random_impulse_wait = 6,
  thermostat = 7,
  thermostat_wait = 8,
};

/// Random bits of the draw number `n` of the stream (seed, purpose, a, b); a and b are ids of particles (0
/// where there is none). Philox4x32-10 with key (low, high word of seed) and counter (purpose, a, b, n); the
/// 64 bits are words 0 (low) and 1 (high) of the result. (1) A pure function. (2) draw_bits(0, Purpose{0}, 0,
/// 0, 0) is 0xe169c58d6627e8d5, Random123's known answer.
std::uint64_t draw_bits(std::uint64_t seed, Purpose purpose, std::uint32_t a, std::uint32_t b,
                        std::uint32_t n);

/// Uniform in [0, 1): the upper 53 of 64 random bits, times 2^-53. Every multiple of 2^-53 is equally likely.
double uniform_of_bits(std::uint64_t bits);

/// uniform_of_bits of draw_bits.
double uniform(std::uint64_t seed, Purpose purpose, std::uint32_t a, std::uint32_t b, std::uint32_t n);

/// A stream of draws (seed, purpose, a, b) with n = 0, 1, 2, …
struct RandomStream {
  std::uint64_t seed = 0;
  Purpose purpose{};
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  std::uint32_t n = 0;  ///< the next draw's number
};

/// The next uniform number in [0, 1) of a stream.
double next_uniform(RandomStream& stream);

/// The next standard normal number of a stream, by Karney's rejection method ("Sampling exactly from the
/// normal distribution", ACM TOMS 42, 2016): comparisons of uniform numbers, no transcendental function. Uses
/// a varying number of draws, 16 on average.
double next_normal(RandomStream& stream);

/// The next standard exponential number of a stream (mean 1), by von Neumann's method ("Various techniques
/// used in connection with random digits", 1951): comparisons of uniform numbers alone. Uses a varying number
/// of draws, 4.3 on average.
double next_exponential(RandomStream& stream);

/// The next gamma number of a stream, of shape k > 0 and scale 1 (mean k, variance k), by the rejection
/// method of Marsaglia and Tsang (ACM TOMS 26, 2000). A logarithm decides the rare cases that squeezing does
/// not, and for k < 1 a power enters the number: there another C library may give another last bit.
double next_gamma(RandomStream& stream, double shape);

}  // namespace tps

// Twins: two questions that differ in the last bit of one number and have different answers.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace tps::vectors {

/// Halves the doubles between two of one sign until two adjacent ones are left that `same_as_first` tells
/// apart. REQUIRES first and last of one sign, same_as_first(first), !same_as_first(last).
template <typename Predicate>
std::pair<double, double> straddling_doubles(double first, double last, Predicate same_as_first) {
  const double sign = std::signbit(first) ? -1 : 1;
  auto near = std::bit_cast<std::uint64_t>(std::fabs(first));
  auto far = std::bit_cast<std::uint64_t>(std::fabs(last));
  while (near + 1 != far && far + 1 != near) {
    const std::uint64_t middle = near / 2 + far / 2 + (near & far & 1U);
    (same_as_first(sign * std::bit_cast<double>(middle)) ? near : far) = middle;
  }
  return {sign * std::bit_cast<double>(near), sign * std::bit_cast<double>(far)};
}

}  // namespace tps::vectors

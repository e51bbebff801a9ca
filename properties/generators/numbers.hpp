// Numbers that go where the trouble is: zeros, powers of two and their neighbours, ties, many decades. Every
// one is a number of the format.
//
// These functions draw: they are called where RapidCheck executes a generator (`cases()`, a property), and
// take what they need from it. So laws need not include RapidCheck.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <vector>

#include "properties/case.hpp"
#include "properties/format.hpp"

namespace tps::properties {

/// first ≤ n < end, each as often.
int whole(int first, int end);
bool coin();

template <typename T>
T one_of(const std::vector<T>& values) {
  return values[static_cast<std::size_t>(whole(0, static_cast<int>(values.size())))];
}
template <typename T>
T one_of(std::initializer_list<T> values) {
  return *(values.begin() + whole(0, static_cast<int>(values.size())));
}

/// Above zero: 1, small integers, tenths, powers of two and the numbers next to them, of 2^-60 … 2^60 in
/// double (format.largest_case_exponent()).
double magnitude(const Format& format);

/// Zero, or a magnitude of either sign.
double number(const Format& format);

/// A small integer, some times a power of two: sums and products of these are often exact.
double small_integer();

/// In [0, 1], its ends as often as its inside.
double coefficient(const Format& format);

/// θ_revolve in [1°, 89°]; 45° and other round angles often.
double revolve_angle(const Format& format);

/// A mass of 30 decades (in double), equal and extreme ones often.
double finite_mass(const Format& format);

Masses masses(const Format& format);
Masses finite_masses(const Format& format);

/// A vector of number(), or of small integers. Planar ones have z = 0.
Vec3 vector(const Format& format, int dimension);

}  // namespace tps::properties

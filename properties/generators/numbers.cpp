#include "properties/generators/numbers.hpp"

#include <rapidcheck.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace tps::properties {
namespace {

/// RapidCheck begins with small ranges; edges are wanted from the first case on.
template <typename T>
rc::Gen<T> of_full_size(const rc::Gen<T>& gen) {
  return rc::gen::resize(rc::kNominalSize, gen);
}

double power_of_two(int exponent) {
  return std::ldexp(1.0, exponent);
}

/// Uniform in [0, 1).
double fraction() {
  const auto bits = of_full_size(rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << 53));
  return std::ldexp(static_cast<double>(*bits), -53);
}

double any_significand(int largest_exponent) {
  const double significand = 1 + fraction();
  return std::ldexp(significand, whole(-largest_exponent, largest_exponent));
}

/// Which of some weights is drawn: its place.
int weighted(std::initializer_list<int> weights) {
  int sum = 0;
  for (const int weight : weights) sum += weight;
  int left = whole(0, sum);
  int place = 0;
  for (const int weight : weights) {
    if (left < weight) break;
    left -= weight;
    ++place;
  }
  return place;
}

double any_magnitude(const Format& format) {
  const int e = format.largest_case_exponent();
  const double next = power_of_two(1 - format.bits);  // relative distance to the next number
  switch (weighted({2, 2, 1, 1, 2, 2, 4, 2})) {
    case 0:
      return 1;
    case 1:
      return power_of_two(whole(-e, e));
    case 2:
      return power_of_two(whole(-e, e)) * (1 - next / 2);
    case 3:
      return power_of_two(whole(-e, e)) * (1 + next);
    case 4:
      return whole(1, 100) / 10.0;
    case 5:
      return whole(1, 20);
    case 6:
      return fraction() + 0.5;
    default:
      return any_significand(e / 2);
  }
}

Masses pair_of(const Format& format, double first) {
  const double second = finite_mass(format);
  switch (weighted({2, 2, 1})) {
    case 0:
      return {first, second};
    case 1:
      return {second, first};
    default:
      return {second, second};
  }
}

}  // namespace

int whole(int first, int end) {
  return *of_full_size(rc::gen::inRange(first, end));
}
bool coin() {
  return whole(0, 2) == 1;
}

double magnitude(const Format& format) {
  return format.rounded(any_magnitude(format));
}

double number(const Format& format) {
  const int sign = weighted({1, 5, 5});
  return sign == 0 ? 0.0 : sign == 1 ? magnitude(format) : -magnitude(format);
}

double small_integer() {
  const int n = whole(-12, 13);
  return std::ldexp(n, one_of({0, 0, 0, -1, 3}));
}

double coefficient(const Format& format) {
  switch (weighted({1, 1, 1, 3})) {
    case 0:
      return 0;
    case 1:
      return 1;
    case 2:
      return format.rounded(one_of({0.5, 0.9, 1e-9}));
    default:
      return format.rounded(fraction());
  }
}

double revolve_angle(const Format& format) {
  return coin() ? one_of({1.0, 30.0, 45.0, 60.0, 89.0}) : format.rounded(1 + 88 * fraction());
}

double finite_mass(const Format& format) {
  constexpr int kThirtyDecades = 50;  // 2^±50 is 10^±15
  constexpr int kOfSinglePrecision = 12;
  switch (weighted({1, 1, 3})) {
    case 0:
      return 1;
    case 1:
      return format.rounded(one_of({0.001, 0.5, 2.0, 3.0, 1000.0}));
    default:
      return format.rounded(any_significand(format.bits <= 24 ? kOfSinglePrecision : kThirtyDecades));
  }
}

Masses masses(const Format& format) {
  const bool infinite = whole(0, 5) == 0;
  return pair_of(format, infinite ? std::numeric_limits<double>::infinity() : finite_mass(format));
}

Masses finite_masses(const Format& format) {
  return pair_of(format, finite_mass(format));
}

Vec3 vector(const Format& format, int dimension) {
  const bool integers = whole(0, 4) == 0;
  Vec3 x{};
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
    x[k] = integers ? small_integer() : number(format);
  return x;
}

}  // namespace tps::properties

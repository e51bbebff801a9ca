#include "properties/generators/simpler.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tps::properties {
namespace {

int significant_bits(double x) {
  int exponent = 0;
  auto bits = static_cast<std::int64_t>(std::ldexp(std::frexp(std::fabs(x), &exponent), 53));
  int count = 53;
  for (; bits % 2 == 0; bits /= 2) --count;
  return count;
}

/// 0 is read at a glance; a number costs its bits and its distance from 1.
double complexity(Kind kind, double x) {
  if (kind == Kind::angle && x == 45) return 0;
  if (kind == Kind::coefficient && x == 1) return 0;
  if (x == 0) return 0;
  if (std::isinf(x)) return 4;
  return 2 * significant_bits(x) + std::abs(std::ilogb(x)) + (x < 0 ? 0.5 : 0);
}

double with_bits(double x, int bits) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(fraction, bits)), exponent - bits);
}

std::vector<double> simpler_numbers(Kind kind, double x) {
  if (kind == Kind::index) return {};
  std::vector<double> tries{0, 1, 0.5, 45, 30};
  if (std::isfinite(x) && x != 0) {
    const int exponent = std::ilogb(x);
    tries.insert(tries.end(), {std::copysign(1, x), -x, std::trunc(x), std::ldexp(x, -exponent),
                               std::ldexp(x, exponent > 0 ? -1 : 1)});
    if (kind != Kind::exponent) tries.push_back(std::ldexp(x, -exponent / 2));
    for (const int bits : {1, 2, 3, 5, 8, 16, 30, 45, 52}) {
      tries.push_back(with_bits(x, bits));
      if (kind == Kind::exponent) tries.back() = std::trunc(x / 2);
    }
  }
  const double now = complexity(kind, x);
  std::erase_if(tries, [&](double y) { return !is_allowed(kind, y) || complexity(kind, y) >= now; });
  return tries;
}

/// Drops z.
void add_planar(const Case& c, std::vector<Case>& found) {
  const bool vectors_only =
      std::none_of(c.numbers.begin(), c.numbers.end(), [](const auto& n) { return n.first == "m"; });
  if (c.dimension == 2 || !vectors_only) return;
  Case planar = c;
  planar.dimension = 2;
  for (auto& [key, values] : planar.numbers) {
    if (is_vector(key)) values.resize(2);
  }
  found.push_back(planar);
}

/// Puts A into the origin, or to rest.
void add_seen_from_A(const Case& c, const Format& format, std::vector<Case>& found) {
  for (const char* letter : {"u", "v"}) {
    const std::string A = std::string(letter) + "_A", B = std::string(letter) + "_B";
    if (!c.numbers.contains(A) || !c.numbers.contains(B)) continue;
    Case moved = c;
    std::vector<double>& at_A = moved.numbers[A];
    for (std::size_t k = 0; k < at_A.size(); ++k) {
      moved.numbers[B][k] = format.rounded(moved.numbers[B][k] - at_A[k]);
      at_A[k] = 0;
    }
    found.push_back(moved);
  }
}

/// One collision of a group less.
void add_fewer_collisions(const Case& c, std::vector<Case>& found) {
  if (!c.numbers.contains("j") || c.numbers.at("j").size() < 2) return;
  Case fewer = c;
  for (const char* key : {"i", "j", "c"}) fewer.numbers[key].pop_back();
  found.push_back(fewer);
}

void add_simpler_numbers(const Case& c, std::vector<Case>& found) {
  for (const auto& [key, values] : c.numbers) {
    for (std::size_t k = 0; k < values.size(); ++k) {
      for (const double x : simpler_numbers(kind_of(key), values[k])) {
        found.push_back(c);
        found.back().numbers[key][k] = x;
      }
    }
  }
}

}  // namespace

double complexity(const Case& c) {
  double sum = 0;
  for (const auto& [key, values] : c.numbers) {
    for (const double x : values) sum += 0.25 + complexity(kind_of(key), x);
  }
  return sum;
}

std::vector<Case> simpler(const Case& c, const Format& format) {
  std::vector<Case> found;
  add_planar(c, found);
  add_seen_from_A(c, format, found);
  add_fewer_collisions(c, found);
  add_simpler_numbers(c, found);
  const double now = complexity(c);
  std::erase_if(found, [now](const Case& each) { return complexity(each) >= now; });
  return found;
}

}  // namespace tps::properties

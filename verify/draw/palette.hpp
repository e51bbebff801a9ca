// Colours of a picture.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

namespace tps {

struct Rgb {
  int red = 0;
  int green = 0;
  int blue = 0;
};

inline constexpr Rgb kBackground{250, 248, 244};
inline constexpr Rgb kInk{45, 45, 52};
inline constexpr Rgb kTether{96, 96, 104};

// Okabe and Ito's colours, which the common forms of colour blindness tell apart; species take them in turn,
// clusters take deeper ones.
inline constexpr std::array<Rgb, 6> kSpeciesColours{
    {{86, 180, 233}, {230, 159, 0}, {0, 158, 115}, {204, 121, 167}, {240, 228, 66}, {0, 114, 178}}};
inline constexpr std::array<Rgb, 6> kClusterColours{
    {{192, 40, 20}, {110, 40, 150}, {0, 105, 60}, {10, 60, 160}, {170, 20, 100}, {120, 85, 0}}};

template <std::size_t N>
Rgb cyclic(const std::array<Rgb, N>& colours, int i) {
  return colours[static_cast<std::size_t>(i) % N];
}

/// From `from` (share 0) to `to` (share 1).
inline Rgb mixed(Rgb from, Rgb to, double share) {
  const auto mix = [&](int a, int b) { return static_cast<int>(std::lround(a + (b - a) * share)); };
  return {mix(from.red, to.red), mix(from.green, to.green), mix(from.blue, to.blue)};
}

/// Far things keep 45 % of their colour.
inline Rgb faded(Rgb colour, double depth) {
  return mixed(kBackground, colour, 0.45 + 0.55 * depth);
}

inline std::string hex(Rgb c) {
  return fmt::format("#{:02x}{:02x}{:02x}", c.red, c.green, c.blue);
}

}  // namespace tps

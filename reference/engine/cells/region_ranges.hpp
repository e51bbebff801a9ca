// Which regions are within reach of a region; in a periodic box, by which way round.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "reference/engine/cells/region_grid.hpp"
#include "reference/scene/scene.hpp"

namespace tps {

/// Regions of one lattice around those of another.
template <int D>
struct RegionRanges {
  static constexpr std::size_t kAxes = static_cast<std::size_t>(D);
  using Shift = std::array<double, kAxes>;  ///< whole edges of the box, as lengths

  double own;                ///< side of a region around which is looked
  double other;              ///< side of those that are looked for
  const Coordinates& edges;  ///< of a periodic box; 0 or infinite: none along that axis

  /// Those of which a part is nearer than `reach` along every axis, shifted.
  RegionRange<D> around(const Region<D>& region, double reach, const Shift& shift) const {
    RegionRange<D> range;
    for (std::size_t k = 0; k < kAxes; ++k) {
      range.low[k] = floor_of((low(region[k], reach) + shift[k]) / other);
      range.high[k] = floor_of((high(region[k], reach) + shift[k]) / other);
    }
    return range;
  }

  /// Calls use(range, shift) for each way in which what is around lies in the box; without one, once.
  template <typename Use>
  void for_each(const Region<D>& region, double reach, Use use) const {
    std::array<std::array<double, 3>, kAxes> shifts{};
    std::array<std::size_t, kAxes> ways{};
    for (std::size_t k = 0; k < kAxes; ++k) {
      ways[k] = 1;
      const double edge = edges[k];
      if (!(edge > 0 && edge < std::numeric_limits<double>::infinity())) continue;
      ways[k] = 0;
      for (const double shift : {0.0, -edge, edge}) {
        const bool is_in =
            high(region[k], reach) + shift >= -other && low(region[k], reach) + shift <= edge + other;
        if (is_in) shifts[k][ways[k]++] = shift;
      }
    }
    const std::size_t layers = D == 3 ? ways[kAxes - 1] : 1;
    for (std::size_t z = 0; z < layers; ++z) {
      for (std::size_t y = 0; y < ways[1]; ++y) {
        for (std::size_t x = 0; x < ways[0]; ++x) {
          Shift shift{shifts[0][x], shifts[1][y]};
          if (D == 3) shift[kAxes - 1] = shifts[kAxes - 1][z];
          use(around(region, reach, shift), shift);
        }
      }
    }
  }

 private:
  double low(std::int32_t region, double reach) const { return region * own - reach; }
  double high(std::int32_t region, double reach) const { return (region + 1.0) * own + reach; }

  /// ⌊x⌋ without a call of the library. REQUIRES |x| < 2³¹.
  static std::int32_t floor_of(double x) {
    const auto towards_zero = static_cast<std::int32_t>(x);
    return towards_zero - (x < towards_zero ? 1 : 0);
  }
};

}  // namespace tps

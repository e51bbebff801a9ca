// Which regions are within reach of a region; in a periodic box, by which way round.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "reference/engine/cells/region_grid.hpp"
#include "reference/scene/scene.hpp"

namespace tps {

/// Regions of one lattice that are within reach of a region of another, or of the same one; of those in a
/// second range, the ones that are known already.
template <int D>
class RegionRanges {
 public:
  struct Sides {
    double own;    ///< of a region around which is looked
    double other;  ///< of those that are looked for
  };

  /// `edges` of a periodic box; 0 or infinite: none along that axis. `left`, if it is not null, is a region
  /// from which everyone within `known` is known.
  RegionRanges(const Sides& sides, const Coordinates& edges, const Region<D>& region, double reach,
               const Region<D>* left, double known) {
    const Lattice to{sides.own, 1 / sides.other};
    for (std::size_t k = 0; k < kAxes; ++k) {
      const double edge = edges[k];
      const bool is_closed = edge > 0 && edge < std::numeric_limits<double>::infinity();
      const auto add = [&](double shift) {
        Way& way = ways_[k][count_[k]++];
        way.range = to.around(region[k], reach, shift);
        way.known = left == nullptr ? way.range : to.around((*left)[k], known, shift);
      };
      if (!is_closed) {
        add(0);
        continue;
      }
      const double low = region[k] * sides.own - reach;
      const double high = (region[k] + 1.0) * sides.own + reach;
      for (const double shift : {0.0, -edge, edge}) {
        if (high + shift >= -sides.other && low + shift <= edge + sides.other) add(shift);
      }
    }
  }

  /// Calls use(range, known) for each way in which what is around lies in the box; without one, once.
  template <typename Use>
  void for_each(Use use) const {
    const std::size_t layers = D == 3 ? count_[kAxes - 1] : 1;
    RegionRange<D> range, known;
    const auto choose = [&](std::size_t k, std::size_t n) {
      const Way& way = ways_[k][n];
      range.low[k] = way.range.low;
      range.high[k] = way.range.high;
      known.low[k] = way.known.low;
      known.high[k] = way.known.high;
    };
    for (std::size_t z = 0; z < layers; ++z) {
      if (D == 3) choose(kAxes - 1, z);
      for (std::size_t y = 0; y < count_[1]; ++y) {
        choose(1, y);
        for (std::size_t x = 0; x < count_[0]; ++x) {
          choose(0, x);
          use(range, known);
        }
      }
    }
  }

 private:
  static constexpr std::size_t kAxes = static_cast<std::size_t>(D);

  /// Along one axis, from low to high, both included.
  struct Span {
    std::int32_t low, high;
  };
  struct Way {
    Span range, known;
  };
  struct Lattice {
    double own, per_other;

    /// Those of which a part is nearer than `reach`, shifted by a length.
    Span around(std::int32_t region, double reach, double shift) const {
      return {floor_of((region * own - reach + shift) * per_other),
              floor_of(((region + 1.0) * own + reach + shift) * per_other)};
    }
  };

  /// ⌊x⌋ without a call of the library. REQUIRES |x| < 2³¹.
  static std::int32_t floor_of(double x) {
    const auto towards_zero = static_cast<std::int32_t>(x);
    return towards_zero - (x < towards_zero ? 1 : 0);
  }

  std::array<std::array<Way, 3>, kAxes> ways_;
  std::array<std::size_t, kAxes> count_{};
};

}  // namespace tps

// How space is divided for a scene: margins, and for each kind of particle the size of its regions and who
// can be met how far away. Sizes come from the pair laws, never from the volume that the particles fill.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "reference/engine/laws.hpp"
#include "reference/engine/timing.hpp"
#include "reference/scene/scene.hpp"

namespace tps {

/// Species of similar size. A region is a cube of the lattice of its level.
struct RegionLevel {
  double side;               ///< of a region
  int shift;                 ///< a bucket of the grid is 2^shift regions wide, one at least
  int regions_within_reach;  ///< of its own, to either side, at most
  int doublings = 0;         ///< of the side since the plan was made
};

/// Margins, levels and reaches of a scene, in double whatever the scalar (docs/scale.md derives them).
///
/// Notation: L a limiting distance, h the margin, u = max(ε/2, 2⁻⁵³).
class RegionPlan {
 public:
  static constexpr int kNone = -1;
  /// Regions per interaction distance: 2 asks 5^D small cubes instead of 3^D large ones.
  static constexpr double kRegionsPerReach = 2;

  template <typename Scalar>
  static RegionPlan of(const Scene& scene, const TimingChoice& timing) {
    using Limits = std::numeric_limits<Scalar>;
    const double u = std::max(static_cast<double>(Limits::epsilon()) / 2, 0x1p-53);
    const double largest = std::ldexp(1.0, std::min(Limits::max_exponent / 8, 120));
    const double smallest = std::ldexp(1.0, std::max(Limits::min_exponent / 8, -120));
    return RegionPlan(scene, u, largest, smallest, timing.timing == Timing::paper);
  }

  /// The level of a species' regions; kNone where nobody is to be found by place.
  int level(int species) const { return level_of_[at(species)]; }
  const std::vector<RegionLevel>& levels() const { return levels_; }
  /// How far from a region of a species the regions of a level are to be asked; negative: none of them.
  double reach(int species, int level) const { return reach_[at(species) * levels_.size() + at(level)]; }

  /// How far from a region of a species everyone of a level has been asked, whichever of the two came last.
  double known(int species, int level) const { return known_[at(species) * levels_.size() + at(level)]; }

  /// A species that is tethered to another for ever, and when its members' limits can be reached.
  struct Permanent {
    int species;
    double near;  ///< nearer than this they may block; negative: never
    double far;   ///< farther than this they may be pulled
  };
  const std::vector<Permanent>& permanent(int species) const { return permanent_[at(species)]; }

  /// Whether particles of two regions, of levels i and j, can be at a limit of such a pair.
  template <typename Region>
  bool is_within_reach(int level_i, const Region& region_i, int level_j, const Region& region_j,
                       const Permanent& partner) const {
    const double side_i = levels_[at(level_i)].side;
    const double side_j = levels_[at(level_j)].side;
    double nearest = 0;
    double farthest = 0;
    for (std::size_t k = 0; k < region_i.size(); ++k) {
      const double low_i = region_i[k] * side_i - margin_;
      const double low_j = region_j[k] * side_j - margin_;
      const double up = low_j + side_j + 2 * margin_ - low_i;    // of j above the lowest of i
      const double down = low_i + side_i + 2 * margin_ - low_j;  // of i above the lowest of j
      const double gap = std::max({0.0, -up, -down});
      nearest += gap * gap;
      farthest += std::max(up, down) * std::max(up, down);
    }
    return nearest < partner.near * std::fabs(partner.near) || farthest > partner.far * partner.far;
  }

  /// Whether in a periodic box two particles that stay in their regions, widened by the margin, can meet by
  /// no image but the one that was nearest (docs/effects.md, "Periodic box"). False where there are no
  /// regions.
  bool fits_into(const PeriodicEdges& box, int dimension) const;

  /// Makes a level's regions twice as wide, where the particles are few and fly far; what is proven of
  /// regions holds for any width. @return false, and does nothing, where they are as wide as they may
  /// get: in a periodic box the room that a pair has for its nearest image is not halved.
  bool widen(int level, const std::optional<PeriodicEdges>& box, int dimension);
  /// Takes a widening back. @return false where there was none.
  bool narrow(int level);

  /// How far along an axis a particle that no region keeps may fly before it is asked for its images again.
  /// REQUIRES fits_into().
  double longest_roam(const PeriodicEdges& box, int dimension) const {
    return spare_room(box, dimension) / 4;
  }

  /// h: regions are wider by it on every side.
  double margin() const { return margin_; }
  /// Whether a particle can be kept in regions: rounding stays within the margin, and no square leaves the
  /// range of the scalar.
  bool keeps(double coordinate, double speed, double flight, double time) const {
    return coordinate < longest_coordinate_ && flight < longest_flight_ && speed < largest_ &&
           speed * time < longest_path_;
  }
  double longest_flight() const { return longest_flight_; }
  /// Under literal timing a component whose squares underflow has to be seen by all.
  double smallest_component() const { return smallest_component_; }

 private:
  RegionPlan(const Scene& scene, double u, double largest, double smallest, bool literal);

  static std::size_t at(int n) { return static_cast<std::size_t>(n); }
  void count_regions_within_reach();
  /// Makes a level's regions 2^doublings times as wide.
  void scale(int level, int doublings);
  /// W/2 − L less what two particles in their regions can move relative to each other.
  double spare_room(const PeriodicEdges& box, int dimension) const;

  std::vector<RegionLevel> levels_;
  std::vector<int> level_of_;
  std::vector<double> reach_, known_;
  std::vector<std::vector<Permanent>> permanent_;
  double margin_ = 0;
  double longest_interaction_ = 0;
  double longest_coordinate_ = 0;
  double longest_flight_ = 0;
  double longest_path_ = 0;
  double largest_ = 0;
  double smallest_component_ = 0;
};

}  // namespace tps

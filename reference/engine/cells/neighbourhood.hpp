// Where the particles of a run are, region by region, and whom each of them can meet while all stay where
// they are.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "reference/engine/cells/region_grid.hpp"
#include "reference/engine/cells/region_plan.hpp"
#include "reference/engine/cells/region_ranges.hpp"
#include "reference/engine/world.hpp"

namespace tps {

/// Law: while every particle stays in its region, widened by the margin, a pair that meets is one of those
/// that around() visits for either of the two (docs/scale.md).
template <typename Scalar, int D>
class Neighbourhood {
 public:
  explicit Neighbourhood(const World<Scalar, D>& world, const TimingChoice& timing)
      : plan_(RegionPlan::of<Scalar>(world.scene, timing)) {
    if (world.scene.box) wraps_.assign(world.particles.size(), {});
  }

  /// Files every particle at its place now; with `everywhere` it is visited by all, wherever it is.
  void place_all(const World<Scalar, D>& world, bool everywhere) {
    if (world.scene.box) longest_roam_ = plan_.longest_roam(*world.scene.box, D);
    const std::size_t size = world.particles.size();
    for (int k = 0; world.box && k < D; ++k) edges_[at(k)] = static_cast<double>(world.box->edges()[k]);
    filed_.assign(size, {});
    roams_.assign(size, false);
    roaming_.clear();
    of_species_.assign(world.scene.species.size(), {});
    members_.assign(plan_.levels().size(), {});
    for (int i = 0; i < world.size(); ++i) {
      of_species_[at(world.species(i))].push_back(i);
      if (level_of(world, i) == RegionPlan::kNone) continue;
      members_[at(level_of(world, i))].push_back(i);
    }
    std::vector<int> kept;
    grids_.assign(members_.size(), {});
    for (std::size_t level = 0; level < members_.size(); ++level) {
      kept.clear();
      for (const int i : members_[level]) {
        const std::optional<Region<D>> region = everywhere ? std::nullopt : region_now(world, i, world.now);
        if (region) {
          filed_[at(i)].region = *region;
          kept.push_back(i);
        } else {
          roam(i);
        }
      }
      grids_[level].build(kept, plan_.levels()[level].shift, filed_);
    }
  }

  /// Makes the regions of a level twice as wide, or takes that back. @return whether it did: then everyone is
  /// to be filed anew.
  bool widen(const World<Scalar, D>& world, int level) { return plan_.widen(level, world.scene.box, D); }
  bool narrow(int level) { return plan_.narrow(level); }

  /// Asks memory for where a particle is filed.
  void prefetch(int i) const { __builtin_prefetch(&filed_[at(i)]); }

  /// The same for the buckets in which those of its own level are whom it can meet.
  void prefetch_around(const World<Scalar, D>& world, int i) const {
    if (!has_level(world, i)) return;
    const std::size_t level = at(level_of(world, i));
    grids_[level].prefetch_around(filed_[at(i)].region, plan_.levels()[level].regions_within_reach);
  }

  bool roams(int i) const { return roams_[at(i)]; }

  /// A particle with a level is where its region no longer bounds it, or roams: files it anew.
  /// @return the region that it left, or nothing where it roamed before or roams now.
  std::optional<Region<D>> move(const World<Scalar, D>& world, int i, const Time<Scalar>& t) {
    const auto level = at(level_of(world, i));
    const auto wraps = world.box ? wraps_[at(i)] : Wraps{};
    const std::optional<Region<D>> region = region_now(world, i, t);
    std::optional<Region<D>> left;
    if (!roams(i)) {
      grids_[level].remove(i, filed_);
      // Across an edge of the box: whom it could meet from there, it did by another image.
      if (!world.box || wraps == wraps_[at(i)]) left = filed_[at(i)].region;
    } else {
      std::erase(roaming_, i);
      roams_[at(i)] = false;
    }
    if (!region) {
      roam(i);
      return std::nullopt;
    }
    filed_[at(i)].region = *region;
    grids_[level].file(i, filed_);
    return left;
  }

  /// A particle that its region cannot keep roams.
  void set_free(const World<Scalar, D>& world, int i) {
    grids_[at(level_of(world, i))].remove(i, filed_);
    roam(i);
  }

  int level_of(const World<Scalar, D>& world, int i) const { return plan_.level(world.species(i)); }
  bool has_level(const World<Scalar, D>& world, int i) const {
    return level_of(world, i) != RegionPlan::kNone;
  }

  /// When a particle may leave its region, widened by half of the margin, or has flown as far as is allowed;
  /// nothing where it cannot be kept in it even now.
  std::optional<Time<Scalar>> leaves(const World<Scalar, D>& world, int i, const Time<Scalar>& now) const {
    const ParticleState<Scalar, D>& p = world.particles[at(i)];
    const RegionLevel& level = plan_.levels()[at(level_of(world, i))];
    const Region<D>& region = filed_[at(i)].region;
    const double half = plan_.margin() / 2;
    if (roams(i)) return after_roaming(p, now);
    double dt = HUGE_VAL;
    double speed = 0;
    for (int k = 0; k < D; ++k) {
      const double u = static_cast<double>(p.position[k]);
      const double v = static_cast<double>(p.velocity[k]);
      if (v == 0) continue;
      double low = region[at(k)] * level.side;
      if (world.box) low += wraps_[at(i)][at(k)] * static_cast<double>(world.box->edges()[k]);
      const double bound = v > 0 ? low + level.side + half : low - half;
      dt = std::min(dt, (bound - u) / v);
      speed += std::fabs(v);
    }
    if (speed == 0) return Time<Scalar>::never();
    dt = std::min(dt, plan_.longest_flight() / speed);
    if (!(dt > static_cast<double>(elapsed(p.clock, now)))) return std::nullopt;
    // In a narrow scalar what is left may round to nothing: a look has to be later than the one before.
    const Time<Scalar> leaving = after(p.clock, Scalar(dt));
    if (!(now < leaving)) return std::nullopt;
    return leaving;
  }

  /// When a particle that no region keeps is to be asked for its images again; never in unbounded space.
  std::optional<Time<Scalar>> after_roaming(const ParticleState<Scalar, D>& p,
                                            const Time<Scalar>& now) const {
    double speed = 0;
    for (int k = 0; k < D; ++k) speed = std::max(speed, std::fabs(static_cast<double>(p.velocity[k])));
    if (wraps_.empty() || speed == 0) return Time<Scalar>::never();
    return after(now, Scalar(longest_roam_ / speed));
  }

  /// Appends everyone whom a particle can meet, some more than once. Those whom it could meet from the region
  /// that it has `left`, too, are not appended, except partners for ever.
  void around(const World<Scalar, D>& world, int i, const std::optional<Region<D>>& left,
              std::vector<int>& found) const {
    if (roams(i)) {
      for (int j = 0; j < world.size(); ++j) {
        if (j != i) found.push_back(j);
      }
      return;
    }
    const int species = world.species(i);
    if (!left) {
      const std::vector<int>& tethered = world.tethers.of(i);
      found.insert(found.end(), tethered.begin(), tethered.end());
      found.insert(found.end(), roaming_.begin(), roaming_.end());
    }
    if (!has_level(world, i)) return;
    find_partners_for_ever(world, i, found);
    const std::size_t begin = found.size();
    const double own = plan_.levels()[at(level_of(world, i))].side;
    for (std::size_t level = 0; level < grids_.size(); ++level) {
      const double reach = plan_.reach(species, static_cast<int>(level));
      if (reach < 0) continue;
      const double known = plan_.known(species, static_cast<int>(level));
      const RegionRanges<D> ranges({own, plan_.levels()[level].side}, edges_, filed_[at(i)].region, reach,
                                   left ? &*left : nullptr, known);
      ranges.for_each([&](const RegionRange<D>& range, const RegionRange<D>& asked) {
        if (left) {
          const auto is_new = [i, asked](int j, const Region<D>& region) {
            return (j != i) & !asked.contains(region);
          };
          search(level, range, is_new, found);
        } else {
          search(
              level, range, [i](int j, const Region<D>&) { return j != i; }, found);
        }
      });
    }
    std::size_t kept = begin;
    const bool is_tied = !plan_.permanent(species).empty() || world.tethers.count(i) > 0;
    for (std::size_t n = begin; n < found.size(); ++n) {
      const int j = found[n];
      if (is_tied && world.tethered(i, j)) continue;
      __builtin_prefetch(&world.particles[at(j)]);
      found[kept++] = j;
    }
    found.resize(kept);
  }

 private:
  static constexpr std::size_t kAxes = static_cast<std::size_t>(D);
  using Wraps = std::array<double, kAxes>;  ///< edges by which a place is off the box

  static constexpr std::size_t at(int n) { return static_cast<std::size_t>(n); }

  void roam(int i) {
    roams_[at(i)] = true;
    roaming_.push_back(i);
  }

  /// The region of a particle at a time, or nothing where it cannot be kept in one.
  std::optional<Region<D>> region_now(const World<Scalar, D>& world, int i, const Time<Scalar>& t) const {
    const ParticleState<Scalar, D>& p = world.particles[at(i)];
    Vector<Scalar, D> place = world.position(i, t);
    const RegionLevel& level = plan_.levels()[at(level_of(world, i))];
    const Wraps wrapped = wrap(world, i, place);
    Region<D> region;
    double largest = 0;
    double speed = 0;
    double flight = 0;
    for (int k = 0; k < D; ++k) {
      const double u = static_cast<double>(p.position[k]);
      const double x = static_cast<double>(place[k]);
      const double v = std::fabs(static_cast<double>(p.velocity[k]));
      if (v != 0 && !(v > plan_.smallest_component())) return std::nullopt;
      largest = std::max({largest, std::fabs(u), std::fabs(x)});
      speed += v;
      flight += std::fabs(x - u);
      const double scaled = std::floor(wrapped[at(k)] / level.side);
      region[at(k)] = std::fabs(scaled) < 0x1p30 ? static_cast<std::int32_t>(scaled) : 0;
    }
    if (!plan_.keeps(largest, speed, flight, static_cast<double>(t.hi))) return std::nullopt;
    return region;
  }

  /// Coordinates in the box; how many edges they are off is kept.
  Wraps wrap(const World<Scalar, D>& world, int i, const Vector<Scalar, D>& place) const {
    Wraps inside{};
    for (int k = 0; k < D; ++k) {
      const double x = static_cast<double>(place[k]);
      const double edge = world.box ? static_cast<double>(world.box->edges()[k]) : 0;
      const double n = edge > 0 ? std::floor(x / edge) : 0;
      inside[at(k)] = x - n * edge;
      if (edge > 0) wraps_[at(i)][at(k)] = n;
    }
    return inside;
  }

  /// Appends everyone of a level whose region is in the range and wanted.
  template <typename Keep>
  void search(std::size_t level, const RegionRange<D>& range, Keep keep, std::vector<int>& found) const {
    if (!grids_[level].is_wider_than_its_members(range)) {
      grids_[level].search(range, filed_, keep, heads_, found);
      return;
    }
    for (const int j : members_[level]) {
      const Region<D>& region = filed_[at(j)].region;
      if (!roams(j) && range.contains(region) && keep(j, region)) found.push_back(j);
    }
  }

  /// Those of the partners for ever whose limits are within reach: a ball far from its container's wall is
  /// not asked.
  void find_partners_for_ever(const World<Scalar, D>& world, int i, std::vector<int>& found) const {
    for (const RegionPlan::Permanent& partner : plan_.permanent(world.species(i))) {
      for (const int j : of_species_[at(partner.species)]) {
        if (j != i && (world.box || roams(j) || is_within_reach(world, i, j, partner))) found.push_back(j);
      }
    }
  }

  bool is_within_reach(const World<Scalar, D>& world, int i, int j,
                       const RegionPlan::Permanent& partner) const {
    return plan_.is_within_reach(level_of(world, i), filed_[at(i)].region, level_of(world, j),
                                 filed_[at(j)].region, partner);
  }

  RegionPlan plan_;
  FiledRegions<D> filed_;
  std::vector<RegionGrid<D>> grids_;       ///< by level
  std::vector<std::vector<int>> members_;  ///< by level, roaming ones included
  std::vector<std::vector<int>> of_species_;
  std::vector<bool> roams_;
  std::vector<int> roaming_;
  /// In a periodic box: how many edges each filed particle is off, and how far others may fly between two
  /// looks.
  mutable std::vector<Wraps> wraps_;
  mutable std::vector<int> heads_;  ///< of the buckets that a search has yet to walk
  Coordinates edges_{};             ///< of the box; 0 along an open axis
  double longest_roam_ = 0;
};

}  // namespace tps

#include "reference/engine/cells/region_plan.hpp"

#include <numeric>
#include <optional>

#include "reference/engine/periodic_box.hpp"

namespace tps {
namespace {

/// Species of one level differ in size by no more than this factor.
constexpr double kSpread = 1.5;
/// Regions a million times as wide hold whoever flies that far.
constexpr int kMostDoublings = 20;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The distances of a scene, species by species; kInfinity where there is no law or nobody to follow it.
class Distances {
 public:
  explicit Distances(const Scene& scene) : species_(scene.species.size()), present_(species_, 0) {
    for (const Particle& p : scene.particles) ++present_[static_cast<std::size_t>(p.species)];
    blocking.assign(species_ * species_, kInfinity);
    tethering.assign(species_ * species_, kInfinity);
    for (const PairLaw& law : scene.pairs) {
      const auto a = static_cast<std::size_t>(law.species_a);
      const auto b = static_cast<std::size_t>(law.species_b);
      if (present_[a] == 0 || present_[b] == 0 || (a == b && present_[a] == 1)) continue;
      const bool permanent = law.tethering && law.tethering->form.when == FormRule::When::permanent;
      for (const std::size_t n : {a * species_ + b, b * species_ + a}) {
        if (law.blocking) blocking[n] = law.blocking->distance;
        if (permanent) tethering[n] = law.tethering->distance;
      }
    }
  }

  std::size_t count() const { return species_; }
  /// Blocking of two species that are not tethered for ever.
  double free(std::size_t a, std::size_t b) const {
    return tethering[a * species_ + b] < kInfinity ? kInfinity : blocking[a * species_ + b];
  }
  std::vector<double> blocking;   ///< by pair of species
  std::vector<double> tethering;  ///< of permanent tethers

 private:
  std::size_t species_;
  std::vector<std::size_t> present_;
};

/// Fewer particles than this in a cube as wide as their size, on average over the box that holds the species:
/// then flights are long, and leaving a region costs more than asking a few neighbours more.
constexpr double kDilute = 0.2;

bool is_dilute(const Scene& scene, std::size_t species, double size) {
  Coordinates low{}, high{};
  double filled = 0;
  for (const Particle& p : scene.particles) {
    if (static_cast<std::size_t>(p.species) != species) continue;
    for (std::size_t k = 0; k < p.position.size(); ++k) {
      low[k] = filled == 0 ? p.position[k] : std::min(low[k], p.position[k]);
      high[k] = filled == 0 ? p.position[k] : std::max(high[k], p.position[k]);
    }
    ++filled;
  }
  for (std::size_t k = 0; k < low.size(); ++k) filled *= size / std::max(size, high[k] - low[k]);
  return filled < kDilute;
}

}  // namespace

RegionPlan::RegionPlan(const Scene& scene, double u, double largest, double smallest, bool literal)
    : permanent_(scene.species.size()), largest_(largest), smallest_component_(literal ? smallest : 0) {
  longest_interaction_ = longest_interaction(scene);
  const Distances d(scene);
  const std::size_t n = d.count();
  level_of_.assign(n, kNone);

  // The size of a species: the smallest distance at which it is blocked.
  std::vector<double> size(n, kInfinity);
  double shortest = kInfinity;
  double longest = 0;
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) size[a] = std::min(size[a], d.free(a, b));
    for (std::size_t b = 0; b < n; ++b) {
      for (const double L : {d.blocking[a * n + b], d.tethering[a * n + b]}) {
        if (!(L < kInfinity)) continue;
        shortest = std::min(shortest, L);
        longest = std::max(longest, L);
      }
    }
  }
  if (!(shortest < kInfinity)) return;
  margin_ = shortest / 64;
  const double most_units = margin_ * shortest / (512 * u);
  if (shortest > smallest && longest < largest && longest < margin_ / (512 * u)) {
    longest_coordinate_ = std::min({margin_ / (84 * u), 0x1p29 * margin_, largest});
    longest_flight_ = std::sqrt(most_units) - shortest;
    longest_path_ = margin_ / (32 * u * u);
  }

  std::vector<std::size_t> by_size(n);
  std::iota(by_size.begin(), by_size.end(), std::size_t{0});
  std::sort(by_size.begin(), by_size.end(), [&](std::size_t a, std::size_t b) { return size[a] < size[b]; });
  double level_size = 0;
  for (const std::size_t a : by_size) {
    if (!(size[a] < kInfinity)) break;
    if (levels_.empty() || size[a] > kSpread * level_size) {
      level_size = size[a];
      // Regions bound a flight, buckets hold what is found together: a large one among small ones moves
      // little.
      double partner = level_size;
      for (std::size_t b = 0; b < n; ++b) {
        if (d.free(a, b) < kInfinity) partner = std::min(partner, size[b]);
      }
      const double regions = is_dilute(scene, a, level_size) ? 1 : kRegionsPerReach;
      const double side = (std::max(partner, level_size / 16) + 3 * margin_) / regions;
      const double bucket = level_size + 3 * margin_;
      const int shift = static_cast<int>(std::floor(std::log2(bucket / side) + 0.5));
      levels_.push_back({side * (1 + 0x1p-20), std::max(0, shift), 0});
    }
    level_of_[a] = static_cast<int>(levels_.size()) - 1;
  }

  // Who is nobody's neighbour but somebody's container.
  for (std::size_t a = 0; a < n; ++a) {
    double radius = kInfinity;
    for (std::size_t b = 0; b < n; ++b) radius = std::min(radius, d.tethering[a * n + b]);
    if (level_of_[a] != kNone || !(radius < kInfinity)) continue;
    level_of_[a] = static_cast<int>(levels_.size());
    levels_.push_back({radius / 16, 0, 0});
  }

  reach_.assign(n * levels_.size(), -1);
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      if (d.tethering[a * n + b] < kInfinity) {
        const double block = d.blocking[a * n + b];
        permanent_[a].push_back({static_cast<int>(b), block < kInfinity ? block + margin_ : -1,
                                 d.tethering[a * n + b] - margin_});
      }
      if (!(d.free(a, b) < kInfinity)) continue;
      double& reach = reach_[a * levels_.size() + static_cast<std::size_t>(level_of_[b])];
      reach = std::max(reach, d.free(a, b) + 3 * margin_);
    }
  }
  count_regions_within_reach();
  known_ = reach_;
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      if (!(d.free(a, b) < kInfinity)) continue;
      double& known = known_[a * levels_.size() + static_cast<std::size_t>(level_of_[b])];
      const double other = reach_[b * levels_.size() + static_cast<std::size_t>(level_of_[a])];
      known = std::min(known, other - margin_ / 2);
    }
  }
}

void RegionPlan::count_regions_within_reach() {
  for (RegionLevel& level : levels_) level.regions_within_reach = 0;
  for (std::size_t a = 0; a < level_of_.size(); ++a) {
    if (level_of_[a] == kNone) continue;
    const double own = reach(static_cast<int>(a), level_of_[a]);
    if (own < 0) continue;
    RegionLevel& level = levels_[at(level_of_[a])];
    level.regions_within_reach = std::max(level.regions_within_reach, static_cast<int>(own / level.side) + 1);
  }
}

void RegionPlan::scale(int level, int doublings) {
  RegionLevel& scaled = levels_[at(level)];
  scaled.side = std::ldexp(scaled.side, doublings);
  scaled.shift -= doublings;
  scaled.doublings += doublings;
  count_regions_within_reach();
}

bool RegionPlan::widen(int level, const std::optional<PeriodicEdges>& box, int dimension) {
  if (levels_[at(level)].doublings == kMostDoublings) return false;
  const double room = box ? spare_room(*box, dimension) : kInfinity;
  scale(level, 1);
  if (!box || spare_room(*box, dimension) > room / 2) return true;
  scale(level, -1);
  return false;
}

bool RegionPlan::narrow(int level) {
  if (levels_[at(level)].doublings == 0) return false;
  scale(level, -1);
  return true;
}

double RegionPlan::spare_room(const PeriodicEdges& box, int dimension) const {
  double side = 0;
  for (const RegionLevel& level : levels_) side = std::max(side, level.side);
  double room = kInfinity;
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
    room = std::min(room, (box.edges[k] / 2 - longest_interaction_) * (63. / 64));
  return room - 2 * (side + 2 * margin_);
}

bool RegionPlan::fits_into(const PeriodicEdges& box, int dimension) const {
  return !levels_.empty() && spare_room(box, dimension) > 4 * margin_;
}

}  // namespace tps

#include "verify/trace_check/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace tps::check {
namespace {

/// So few particles are all near each other.
constexpr std::size_t kFew = 48;
/// So many may reach farther than a cell.
constexpr std::size_t kFarReaching = 8;
/// Cells are counted in 31 bits; beyond that particles share the outermost one.
constexpr double kLastCell = 1e9;

/// The largest blocking distance between particles of the species marked.
double largest_distance(const Scene& scene, const std::vector<bool>& species) {
  double result = 0;
  for (const PairLaw& law : scene.pairs) {
    const bool both =
        species[static_cast<std::size_t>(law.species_a)] && species[static_cast<std::size_t>(law.species_b)];
    if (both && law.blocking) result = std::max(result, law.blocking->distance);
  }
  return result;
}

/// The side of a cube of space for each particle, by the box around their starts.
double spacing(const Scene& scene, const std::vector<bool>& in_grid) {
  double volume = 1;
  std::size_t count = 0;
  for (int k = 0; k < scene.dimension; ++k) {
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    count = 0;
    for (std::size_t n = 0; n < scene.particles.size(); ++n) {
      if (!in_grid[n]) continue;
      const double x = scene.particles[n].position[static_cast<std::size_t>(k)];
      low = std::min(low, x);
      high = std::max(high, x);
      ++count;
    }
    volume *= std::max(high - low, 0.0);
  }
  return count == 0 ? 0 : std::pow(volume / static_cast<double>(count), 1.0 / scene.dimension);
}

}  // namespace

std::size_t Neighbours::HashOfCell::operator()(const Cell& cell) const {
  std::uint64_t hash = 0;
  for (const std::int32_t x : cell) hash = (hash ^ static_cast<std::uint32_t>(x)) * 0x9e3779b97f4a7c15U;
  return hash ^ (hash >> 32U);
}

Neighbours::Neighbours(const Scene& scene)
    : dimension_(scene.dimension),
      in_grid_(scene.particles.size(), false),
      everyone_(scene.particles.size()),
      anchors_(scene.particles.size()) {
  std::iota(everyone_.begin(), everyone_.end(), 0);
  if (scene.particles.size() > kFew) choose_cells(scene);
}

/// Leaves out of the grid the few particles that reach far, and makes cells as large as the others need.
void Neighbours::choose_cells(const Scene& scene) {
  std::vector<std::size_t> population(scene.species.size(), 0);
  for (const Particle& p : scene.particles) ++population[static_cast<std::size_t>(p.species)];
  std::vector<bool> species(scene.species.size(), true);
  std::size_t left_out = 0;
  while (true) {
    const double reach = largest_distance(scene, species);
    std::size_t rarest = species.size();
    for (const PairLaw& law : scene.pairs) {
      if (!law.blocking || law.blocking->distance < reach) continue;
      for (const int s : {law.species_a, law.species_b}) {
        const auto candidate = static_cast<std::size_t>(s);
        if (!species[candidate]) continue;
        if (rarest == species.size() || population[candidate] < population[rarest]) rarest = candidate;
      }
    }
    if (reach == 0 || rarest == species.size() || left_out + population[rarest] > kFarReaching) break;
    species[rarest] = false;
    left_out += population[rarest];
  }
  for (std::size_t n = 0; n < scene.particles.size(); ++n) {
    in_grid_[n] = species[static_cast<std::size_t>(scene.particles[n].species)];
    if (!in_grid_[n]) outside_grid_.push_back(static_cast<int>(n));
  }
  const double reach = largest_distance(scene, species);
  if (reach == 0) return;
  cell_ = std::max(1.5 * reach, spacing(scene, in_grid_));
  // The grid computes in double what the check knows better: a part in 10^6 pays for that.
  slack_ = (cell_ * (1 - 1e-6) - reach) / 2;
  if (slack_ > 0 && std::isfinite(cell_)) return;
  cell_ = 0;
  in_grid_.assign(in_grid_.size(), false);
}

void Neighbours::remove(int i) {
  Anchor& anchor = anchors_[static_cast<std::size_t>(i)];
  if (!anchor.placed) return;
  const auto cell = cells_.find(anchor.cell);
  std::vector<int>& inside = cell->second;
  *std::find(inside.begin(), inside.end(), i) = inside.back();
  inside.pop_back();
  if (inside.empty()) cells_.erase(cell);
  anchor.placed = false;
}

void Neighbours::place(int i, const Coordinates& position, const Coordinates& velocity, double now) {
  if (cell_ == 0 || !in_grid_[static_cast<std::size_t>(i)]) return;
  remove(i);
  Anchor& anchor = anchors_[static_cast<std::size_t>(i)];
  for (std::size_t k = 0; k < 3; ++k) {
    const double place = std::floor(position[k] / cell_);
    anchor.cell[k] =
        static_cast<std::int32_t>(std::clamp(std::isnan(place) ? 0 : place, -kLastCell, kLastCell));
  }
  anchor.placed = true;
  ++anchor.number;
  cells_[anchor.cell].push_back(i);
  const double speed = std::hypot(velocity[0], velocity[1], velocity[2]);
  anchor.expires = speed > 0 ? std::nextafter(now + slack_ / speed, -HUGE_VAL) : HUGE_VAL;
  if (std::isinf(anchor.expires)) return;
  expiries_.push({anchor.expires, i, anchor.number});
  if (expiries_.size() > 4 * anchors_.size()) forget_old_expiries();
}

/// A slow particle that is often hit leaves expiries of the far future behind.
void Neighbours::forget_old_expiries() {
  std::vector<Due> live;
  for (std::size_t n = 0; n < anchors_.size(); ++n) {
    const Anchor& anchor = anchors_[n];
    if (anchor.placed && !std::isinf(anchor.expires))
      live.push_back({anchor.expires, static_cast<int>(n), anchor.number});
  }
  expiries_ = decltype(expiries_)(std::greater<>(), std::move(live));
}

std::optional<Neighbours::Expiry> Neighbours::expiry_until(double t) {
  while (!expiries_.empty() && expiries_.top().t <= t) {
    const Due due = expiries_.top();
    expiries_.pop();
    if (due.number == anchors_[static_cast<std::size_t>(due.particle)].number)
      return Expiry{due.t, due.particle};
  }
  return std::nullopt;
}

const std::vector<int>& Neighbours::near(int i) {
  const Anchor& anchor = anchors_[static_cast<std::size_t>(i)];
  if (!in_grid_[static_cast<std::size_t>(i)]) return everyone_;
  if (!anchor.placed) return outside_grid_;
  found_ = outside_grid_;
  const std::int32_t deep = dimension_ == 3 ? 1 : 0;
  for (std::int32_t x = -1; x <= 1; ++x) {
    for (std::int32_t y = -1; y <= 1; ++y) {
      for (std::int32_t z = -deep; z <= deep; ++z) {
        const auto cell = cells_.find({anchor.cell[0] + x, anchor.cell[1] + y, anchor.cell[2] + z});
        if (cell == cells_.end()) continue;
        found_.insert(found_.end(), cell->second.begin(), cell->second.end());
      }
    }
  }
  return found_;
}

}  // namespace tps::check

#include "verify/trace_check/neighbours.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

namespace tps::check {
namespace {

/// So few particles are all near each other.
constexpr std::size_t kFew = 48;
/// So many may reach farther than a cell.
constexpr std::size_t kFarReaching = 8;
/// Between these every quotient and sum of the grid has its full precision.
constexpr double kSmallestCell = 0x1p-900;
constexpr double kLargestCell = 0x1p900;

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

/// The side of a cube of space for each particle, by the box around their starts. Roots are taken one by one:
/// a product of extents may leave the range.
double spacing(const Scene& scene, const std::vector<int>& particles) {
  double side = 1 / std::pow(static_cast<double>(particles.size()), 1.0 / scene.dimension);
  for (std::size_t k = 0; k < static_cast<std::size_t>(scene.dimension); ++k) {
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (const int n : particles) {
      const double x = scene.particles[static_cast<std::size_t>(n)].position[k];
      low = std::min(low, x);
      high = std::max(high, x);
    }
    side *= std::pow(high / 2 - low / 2, 1.0 / scene.dimension);
  }
  return 2 * side;
}

}  // namespace

void Neighbours::Bucket::put(std::size_t place, const Member& member) {
  for (std::size_t k = 0; k < 3; ++k) anchors[k][place] = member.anchor[k];
  particles[place] = member.particle;
}

void Neighbours::Bucket::add(const Member& member) {
  for (std::size_t n = 0; n < kHere; ++n) {
    if (particles[n] < 0) return put(n, member);
  }
  if (more == nullptr) more = std::make_unique<std::vector<Member>>();
  more->push_back(member);
}

Neighbours::Member Neighbours::Bucket::take_last() {
  Member last;
  if (more != nullptr && !more->empty()) {
    last = more->back();
    more->pop_back();
    return last;
  }
  const std::size_t place = particles[1] < 0 ? 0 : 1;
  for (std::size_t k = 0; k < 3; ++k) last.anchor[k] = anchors[k][place];
  last.particle = particles[place];
  put(place, {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, -1});
  return last;
}

void Neighbours::Bucket::remove(int particle) {
  const Member last = take_last();
  if (last.particle == particle) return;
  for (std::size_t n = 0; n < kHere; ++n) {
    if (particles[n] == particle) return put(n, last);
  }
  *std::find_if(more->begin(), more->end(),
                [particle](const Member& member) { return member.particle == particle; }) = last;
}

Neighbours::Neighbours(const Scene& scene, double u)
    : dimension_(scene.dimension),
      reaches_far_(scene.particles.size(), false),
      everyone_(scene.particles.size()),
      u_(u),
      margin_(std::max(0x1p-20, 0x1p18 * u)),
      anchors_(scene.particles.size()) {
  std::iota(everyone_.begin(), everyone_.end(), 0);
  divide(scene);
  if (scene.particles.size() > kFew) choose_cells(scene);
}

/// Tells apart the few particles that reach far.
void Neighbours::divide(const Scene& scene) {
  std::vector<std::size_t> population(scene.species.size(), 0);
  for (const Particle& p : scene.particles) ++population[static_cast<std::size_t>(p.species)];
  std::vector<bool> species(scene.species.size(), true);
  std::size_t left_out = 0;
  while (true) {
    reach_ = largest_distance(scene, species);
    std::size_t rarest = species.size();
    for (const PairLaw& law : scene.pairs) {
      if (!law.blocking || law.blocking->distance < reach_) continue;
      for (const int s : {law.species_a, law.species_b}) {
        const auto candidate = static_cast<std::size_t>(s);
        if (!species[candidate]) continue;
        if (rarest == species.size() || population[candidate] < population[rarest]) rarest = candidate;
      }
    }
    if (reach_ == 0 || rarest == species.size() || left_out + population[rarest] > kFarReaching) break;
    species[rarest] = false;
    left_out += population[rarest];
  }
  for (std::size_t n = 0; n < scene.particles.size(); ++n) {
    reaches_far_[n] = !species[static_cast<std::size_t>(scene.particles[n].species)];
    (reaches_far_[n] ? far_reaching_ : short_reaching_).push_back(static_cast<int>(n));
  }
}

/// Makes cells as large as those who are in them need. Where doubles have no such cells there are none.
void Neighbours::choose_cells(const Scene& scene) {
  in_cells_ = true;
  if (reach_ == 0) return;  // nobody has to be looked for
  cell_ = std::max(1.5 * reach_, spacing(scene, short_reaching_));
  slack_ = (cell_ * (1 - margin_) - reach_) / 2;
  in_cells_ = slack_ > 0 && cell_ > kSmallestCell && cell_ < kLargestCell;
  per_cell_ = 1 / cell_;
  sides_.fill(cell_);
  if (in_cells_ && scene.box) fit_cells_to_box(scene);
  if (in_cells_) lay_out_buckets();
}

/// About two buckets a particle, a power of two along each axis, four at least.
void Neighbours::lay_out_buckets() {
  const double side = std::pow(2 * static_cast<double>(anchors_.size()), 1.0 / dimension_);
  const auto wanted = std::max<std::size_t>(4, std::bit_ceil(static_cast<std::size_t>(side)));
  std::size_t buckets = 1;
  for (std::size_t k = static_cast<std::size_t>(dimension_); k-- > 0;) {
    const auto around = std::bit_ceil(static_cast<std::size_t>(around_[k]));
    const std::size_t count = around > 1 && around < 4 * wanted ? std::max<std::size_t>(4, around) : wanted;
    stride_[k] = buckets;
    mask_[k] = static_cast<std::uint32_t>(count - 1);
    buckets *= count;
  }
  buckets_.resize(buckets);
}

/// As many cells along a periodic axis as fit. With fewer than three somebody would be on both sides.
void Neighbours::fit_cells_to_box(const Scene& scene) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_); ++k) {
    const double edge = scene.box->edges[k];
    if (std::isinf(edge)) continue;
    const double count = std::min(std::floor(edge / cell_), 0x1p20);
    in_cells_ = in_cells_ && count >= 3;
    edges_[k] = edge;
    sides_[k] = edge / count;
    around_[k] = static_cast<std::int32_t>(count);
    cells_around_[k] = edge * per_cell_;
  }
}

void Neighbours::remove(int i) {
  Anchor& anchor = anchors_[static_cast<std::size_t>(i)];
  if (anchor.loose) {
    *std::find(loose_.begin(), loose_.end(), i) = loose_.back();
    loose_.pop_back();
  }
  if (anchor.placed) bucket(anchor.cell).remove(i);
  anchor.placed = anchor.loose = false;
}

void Neighbours::place(int i, const Coordinates& position, const Coordinates& velocity, double now) {
  if (!in_cells_ || cell_ == 0 || reaches_far_[static_cast<std::size_t>(i)]) return;
  remove(i);
  Anchor& anchor = anchors_[static_cast<std::size_t>(i)];
  ++anchor.number;
  const double speed = std::hypot(velocity[0], velocity[1], velocity[2]);
  const double leaves = now + slack_ / speed;
  anchor.expires = speed > 0 ? leaves - 8 * u_ * leaves : HUGE_VAL;
  // So far out a position has few enough roundings for the margin: six of the coordinates that led to it.
  const double last_cell = margin_ / (32 * u_);
  bool is_somewhere = anchor.expires > now;
  for (std::size_t k = 0; k < 3; ++k) {
    const bool is_periodic = around_[k] > 0;
    is_somewhere = is_somewhere && std::fabs(position[k] / sides_[k]) < last_cell;
    const double x =
        is_periodic ? position[k] - edges_[k] * std::floor(position[k] / edges_[k]) : position[k];
    anchor.place[k] = x * per_cell_;
    const double place = std::floor(x / sides_[k]);
    anchor.cell[k] = is_somewhere ? static_cast<std::int32_t>(place) : 0;
    // Rounding may put a place on the edge itself, or just below 0.
    if (is_periodic) anchor.cell[k] = std::clamp(anchor.cell[k], 0, around_[k] - 1);
  }
  if (!is_somewhere) {
    anchor.loose = true;
    loose_.push_back(i);
    return;
  }
  anchor.placed = true;
  bucket(anchor.cell).add({anchor.place, i});
  if (std::isinf(anchor.expires)) return;
  expiries_.push({anchor.expires, i, anchor.number});
  if (expiries_.size() > 4 * anchors_.size()) forget_old_expiries();
}

/// A slow particle that is often hit leaves expiries of the far future behind.
void Neighbours::forget_old_expiries() {
  std::vector<Expiries::Expiry> live;
  for (std::size_t n = 0; n < anchors_.size(); ++n) {
    const Anchor& anchor = anchors_[n];
    if (anchor.placed && !std::isinf(anchor.expires))
      live.push_back({anchor.expires, static_cast<int>(n), anchor.number});
  }
  expiries_.assign(std::move(live));
}

std::optional<Neighbours::Expiry> Neighbours::expiry_until(double t) {
  while (const Expiries::Expiry* const next = expiries_.next(t)) {
    const Expiries::Expiry due = *next;
    expiries_.pop();
    if (due.number == anchors_[static_cast<std::size_t>(due.particle)].number)
      return Expiry{due.t, due.particle};
  }
  return std::nullopt;
}

}  // namespace tps::check

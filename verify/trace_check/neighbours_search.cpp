// Who is near: the buckets around an anchor, looked at or asked of memory.
#include <algorithm>
#include <cmath>

#include "verify/trace_check/neighbours.hpp"

namespace tps::check {

/// Near is who has an anchor within a cell's side, of the nearest image. Members of other cells that share
/// the bucket have none, nor most of those in the corners. REQUIRES room for so many more in found_.
template <bool kIsPeriodic>
inline std::size_t Neighbours::find_in(const Bucket& bucket, const Coordinates& place, std::size_t count) {
  int* const found = found_.data();
  const auto take = [&](int particle, bool is_near) {
    found[count] = particle;
    count += is_near ? 1 : 0;
  };
  const auto apart = [&](std::size_t k, double r) {
    if (!kIsPeriodic || around_[k] == 0) return r;
    const double x = std::fabs(r);
    return x > cells_around_[k] / 2 ? cells_around_[k] - x : x;
  };
  const auto look_at = [&](const Coordinates& anchor, int particle) {
    const double x = apart(0, anchor[0] - place[0]), y = apart(1, anchor[1] - place[1]),
                 z = apart(2, anchor[2] - place[2]);
    take(particle, x * x + y * y + z * z <= 1);
  };
  if constexpr (kIsPeriodic) {
    for (std::size_t n = 0; n < Bucket::kHere; ++n)
      look_at({bucket.anchors[0][n], bucket.anchors[1][n], bucket.anchors[2][n]}, bucket.particles[n]);
  } else {
    const Two x = bucket.anchors[0] - Two{place[0], place[0]},
              y = bucket.anchors[1] - Two{place[1], place[1]},
              z = bucket.anchors[2] - Two{place[2], place[2]};
    const auto is_near = x * x + y * y + z * z <= Two{1, 1};
    take(bucket.particles[0], is_near[0] != 0);
    take(bucket.particles[1], is_near[1] != 0);
  }
  if (bucket.more == nullptr) return count;
  for (const Member& other : *bucket.more) look_at(other.anchor, other.particle);
  return count;
}

template <bool kIsPeriodic>
Neighbours::Parts Neighbours::parts_around(const Anchor& anchor) const {
  Parts parts;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::int32_t step = -1; step <= 1; ++step) {
      std::int32_t x = anchor.cell[k] + step;
      if (kIsPeriodic && around_[k] > 0) x = x < 0 ? x + around_[k] : x >= around_[k] ? x - around_[k] : x;
      parts[k][static_cast<std::size_t>(step + 1)] = along(k, x);
    }
  }
  return parts;
}

template <typename Visit>
inline void Neighbours::each_around(const Parts& parts, Visit visit) const {
  const std::size_t first = dimension_ == 3 ? 0 : 1;
  for (const std::size_t x : parts[0]) {
    for (const std::size_t y : parts[1]) {
      for (std::size_t z = first; z < 3 - first; ++z) visit(buckets_[x + y + parts[2][z]]);
    }
  }
}

template <bool kIsPeriodic>
std::size_t Neighbours::find_around(const Anchor& anchor, std::size_t count) {
  constexpr std::size_t kOfBuckets = kCellsAround * Bucket::kHere;
  const auto make_room = [&](std::size_t more) {
    const std::size_t most = count + more + kOfBuckets;
    if (found_.size() < most) found_.resize(2 * most);
  };
  make_room(0);
  each_around(parts_around<kIsPeriodic>(anchor), [&](const Bucket& bucket) {
    if (bucket.more != nullptr) make_room(bucket.more->size());
    count = find_in<kIsPeriodic>(bucket, anchor.place, count);
  });
  return count;
}

void Neighbours::fetch(int i) const {
  constexpr std::size_t kMany = 16384;  // buckets: a cache of a megabyte
  const Anchor& anchor = anchors_[static_cast<std::size_t>(i)];
  if (buckets_.size() <= kMany || !anchor.placed) return;
  const Parts parts = is_periodic() ? parts_around<true>(anchor) : parts_around<false>(anchor);
  each_around(parts, [](const Bucket& bucket) { __builtin_prefetch(&bucket); });
}

void Neighbours::fetch_next(double t) const {
  const Expiries::Expiry* const next = expiries_.probably_next(t);
  if (next != nullptr) fetch(next->particle);
}

std::span<const int> Neighbours::near(int i) {
  const Anchor& anchor = anchors_[static_cast<std::size_t>(i)];
  if (is_near_everybody(i)) return everyone_;
  if (!anchor.placed) return far_reaching_;
  std::size_t count = far_reaching_.size() + loose_.size();
  if (found_.size() < count) found_.resize(count);
  std::copy(loose_.begin(), loose_.end(),
            std::copy(far_reaching_.begin(), far_reaching_.end(), found_.begin()));
  count = is_periodic() ? find_around<true>(anchor, count) : find_around<false>(anchor, count);
  return {found_.data(), count};
}

}  // namespace tps::check

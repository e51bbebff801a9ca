// Which particles have their regions where: buckets of a grid that is wrapped around like a torus, so that
// space is unbounded and neighbouring buckets lie together in memory.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "reference/engine/large_pages.hpp"
#include "reference/equations/vector.hpp"

namespace tps {

/// A cube of a lattice, by its lowest corner in units of its side.
template <int D>
using Region = std::array<std::int32_t, static_cast<std::size_t>(D)>;

/// Regions from low to high, both included; low ≤ high.
template <int D>
struct RegionRange {
  Region<D> low, high;

  /// Without branches: half of those that are looked at are in, in no order that a processor could guess.
  bool contains(const Region<D>& region) const {
    bool is_in = true;
    for_each_axis<D>([&](int axis) {
      const auto k = static_cast<std::size_t>(axis);
      const auto bottom = static_cast<std::uint32_t>(low[k]);
      is_in = is_in & (static_cast<std::uint32_t>(region[k]) - bottom <=
                       static_cast<std::uint32_t>(high[k]) - bottom);
    });
    return is_in;
  }
};

/// Where every particle is filed: its region, and its neighbours in the list of its bucket.
template <int D>
struct alignas(32) FiledRegion {
  Region<D> region;
  int next, previous;  ///< of the bucket's list; −1 at its ends
};

template <int D>
using FiledRegions = LargeVector<FiledRegion<D>>;

/// One level's buckets. Particles of regions that are far apart may share one: that costs a look, no more.
template <int D>
class RegionGrid {
 public:
  /// Puts the particles into buckets, as many as there are particles or fewer, shaped as they lie.
  void build(const std::vector<int>& members, int shift, FiledRegions<D>& filed) {
    shift_ = std::max(0, shift);
    members_ = members.size();
    Region<D> low{};
    Region<D> high{};
    for (std::size_t n = 0; n < members.size(); ++n) {
      const Region<D>& region = filed[at(members[n])].region;
      for (std::size_t k = 0; k < region.size(); ++k) {
        low[k] = n == 0 ? region[k] : std::min(low[k], region[k]);
        high[k] = n == 0 ? region[k] : std::max(high[k], region[k]);
      }
    }
    std::array<int, kAxes> bits{};
    int total = 0;
    for (std::size_t k = 0; k < kAxes; ++k) {
      const std::int64_t width = (std::int64_t{high[k]} >> shift_) - (low[k] >> shift_) + 1;
      while ((std::int64_t{1} << bits[k]) < width) ++bits[k];
      total += bits[k];
    }
    const auto is_too_fine = [&] {
      return total >= 64 || (std::uint64_t{1} << total) > kBucketsPerParticle * members.size();
    };
    while (total > 6 && is_too_fine()) {
      --*std::max_element(bits.begin(), bits.end());
      --total;
    }
    int stride = 0;
    for (std::size_t k = 0; k < kAxes; ++k) {
      mask_[k] = (std::uint32_t{1} << bits[k]) - 1;
      stride_[k] = stride;
      stride += bits[k];
    }
    first_.assign(std::size_t{1} << total, -1);
    for (const int i : members) file(i, filed);
  }

  void file(int i, FiledRegions<D>& filed) {
    FiledRegion<D>& own = filed[at(i)];
    int& first = first_[bucket_of(own.region)];
    own.next = first;
    own.previous = -1;
    if (first >= 0) filed[at(first)].previous = i;
    first = i;
  }

  void remove(int i, FiledRegions<D>& filed) {
    const FiledRegion<D>& own = filed[at(i)];
    if (own.next >= 0) filed[at(own.next)].previous = own.previous;
    if (own.previous >= 0) filed[at(own.previous)].next = own.next;
    if (own.previous < 0) first_[bucket_of(own.region)] = own.next;
  }

  /// Asks memory for the first bucket of each row around a region: mostly, the others are in its cache line.
  void prefetch_around(const Region<D>& region, int reach) const {
    RegionRange<D> range{region, region};
    for (std::size_t k = 0; k < kAxes; ++k) {
      range.low[k] -= reach;
      range.high[k] += reach;
    }
    const std::uint32_t from = static_cast<std::uint32_t>(range.low[0] >> shift_) & mask_[0];
    for_each_row(range, [&](std::size_t row) { __builtin_prefetch(&first_[row | from]); });
  }

  /// Whether a search would look into more buckets than there are particles.
  bool is_wider_than_its_members(const RegionRange<D>& range) const {
    std::uint64_t buckets = 1;
    for (std::size_t k = 0; k < kAxes; ++k) buckets *= width(range, k);
    return buckets > members_;
  }

  /// Appends every particle of the range whose region `keep` wants. `heads` is room to work in.
  ///
  /// The lists of all buckets are walked in step, without a branch a particle: so much is in memory's way at
  /// once, and a processor has nothing to guess.
  template <typename Keep>
  void search(RegionRange<D> range, const FiledRegions<D>& filed, Keep keep, std::vector<int>& heads,
              std::vector<int>& found) const {
    std::size_t waiting = put_heads(range, heads);
    for (std::size_t n = 0; n < waiting; ++n) __builtin_prefetch(&filed[at(heads[n])]);
    std::size_t end = found.size();
    while (waiting > 0) {
      found.resize(end + waiting);
      std::size_t left = 0;
      for (std::size_t n = 0; n < waiting; ++n) {
        const int j = heads[n];
        const FiledRegion<D>& at_j = filed[at(j)];
        found[end] = j;
        const bool is_in = range.contains(at_j.region), is_wanted = keep(j, at_j.region);
        end += (is_in & is_wanted) ? 1U : 0U;
        heads[left] = at_j.next;
        left += at_j.next >= 0 ? 1U : 0U;
      }
      waiting = left;
    }
    found.resize(end);
  }

 private:
  static constexpr std::size_t kAxes = static_cast<std::size_t>(D);
  static constexpr std::uint64_t kBucketsPerParticle = 4;

  static std::size_t at(int n) { return static_cast<std::size_t>(n); }

  /// What the lists of the buckets start with that a range touches. @return how many.
  std::size_t put_heads(const RegionRange<D>& range, std::vector<int>& heads) const {
    std::size_t buckets = 1;
    for (std::size_t k = 0; k < kAxes; ++k) buckets *= width(range, k);
    if (heads.size() < buckets) heads.resize(buckets);
    const auto from = static_cast<std::uint32_t>(range.low[0] >> shift_);
    const auto count = static_cast<std::uint32_t>(width(range, 0));
    std::size_t put = 0;
    for_each_row(range, [&](std::size_t row) {
      for (std::uint32_t x = 0; x < count; ++x) {
        const int first = first_[row | ((from + x) & mask_[0])];
        heads[put] = first;
        put += first >= 0 ? 1U : 0U;
      }
    });
    return put;
  }

  /// Calls use(row) for where each row of buckets along the first axis begins that a range touches.
  template <typename Use>
  void for_each_row(const RegionRange<D>& range, Use use) const {
    constexpr std::size_t last = kAxes - 1;
    const auto from = [&](std::size_t k) { return static_cast<std::uint32_t>(range.low[k] >> shift_); };
    const auto layers = D == 3 ? static_cast<std::uint32_t>(width(range, last)) : 1U;
    const auto rows = static_cast<std::uint32_t>(width(range, 1));
    for (std::uint32_t z = 0; z < layers; ++z) {
      const std::size_t layer = D == 3 ? std::size_t{(from(last) + z) & mask_[last]} << stride_[last] : 0;
      for (std::uint32_t y = 0; y < rows; ++y) {
        use(layer | (std::size_t{(from(1) + y) & mask_[1]} << stride_[1]));
      }
    }
  }

  /// Buckets of an axis, each once however far the range goes round.
  std::uint64_t width(const RegionRange<D>& range, std::size_t k) const {
    const std::int64_t buckets = (std::int64_t{range.high[k]} >> shift_) - (range.low[k] >> shift_) + 1;
    return std::min<std::uint64_t>(static_cast<std::uint64_t>(buckets), std::uint64_t{mask_[k]} + 1);
  }

  std::size_t bucket_of(const Region<D>& region) const {
    std::size_t bucket = 0;
    for (std::size_t k = 0; k < kAxes; ++k) {
      bucket |= std::size_t{static_cast<std::uint32_t>(region[k] >> shift_) & mask_[k]} << stride_[k];
    }
    return bucket;
  }

  int shift_ = 0;
  std::size_t members_ = 0;
  std::array<std::uint32_t, kAxes> mask_{};
  std::array<int, kAxes> stride_{};
  LargeVector<int> first_;  ///< of each bucket's list; −1: empty
};

}  // namespace tps

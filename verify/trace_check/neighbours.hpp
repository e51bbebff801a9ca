// Who can have met whom: a grid of anchors, so that the cost of an event does not grow with the number of
// particles (docs/check.md, "Neighbours").
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "reference/engine/large_pages.hpp"
#include "reference/scene/scene.hpp"
#include "verify/trace_check/expiries.hpp"

namespace tps::check {

/// A particle is within `slack` of its anchor until the anchor expires, and 4 u of that time longer. Law:
/// particles whose anchors are not within a cell's side of each other have not come within a blocking
/// distance since the later of the two was set, whatever their positions, velocities and times. In a periodic
/// box no image has: a whole number of cells, three at least, goes round each periodic axis.
class Neighbours {
 public:
  /// Positions and times are those of a run with the unit roundoff u.
  explicit Neighbours(const Scene& scene, double u = 0x1p-53);

  static constexpr std::size_t kCellsAround = 27;

  /// Sets the anchor of a particle to where it is now. One that would leave its anchor within the rounding of
  /// the time, or that is nowhere, gets none: it is near everybody.
  void place(int i, const Coordinates& position, const Coordinates& velocity, double now);

  struct Expiry {
    double t;
    int particle;
  };
  /// The anchor that expires first, if any does at or before t.
  std::optional<Expiry> expiry_until(double t);

  /// Asks memory, of many particles, for what near(i) looks at, so that it has come by then; and of the
  /// particle whose anchor expires next, if that is by t.
  void fetch(int i) const;
  void fetch_next(double t) const;

  /// Every other particle that may be near particle i: those whose anchors are within a cell's side of its
  /// own, and those that are never in a cell.
  std::span<const int> near(int i);

  /// Whether everybody is near particle i.
  bool is_near_everybody(int i) const {
    const auto n = static_cast<std::size_t>(i);
    return !in_cells_ || anchors_[n].loose || reaches_far_[n];
  }

  /// Particles of the few that reach far (walls, membranes), and all others, of which none reaches another
  /// from farther than reach().
  const std::vector<int>& far_reaching() const { return far_reaching_; }
  const std::vector<int>& short_reaching() const { return short_reaching_; }
  double reach() const { return reach_; }

 private:
  using Cell = std::array<std::int32_t, 3>;
  /// Of a bucket.
  struct Member {
    Coordinates anchor;  ///< as Anchor::place
    int particle;
  };
  /// Two numbers that the processor takes at once.
  using Two = double __attribute__((vector_size(16)));
  /// Members in their order. The first two stand in the bucket itself, and nowhere where there are none: they
  /// are looked at without asking how many there are, which no processor foresees. A line of a cache.
  struct alignas(64) Bucket {
    static constexpr std::size_t kHere = 2;
    static constexpr Two kNowhere = {HUGE_VAL, HUGE_VAL};

    std::array<Two, 3> anchors = {kNowhere, kNowhere, kNowhere};  ///< of the first two, by coordinate
    std::array<int, kHere> particles = {-1, -1};
    std::unique_ptr<std::vector<Member>> more;  ///< null: there have never been any

    void add(const Member& member);
    /// Whose place the last one takes.
    void remove(int particle);

   private:
    void put(std::size_t place, const Member& member);
    Member take_last();
  };
  struct Anchor {
    Cell cell{};
    Coordinates place{};       ///< taken back into a periodic box, in units of cell_
    bool placed = false;       ///< in a cell
    bool loose = false;        ///< has no anchor at present
    std::uint32_t number = 0;  ///< of anchors that the particle has had
    double expires = 0;        ///< infinity: never
  };
  Bucket& bucket(const Cell& cell) {
    return buckets_[along(0, cell[0]) + along(1, cell[1]) + along(2, cell[2])];
  }

  void divide(const Scene& scene);
  void choose_cells(const Scene& scene);
  void fit_cells_to_box(const Scene& scene);
  void lay_out_buckets();
  /// The part that a coordinate of a cell has in the number of its bucket.
  std::size_t along(std::size_t axis, std::int32_t x) const {
    return (static_cast<std::uint32_t>(x) & mask_[axis]) * stride_[axis];
  }
  /// Takes up whoever of a bucket is near a place behind `count` others, and counts them.
  template <bool kIsPeriodic>
  std::size_t find_in(const Bucket& bucket, const Coordinates& place, std::size_t count);
  using Parts = std::array<std::array<std::size_t, 3>, 3>;
  /// Of the numbers of the buckets around an anchor, by axis.
  template <bool kIsPeriodic>
  Parts parts_around(const Anchor& anchor) const;
  template <typename Visit>
  void each_around(const Parts& parts, Visit visit) const;
  template <bool kIsPeriodic>
  std::size_t find_around(const Anchor& anchor, std::size_t count);
  bool is_periodic() const { return around_[0] > 0 || around_[1] > 0 || around_[2] > 0; }
  void remove(int i);
  void forget_old_expiries();

  int dimension_;
  std::vector<bool> reaches_far_;
  std::vector<int> far_reaching_, short_reaching_, everyone_;
  double reach_ = 0;
  double u_;
  double margin_;                            ///< part of a cell that pays for rounding
  bool in_cells_ = false;                    ///< else everybody is near everybody
  double cell_ = 0, per_cell_ = 0;           ///< least side of a cell, and 1 over it
  std::array<double, 3> sides_{}, edges_{};  ///< of a cell; of the periodic box
  std::array<double, 3> cells_around_{};     ///< edges_ in units of cell_
  std::array<std::int32_t, 3> around_{};     ///< cells along a periodic axis; 0: the axis is open
  double slack_ = 0;                         ///< how far a particle may be from its anchor
  LargeVector<Anchor> anchors_;
  std::vector<int> loose_;
  /// Cells wrapped around like a torus: distant ones may share a bucket, neighbouring ones do only across the
  /// edge of a periodic box with more cells along it than buckets.
  LargeVector<Bucket> buckets_;
  std::array<std::uint32_t, 3> mask_{};
  std::array<std::size_t, 3> stride_{};
  Expiries expiries_;
  std::vector<int> found_;  ///< by near(), and room for more
};

}  // namespace tps::check

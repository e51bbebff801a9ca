// Who can have met whom: a grid of anchors, so that the cost of an event does not grow with the number of
// particles (docs/check.md, "Neighbours").
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <queue>
#include <unordered_map>
#include <vector>

#include "reference/scene/scene.hpp"

namespace tps::check {

/// A particle is within `slack` of its anchor until the anchor expires, and 4 u of that time longer. Law:
/// particles whose anchors are not near each other have not come within a blocking distance since the later
/// of the two was set, whatever their positions, velocities and times. In a periodic box no image has: a
/// whole number of cells, three at least, goes round each periodic axis.
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

  /// Every other particle that may be near particle i: those of the cells around, and those that are never in
  /// a cell.
  const std::vector<int>& near(int i);

  /// Particles of the few that reach far (walls, membranes), and all others, of which none reaches another
  /// from farther than reach().
  const std::vector<int>& far_reaching() const { return far_reaching_; }
  const std::vector<int>& short_reaching() const { return short_reaching_; }
  double reach() const { return reach_; }

 private:
  using Cell = std::array<std::int32_t, 3>;
  struct HashOfCell {
    std::size_t operator()(const Cell& cell) const;
  };
  struct Anchor {
    Cell cell{};
    bool placed = false;       ///< in a cell
    bool loose = false;        ///< has no anchor at present
    std::uint32_t number = 0;  ///< of anchors that the particle has had
    double expires = 0;        ///< infinity: never
  };
  struct Due {
    double t;
    int particle;
    std::uint32_t number;
    bool operator>(const Due& other) const { return t > other.t; }
  };

  void divide(const Scene& scene);
  void choose_cells(const Scene& scene);
  void fit_cells_to_box(const Scene& scene);
  void remove(int i);
  void forget_old_expiries();

  int dimension_;
  std::vector<bool> reaches_far_;
  std::vector<int> far_reaching_, short_reaching_, everyone_;
  double reach_ = 0;
  double u_;
  double margin_;                            ///< part of a cell that pays for rounding
  bool in_cells_ = false;                    ///< else everybody is near everybody
  double cell_ = 0;                          ///< least side of a cell
  std::array<double, 3> sides_{}, edges_{};  ///< of a cell; of the periodic box
  std::array<std::int32_t, 3> around_{};     ///< cells along a periodic axis; 0: the axis is open
  double slack_ = 0;                         ///< how far a particle may be from its anchor
  std::vector<Anchor> anchors_;
  std::vector<int> loose_;
  std::unordered_map<Cell, std::vector<int>, HashOfCell> cells_;
  std::priority_queue<Due, std::vector<Due>, std::greater<>> expiries_;
  std::vector<int> found_;
};

}  // namespace tps::check

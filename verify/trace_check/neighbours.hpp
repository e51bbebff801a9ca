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

/// A particle is within `slack` of its anchor until the anchor expires. Law: particles whose anchors are not
/// near each other have not come within a blocking distance since the later of the two was set.
class Neighbours {
 public:
  explicit Neighbours(const Scene& scene);

  /// Sets the anchor of a particle to where it is now.
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

 private:
  using Cell = std::array<std::int32_t, 3>;
  struct HashOfCell {
    std::size_t operator()(const Cell& cell) const;
  };
  struct Anchor {
    Cell cell{};
    bool placed = false;
    std::uint32_t number = 0;  ///< of anchors that the particle has had
    double expires = 0;        ///< infinity: never
  };
  struct Due {
    double t;
    int particle;
    std::uint32_t number;
    bool operator>(const Due& other) const { return t > other.t; }
  };

  void choose_cells(const Scene& scene);
  void remove(int i);
  void forget_old_expiries();

  int dimension_;
  std::vector<bool> in_grid_;
  std::vector<int> outside_grid_;  ///< particles that reach far: walls, membranes
  std::vector<int> everyone_;
  double cell_ = 0;   ///< side of a cell; 0: nobody in the grid reaches another
  double slack_ = 0;  ///< how far a particle may be from its anchor
  std::vector<Anchor> anchors_;
  std::unordered_map<Cell, std::vector<int>, HashOfCell> cells_;
  std::priority_queue<Due, std::vector<Due>, std::greater<>> expiries_;
  std::vector<int> found_;
};

}  // namespace tps::check

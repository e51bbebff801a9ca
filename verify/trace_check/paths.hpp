// Who can still meet whom, from a moment on: straight paths, looked at in boxes (docs/check.md,
// "Neighbours").
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "reference/scene/scene.hpp"

namespace tps::check {

struct Path {
  int particle;
  Coordinates position, velocity;
  double error;  ///< of each coordinate of the position
};

/// A tree of boxes in positions and velocities. Two boxes whose members can never be near each other are
/// settled at once, so that the cost is that of the pairs that come near, and not of all.
class Paths {
 public:
  /// Whether a pair is all right. Members of pairs that are not are done: of two such no more is asked.
  using Judge = std::function<bool(int, int)>;

  /// Nobody meets another from farther than `reach`.
  Paths(std::vector<Path> paths, double reach);

  /// Asks about every pair that comes within reach between now and `duration` later, in each coordinate at
  /// one time, and about some that do not. Law: velocities may be off by 2^-40 of themselves.
  void each_near_pair(double duration, const Judge& judge);

 private:
  static constexpr std::size_t kLeaf = 8;
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  struct Box {
    std::size_t begin, end;  ///< of the paths
    std::size_t above;
    std::size_t open;                 ///< members that are not done
    std::array<double, 6> low, high;  ///< of three coordinates and three velocities
    std::size_t left = kNone, right = kNone;
  };

  std::size_t make_box(std::size_t begin, std::size_t end, std::size_t above);
  std::size_t widest(const Box& box) const;
  bool can_be_near(const Box& a, const Box& b) const;
  void visit(std::size_t a, std::size_t b, const Judge& judge);
  void visit_members(std::size_t a, std::size_t b, const Judge& judge);
  void finish(std::size_t path);

  std::vector<Path> paths_;
  double reach_;
  double duration_ = 0;
  std::vector<Box> boxes_;
  std::vector<std::size_t> leaf_of_;  ///< by path
  std::vector<bool> done_;
};

}  // namespace tps::check

// Points in boxes inside boxes: questions about all of them at the cost of few.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "reference/scene/scene.hpp"

namespace tps {

/// A k-d tree over some of the particles of a scene (Bentley 1975): each box is halved at the median along
/// its longest side, down to a handful of points.
class PointTree {
 public:
  struct Box {
    Coordinates low{}, high{};
  };

  /// `particles` are indices into scene.particles; the scene must outlive the tree.
  PointTree(const Scene& scene, std::vector<std::size_t> particles);

  /// Calls use(particle) for every particle whose boxes all pass worth(box).
  template <typename Worth, typename Use>
  void visit(Worth worth, Use use) const {
    std::vector<std::size_t> open;
    if (!nodes_.empty()) open.push_back(0);
    while (!open.empty()) {
      const Node& node = nodes_[open.back()];
      open.pop_back();
      if (!worth(node.box)) continue;
      if (node.second_child == 0) {
        for (std::size_t k = node.begin; k < node.end; ++k) use(particles_[k]);
      } else {
        open.push_back(node.second_child);
        open.push_back(node.second_child - 1);
      }
    }
  }

 private:
  struct Node {
    Box box;
    std::size_t begin = 0, end = 0;
    std::size_t second_child = 0;  ///< the first one stands before it; 0: a leaf
  };

  Box box_of(std::size_t begin, std::size_t end) const;
  void split(std::size_t node);

  const Scene& scene_;
  std::vector<std::size_t> particles_;
  std::vector<Node> nodes_;
};

/// Bounds on the distance between a point and anything in a box, with their rounding counted: false only
/// where the real distance is at least (at most) the limit. REQUIRES finite coordinates, limit > 0.
bool may_be_nearer(const PointTree::Box& box, const Coordinates& point, double limit);
bool may_be_farther(const PointTree::Box& box, const Coordinates& point, double limit);

}  // namespace tps

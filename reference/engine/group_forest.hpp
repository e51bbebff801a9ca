// Bodies: particles that move as one after nearly simultaneous collisions, and the tree of collisions that
// made them so. The trees only record; effects/grouping.hpp acts on them.
#pragma once

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include "reference/engine/clock.hpp"
#include "reference/engine/tethers.hpp"
#include "reference/equations/vector.hpp"

namespace tps {

/// One load: two bodies became one. Side 0 is the body of particle i, side 1 that of j.
template <typename Scalar, int D>
struct GroupNode {
  /// A side is another node (≥ 0), a single particle (~index, negative), or the infinite mass itself.
  static constexpr int kInfiniteMass = std::numeric_limits<int>::min();

  int i, j;
  Limit limit;
  std::array<int, 2> side;
  std::array<Scalar, 2> mass;  ///< of the two bodies
  Vector<Scalar, D> dp;        ///< Δp_AB on side 0, eq. (7)
};

/// A tree of loads with what holds for all of its particles.
template <typename Scalar, int D>
struct GroupBody {
  int root = -1;
  std::vector<int> members;  ///< ascending; the first one names the body
  Scalar mass;               ///< infinite for a grounded body
  Time<Scalar> expiry;
  Time<Scalar> birth;  ///< of its oldest node
};

/// The live bodies. Slots of ended bodies and nodes are used again; nothing depends on their numbers.
template <typename Scalar, int D>
class GroupForest {
 public:
  using Node = GroupNode<Scalar, D>;
  using Body = GroupBody<Scalar, D>;

  explicit GroupForest(std::size_t particles) : body_of_(particles, kSingle) {}

  bool together(int i, int j) const { return slot(i) != kSingle && slot(i) == slot(j); }
  /// The body of a particle, or null while it is on its own.
  const Body* body(int i) const { return slot(i) == kSingle ? nullptr : &bodies_[at(slot(i))]; }
  const Node& node(int n) const { return nodes_[at(n)]; }

  /// Adds a node over the two bodies and makes them one. `sides` of infinite mass stay outside.
  const Body& join(Node node, const Body& joined) {
    for (const int member : joined.members) release(slot(member));
    const int root = take_slot(free_nodes_, nodes_, std::move(node));
    const int body = take_slot(free_bodies_, bodies_, joined);
    bodies_[at(body)].root = root;
    for (const int member : joined.members) body_of_[at(member)] = body;
    return bodies_[at(body)];
  }

  /// Ends a body; its nodes are handed out by take_node.
  Body dissolve(int member) {
    Body ended = bodies_[at(slot(member))];
    release(slot(member));
    for (const int m : ended.members) body_of_[at(m)] = kSingle;
    return ended;
  }
  Node take_node(int n) {
    free_nodes_.push_back(n);
    return nodes_[at(n)];
  }

  /// The side that stands for a particle's body in a new node.
  int side_of(int i) const { return slot(i) == kSingle ? ~i : bodies_[at(slot(i))].root; }

  /// All particles below a side.
  std::vector<int> members_of(int side) const {
    if (side == Node::kInfiniteMass) return {};
    if (side < 0) return {~side};
    std::vector<int> all;
    std::vector<int> open = {side};
    while (!open.empty()) {
      const Node& n = node(open.back());
      open.pop_back();
      for (const int below : n.side) {
        if (below == Node::kInfiniteMass) continue;
        if (below < 0) all.push_back(~below);
        if (below >= 0) open.push_back(below);
      }
    }
    std::sort(all.begin(), all.end());
    return all;
  }

  /// The live bodies by their smallest members.
  std::vector<const Body*> bodies() const {
    std::vector<const Body*> live;
    for (std::size_t i = 0; i < body_of_.size(); ++i) {
      const Body* candidate = body(static_cast<int>(i));
      if (candidate != nullptr && candidate->members.front() == static_cast<int>(i))
        live.push_back(candidate);
    }
    return live;
  }

 private:
  static constexpr int kSingle = -1;
  static std::size_t at(int n) { return static_cast<std::size_t>(n); }
  int slot(int i) const { return body_of_[at(i)]; }

  void release(int body) {
    if (body == kSingle || bodies_[at(body)].root < 0) return;
    bodies_[at(body)].root = -1;
    free_bodies_.push_back(body);
  }

  template <typename Item>
  static int take_slot(std::vector<int>& free, std::vector<Item>& items, Item item) {
    if (free.empty()) {
      items.push_back(std::move(item));
      return static_cast<int>(items.size()) - 1;
    }
    const int n = free.back();
    free.pop_back();
    items[at(n)] = std::move(item);
    return n;
  }

  std::vector<int> body_of_;
  std::vector<Body> bodies_;
  std::vector<Node> nodes_;
  std::vector<int> free_bodies_, free_nodes_;
};

}  // namespace tps

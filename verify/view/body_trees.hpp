// Who moves with whom: the trees of loads, as events tell them.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "reference/scene/scene.hpp"

namespace tps::view {

/// Follows loads and restitutions by their pairs and members. It judges nothing: a pair that is the root of
/// no body parts from nobody.
class BodyTrees {
 public:
  explicit BodyTrees(const Scene& scene);

  /// The load of the pair i, j, after which `members` move together.
  void load(int i, int j, const std::vector<int>& members);

  /// The restitution of the pair i, j. @return who moves with i from now on, and who with j, both among
  /// them; infinite masses move with nobody.
  std::array<std::vector<int>, 2> part(int i, int j);

  /// Number of the body of a particle, counted by loads; -1: none.
  int number(int particle) const;
  /// Whether a particle is held by an infinite mass.
  bool grounded(int particle) const;
  bool infinite(int particle) const { return infinite_[static_cast<std::size_t>(particle)]; }

 private:
  struct Body {
    int number = 0;
    int i = -1, j = -1;
    bool grounded = false;
    std::vector<int> members;
    std::array<std::shared_ptr<Body>, 2> sides;
  };
  std::shared_ptr<Body>& of(int particle) { return bodies_[static_cast<std::size_t>(particle)]; }
  const Body* of(int particle) const { return bodies_[static_cast<std::size_t>(particle)].get(); }

  std::vector<bool> infinite_;
  std::vector<std::shared_ptr<Body>> bodies_;
  int loads_ = 0;
};

}  // namespace tps::view

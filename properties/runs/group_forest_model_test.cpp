// Random sequences of joins and dissolutions on GroupForest, against nested pairs and sets.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <rapidcheck/state.h>

#include <memory>
#include <set>

#include "reference/engine/group_forest.hpp"

namespace tps::properties::runs {
namespace {

constexpr int kParticles = 6;
constexpr int kWall = kParticles;  ///< its mass is infinite: it joins no tree

using Forest = GroupForest<double, 2>;

/// A load as one would write it down: (i j : what i was, what j was); a single particle is a leaf, the wall
/// is nothing.
struct Nested {
  int i, j;
  std::shared_ptr<const Nested> of_i, of_j;

  std::set<int> particles() const {
    std::set<int> all = side(i, of_i);
    all.merge(side(j, of_j));
    return all;
  }
  static std::set<int> side(int p, const std::shared_ptr<const Nested>& below) {
    if (below) return below->particles();
    return p == kWall ? std::set<int>{} : std::set<int>{p};
  }
};

struct Bodies {
  std::vector<std::shared_ptr<const Nested>> trees;

  std::shared_ptr<const Nested> of(int p) const {
    for (const auto& tree : trees) {
      if (tree->particles().contains(p)) return tree;
    }
    return nullptr;
  }
  bool together(int i, int j) const { return of(i) != nullptr && of(i) == of(j); }
  void remove(const std::shared_ptr<const Nested>& tree) { std::erase(trees, tree); }
};

using Command = rc::state::Command<Bodies, Forest>;

std::vector<int> listed(const std::set<int>& particles) {
  return {particles.begin(), particles.end()};
}

void same(const Bodies& model, const Forest& forest) {
  std::set<std::vector<int>> expected, found;
  for (const auto& tree : model.trees) expected.insert(listed(tree->particles()));
  for (const auto* body : forest.bodies()) found.insert(body->members);
  RC_ASSERT(found == expected);
  for (int i = 0; i < kParticles; ++i) {
    RC_ASSERT((forest.body(i) != nullptr) == (model.of(i) != nullptr));
    for (int j = 0; j < kParticles; ++j) RC_ASSERT(forest.together(i, j) == model.together(i, j));
  }
}

/// Two particles collide, or one and the wall.
struct Join : Command {
  int i = *rc::gen::inRange(0, kParticles), j = *rc::gen::inRange(0, kParticles + 1);

  void checkPreconditions(const Bodies& model) const override { RC_PRE(i != j && !model.together(i, j)); }
  void apply(Bodies& model) const override {
    const auto of_i = model.of(i), of_j = model.of(j);
    model.remove(of_i);
    model.remove(of_j);
    model.trees.push_back(std::make_shared<Nested>(Nested{i, j, of_i, of_j}));
  }
  void run(const Bodies& model, Forest& forest) const override {
    const auto side_of = [&](int p) { return p == kWall ? Forest::Node::kInfiniteMass : forest.side_of(p); };
    const Bodies next = nextState(model);
    Forest::Body joined;
    joined.members = listed(next.of(i)->particles());
    joined.mass = static_cast<double>(joined.members.size());
    const Forest::Node node{i, j, Limit::inner, {side_of(i), side_of(j)}, {1, 1}, {i, j}};
    const Forest::Body& body = forest.join(node, joined);
    RC_ASSERT(body.members == joined.members);
    RC_ASSERT(body.mass == joined.mass);
    same(next, forest);
  }
  void show(std::ostream& out) const override { out << "join " << i << " " << j; }
};

/// A body expires and is unwound, root first.
struct Dissolve : Command {
  int member = *rc::gen::inRange(0, kParticles);

  void checkPreconditions(const Bodies& model) const override { RC_PRE(static_cast<bool>(model.of(member))); }
  void apply(Bodies& model) const override { model.remove(model.of(member)); }
  void run(const Bodies& model, Forest& forest) const override {
    const auto tree = model.of(member);
    const Forest::Body ended = forest.dissolve(member);
    RC_ASSERT(ended.members == listed(tree->particles()));
    unwind(forest, ended.root, *tree);
    same(nextState(model), forest);
  }
  static void unwind(Forest& forest, int n, const Nested& expected) {
    RC_ASSERT(forest.members_of(n) == listed(expected.particles()));
    const std::array<int, 2> sides = forest.node(n).side;
    RC_ASSERT(forest.members_of(sides[0]) == listed(Nested::side(expected.i, expected.of_i)));
    RC_ASSERT(forest.members_of(sides[1]) == listed(Nested::side(expected.j, expected.of_j)));
    const Forest::Node node = forest.take_node(n);
    RC_ASSERT(node.i == expected.i && node.j == expected.j && (node.dp == Vector<double, 2>(node.i, node.j)));
    if (expected.of_i) unwind(forest, sides[0], *expected.of_i);
    if (expected.of_j) unwind(forest, sides[1], *expected.of_j);
  }
  void show(std::ostream& out) const override { out << "dissolve the body of " << member; }
};

RC_GTEST_PROP(GroupForestModel, IsNestedPairs, ()) {
  Forest forest(kParticles);
  rc::state::check(Bodies{}, forest, rc::state::gen::execOneOfWithArgs<Join, Join, Join, Dissolve>());
}

}  // namespace
}  // namespace tps::properties::runs

// A group of a full state, and the group that it was.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/engine/group_forest.hpp"
#include "reference/engine/state_numbers.hpp"
#include "reference/engine/world.hpp"

namespace tps::detail {

template <typename Scalar, int D>
StateData::Group group_data(const World<Scalar, D>& world, const GroupForest<Scalar, D>& forest,
                            const GroupBody<Scalar, D>& body) {
  using Node = GroupNode<Scalar, D>;
  const auto id = [&](int i) { return world.scene.particles[world.index(i)].id; };
  StateData::Group group;
  for (const int m : body.members) group.members.push_back(id(m));
  group.mass = to_hex(body.mass);
  group.expiry = time_data(body.expiry);
  group.birth = time_data(body.birth);
  std::vector<int> order = {body.root};  // breadth first; a node's number in the list is its place here
  for (std::size_t n = 0; n < order.size(); ++n) {
    const Node& node = forest.node(order[n]);
    StateData::Node data{id(node.i), id(node.j), node.limit == Limit::outer, {}, {}, vector_data(node.dp)};
    for (std::size_t s = 0; s < 2; ++s) {
      data.masses[s] = to_hex(node.mass[s]);
      if (node.side[s] == Node::kInfiniteMass) continue;
      if (node.side[s] < 0) {
        data.sides[s].particle = id(~node.side[s]);
      } else {
        data.sides[s].node = static_cast<int>(order.size());
        order.push_back(node.side[s]);
      }
    }
    group.nodes.push_back(data);
  }
  return group;
}

/// Rebuilds a group by joining its nodes again, children before parents.
template <typename Scalar, int D>
void restore_group(GroupForest<Scalar, D>& forest, const StateData::Group& data, const IndexOfId& index_of) {
  using Node = GroupNode<Scalar, D>;
  GroupBody<Scalar, D> body;
  for (const std::int32_t id : data.members) {
    body.members.push_back(index_of.at(id));
    if (forest.body(body.members.back()) != nullptr)
      throw std::runtime_error("particle " + std::to_string(id) + " is in two groups");
  }
  body.mass = number_from<Scalar>(data.mass);
  body.expiry = {number_from<Scalar>(data.expiry[0]), finite_from<Scalar>(data.expiry[1])};  // may be never
  body.birth = time_from<Scalar>(data.birth);
  std::vector<int> roots(data.nodes.size(), -1);
  for (std::size_t n = data.nodes.size(); n-- > 0;) {
    const StateData::Node& from = data.nodes[n];
    Node node{index_of.at(from.i),
              index_of.at(from.j),
              from.outer ? Limit::outer : Limit::inner,
              {},
              {},
              vector_from<Scalar, D>(from.dp)};
    for (std::size_t s = 0; s < 2; ++s) {
      node.mass[s] = number_from<Scalar>(from.masses[s]);
      const StateData::Side& side = from.sides[s];
      if (side.node && (*side.node <= static_cast<int>(n) || *side.node >= static_cast<int>(roots.size()))) {
        throw std::runtime_error("a group's nodes are not a tree");
      }
      node.side[s] = side.node       ? roots[static_cast<std::size_t>(*side.node)]
                     : side.particle ? ~index_of.at(*side.particle)
                                     : Node::kInfiniteMass;
    }
    roots[n] = forest.join(node, body).root;
  }
  if (roots.empty() || forest.members_of(roots.front()) != body.members)
    throw std::runtime_error("a group's members are not those of its nodes");
}

}  // namespace tps::detail

#include "properties/laws/nested_loads.hpp"

namespace tps::properties {
namespace {

struct Body {
  Wide inverse_mass;
  WideVector velocity;
  std::vector<std::size_t> members;  ///< of finite mass
};

struct Node {
  Body i, j;
  WideVector dp;  ///< Δp_AB on i
};

}  // namespace

GroupVelocities nested_loads(const GroupCase& group) {
  std::vector<Body> body_of;
  for (std::size_t n = 0; n < group.m.size(); ++n) {
    const bool wall = std::isinf(group.m[n]);
    body_of.push_back({inverse_mass(group.m[n]), wide(group.v[n]),
                       wall ? std::vector<std::size_t>{} : std::vector<std::size_t>{n}});
  }
  std::vector<Node> nodes;
  for (const GroupCollision& c : group.collisions) {
    const auto at_i = static_cast<std::size_t>(c.i), at_j = static_cast<std::size_t>(c.j);
    const Body i = body_of[at_i], j = body_of[at_j];
    const Wide sum = i.inverse_mass + j.inverse_mass;
    const WideVector r = wide(group.u[at_j]) - wide(group.u[at_i]), v = j.velocity - i.velocity;
    const WideVector dp = ((1 + Wide(c.c)) / sum * dot(v, r) / dot(r, r)) * r;
    nodes.push_back({i, j, dp - v / sum});
    const Wide weight = j.inverse_mass / sum;  // of i: 1/(1 + m_j/m_i)
    Body joined{i.inverse_mass * j.inverse_mass / sum, weight * i.velocity + (1 - weight) * j.velocity,
                i.members};
    joined.members.insert(joined.members.end(), j.members.begin(), j.members.end());
    for (const std::size_t member : joined.members) body_of[member] = joined;
  }
  GroupVelocities result;
  for (const Body& body : body_of) result.loaded.push_back(body.velocity);
  result.restituted = result.loaded;
  for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
    for (const std::size_t n : node->i.members)
      result.restituted[n] = result.restituted[n] + node->i.inverse_mass * node->dp;
    for (const std::size_t n : node->j.members)
      result.restituted[n] = result.restituted[n] - node->j.inverse_mass * node->dp;
  }
  return result;
}

}  // namespace tps::properties

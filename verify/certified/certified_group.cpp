#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/certified/certified_response.hpp"
#include "verify/certified/enclosure.hpp"
#include "verify/certified/response.hpp"
#include "verify/operations/no_answer.hpp"

namespace tps::certified {
namespace {

/// A particle or a group; an infinite mass always stays by itself.
struct Body {
  Real inverse_mass;
  RealVector velocity;
  std::vector<std::size_t> members;
};

/// One load: what eq. (3) needs to undo it.
struct Node {
  std::vector<std::size_t> members_i, members_j;
  Real inverse_i, inverse_j;
  RealVector dp;  ///< Δp_AB on the side of i, eq. (7)
};

class Grouping {
 public:
  explicit Grouping(const operations::GroupInput& input) : input_(input) {
    for (std::size_t n = 0; n < input.bodies.size(); ++n) {
      bodies_.push_back({inverse_mass(input.bodies[n].mass), lifted(input.bodies[n].velocity), {n}});
      body_of_.push_back(n);
    }
  }

  GroupResponse answer() {
    GroupResponse response;
    for (collision_ = 0; collision_ < input_.collisions.size(); ++collision_)
      load(input_.collisions[collision_]);
    std::vector<RealVector> velocities;
    for (const std::size_t body : body_of_) velocities.push_back(bodies_[body].velocity);
    for (const RealVector& v : velocities) response.loaded.push_back(enclosure(v));
    unwind(velocities);
    for (const RealVector& v : velocities) response.restituted.push_back(enclosure(v));
    response.boundary = boundary_;
    return response;
  }

 private:
  void load(const operations::GroupInput::Collision& c) {
    const std::size_t at_i = body_of_[c.i];
    const std::size_t at_j = body_of_[c.j];
    if (at_i == at_j) refuse(fmt::format("bodies {} and {} are in one group; they move as one", c.i, c.j));
    const Body i = bodies_[at_i];
    const Body j = bodies_[at_j];
    if (sign(i.inverse_mass) == Sign::zero && sign(j.inverse_mass) == Sign::zero) {
      refuse(fmt::format("{} and {} are both of infinite mass, or grounded; such bodies never interact", c.i,
                         c.j));
    }
    const RealVector r = lifted(input_.bodies[c.j].position) - lifted(input_.bodies[c.i].position);
    if (sign(dot(r, r)) == Sign::zero) {
      refuse(fmt::format("bodies {} and {} are at one point, so û is not defined; move one", c.i, c.j));
    }
    const Collision pair = collision(r, j.velocity - i.velocity, i.inverse_mass, j.inverse_mass);
    const RealVector dp = impulse(pair, c);

    nodes_.push_back({i.members, j.members, i.inverse_mass, j.inverse_mass, dp - pair.mu * pair.v});
    join(i, j, at_i, at_j);
  }

  RealVector impulse(const Collision& pair, const operations::GroupInput::Collision& c) {
    const Sign normal = sign(pair.vr);
    if (!c.outer) {
      if (normal == Sign::positive) refuse("the bodies separate at an inner limit; they do not collide");
      return collision_impulse(pair, c.c);
    }
    if (normal == Sign::negative) refuse("the bodies approach at an outer limit; they do not collide");
    const TetherDecision decision = tether_decision(pair, c.c_retract, c.theta_revolve_deg);
    boundary_ = boundary_ || decision.boundary;
    if (decision.retracts) return collision_impulse(pair, c.c_retract);
    if (sign(dot(pair.w, pair.w)) == Sign::uncertain)
      refuse("2^14 bits do not tell the tangential velocity from zero");
    return revolution_impulse(pair, c.c_revolve, c.theta_revolve_deg);
  }

  /// Both take v_load. An infinite particle stays outside, so that what is grounded on it remains apart.
  void join(const Body& i, const Body& j, std::size_t at_i, std::size_t at_j) {
    Body joined{Real(0), load_velocity(i.inverse_mass, j.inverse_mass, i.velocity, j.velocity), {}};
    const Real sum = i.inverse_mass + j.inverse_mass;
    joined.inverse_mass = i.inverse_mass * j.inverse_mass / sum;
    const auto is_wall = [&](std::size_t n) { return std::isinf(input_.bodies[n].mass); };
    const bool wall_i = is_wall(i.members.front());
    const bool wall_j = is_wall(j.members.front());
    const std::size_t at = wall_i ? at_j : at_i;
    if (!wall_i) joined.members = i.members;
    if (!wall_j) joined.members.insert(joined.members.end(), j.members.begin(), j.members.end());
    for (const std::size_t member : joined.members) body_of_[member] = at;
    bodies_[at] = std::move(joined);
  }

  /// The newest node first: a root comes before the loads below it, and separate trees touch different
  /// bodies.
  void unwind(std::vector<RealVector>& velocities) const {
    for (auto node = nodes_.rbegin(); node != nodes_.rend(); ++node) {
      const RealVector change_i = node->inverse_i * node->dp;
      const RealVector change_j = node->inverse_j * node->dp;
      for (const std::size_t member : node->members_i) velocities[member] = velocities[member] + change_i;
      for (const std::size_t member : node->members_j) velocities[member] = velocities[member] - change_j;
    }
  }

  [[noreturn]] void refuse(const std::string& message) const {
    throw operations::NoAnswer(message, fmt::format("/collisions/{}", collision_));
  }

  const operations::GroupInput& input_;
  std::vector<Body> bodies_;
  std::vector<std::size_t> body_of_;  ///< by particle: a place in bodies_
  std::vector<Node> nodes_;           ///< in the order of loading
  std::size_t collision_ = 0;         ///< the one being loaded, for messages
  bool boundary_ = false;
};

}  // namespace

GroupResponse certified_group(const operations::GroupInput& input) {
  return settled([&] { return Grouping(input).answer(); });
}

}  // namespace tps::certified

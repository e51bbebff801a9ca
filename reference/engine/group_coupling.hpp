// Loading and restitution of bodies, eqs. (3), (6) and (7), on the trees of group_forest.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>

#include "reference/engine/coupling.hpp"
#include "reference/engine/group_forest.hpp"
#include "reference/engine/world.hpp"
#include "reference/equations/eq6_load_velocity.hpp"
#include "reference/equations/eq7_restitution_impulse.hpp"
#include "reference/equations/weighted_square.hpp"

namespace tps {

template <typename Scalar, int D>
class GroupCoupling final : public Coupling<Scalar, D> {
 public:
  using Vec = Vector<Scalar, D>;
  using Node = GroupNode<Scalar, D>;
  using Body = GroupBody<Scalar, D>;

  GroupCoupling(std::size_t particles, const Scalar& dt_restitute)
      : Coupling<Scalar, D>(Coupling<Scalar, D>::Bodies::of_several),
        forest_(particles),
        dt_restitute_(dt_restitute) {}

  const GroupForest<Scalar, D>& forest() const { return forest_; }
  GroupForest<Scalar, D>& forest() { return forest_; }

  /// Loads two bodies (semantics §4): both take v_load, the node keeps Δp_AB, the whole tree gets a new
  /// expiry. An infinite mass stays outside, so that bodies grounded on it remain separate trees.
  void collide(World<Scalar, D>& world, const Collision<Scalar, D>& c, Record<Scalar, D>& record) override {
    world.ledger.lost += c.loss;
    require_normal_impulses<Scalar, D>(world, c.i, c.j, c.dp, c.mass_i, c.mass_j);
    const Vec v_i = world.velocity(c.i);
    const Vec v_j = world.velocity(c.j);
    const Vec v_load = load_velocity<Scalar, D>(c.mass_i, c.mass_j, v_i, v_j);
    const Vec dp_stored = restitution_impulse<Scalar, D>(c.mass_i, c.mass_j, v_i, v_j, c.dp);
    const Scalar mu = reduced_mass<Scalar>(c.mass_i, c.mass_j);

    Body joined;
    joined.mass = c.mass_i + c.mass_j;
    joined.birth = world.now;
    for (const int side : {c.i, c.j}) {
      if (world.fixed(side)) continue;
      const Body* body = forest_.body(side);
      const std::vector<int> members = body != nullptr ? body->members : std::vector<int>{side};
      if (body != nullptr && body->birth < joined.birth) joined.birth = body->birth;
      std::vector<int> merged;
      std::merge(joined.members.begin(), joined.members.end(), members.begin(), members.end(),
                 std::back_inserter(merged));
      joined.members = std::move(merged);
    }
    joined.expiry = after(world.now, dt_restitute_);
    require_range(world, c, joined);
    const auto side_of = [&](int i) { return world.fixed(i) ? Node::kInfiniteMass : forest_.side_of(i); };
    forest_.join({c.i, c.j, c.limit, {side_of(c.i), side_of(c.j)}, {c.mass_i, c.mass_j}, dp_stored}, joined);

    move_as_one(world, joined.members, v_load, record);
    loaded_.dp_stored = dp_stored;
    loaded_.members = joined.members;
    record.addition = &loaded_;
    world.ledger.stored += energy_kept(dp_stored, mu);
    add_wall_impulse(world, c.mass_i, c.mass_j, Vec(mu * c.frame.v_AB));
    world.statistics.largest_group =
        std::max<std::uint64_t>(world.statistics.largest_group, joined.members.size());
  }

  void push(World<Scalar, D>& world, int i, const Vec& impulse, Record<Scalar, D>& record) override {
    const Body* body = forest_.body(i);
    const std::vector<int> members = body != nullptr ? body->members : std::vector<int>{i};
    const Scalar mass = this->body_mass(world, i);
    require_normal_impulse<Scalar, D>(world.scene, i, impulse, mass, world.velocity(i));
    move_as_one(world, members, Vec(world.velocity(i) + impulse / mass), record);
    if (mass == std::numeric_limits<Scalar>::infinity()) world.ledger.add_from_walls(Vec(-impulse));
  }

  /// Unwinds a body at its expiry: root first, each node parts its two bodies by eq. (3) with Δp_AB, until
  /// only particles are left. Each node is an event of its own.
  void restitute(World<Scalar, D>& world, int member) {
    const Body body = forest_.dissolve(member);
    world.statistics.oldest_group = std::max(world.statistics.oldest_group, elapsed(body.birth, world.now));
    for (const int m : body.members) {
      world.bring(m);
      world.touch(m);
    }
    std::vector<int> open = {body.root};
    while (!open.empty()) {
      const int n = open.back();
      open.pop_back();
      const std::array<int, 2> sides = forest_.node(n).side;
      part(world, n);
      if (sides[1] >= 0) open.push_back(sides[1]);
      if (sides[0] >= 0) open.push_back(sides[0]);
    }
  }

  LiveGroups<Scalar> live_groups(const Time<Scalar>& end) const override {
    LiveGroups<Scalar> live;
    for (const Body* body : forest_.bodies()) {
      ++live.count;
      live.oldest = std::max(live.oldest, elapsed(body->birth, end));
    }
    return live;
  }

 private:
  bool share_body(int i, int j) const override { return forest_.together(i, j); }

  Scalar mass_of_body(const World<Scalar, D>& world, int i) const override {
    const Body* body = forest_.body(i);
    return body != nullptr ? body->mass : world.mass(i);
  }

  /// |Δp_AB|²/2μ, what a load keeps for its restitution.
  static Scalar energy_kept(const Vec& dp, const Scalar& mu) {
    return square_over<Scalar, D>(dp, mu) / Scalar(2);
  }

  /// A sum of finite masses is finite, and so is a time that a finite one ends. The weights of eq. (6) are
  /// normal numbers, or v_load would not be right to rounding.
  void require_range(const World<Scalar, D>& world, const Collision<Scalar, D>& c, const Body& joined) const {
    const bool finite_masses = is_finite(c.mass_i) && is_finite(c.mass_j);
    const std::string of = " of the group of " + pair_name(world.scene, c.i, c.j);
    if (finite_masses && !is_finite(joined.mass)) throw OutOfRange("the mass" + of);
    const Scalar least = (std::numeric_limits<Scalar>::min)();
    if (finite_masses && std::min(c.mass_i, c.mass_j) / joined.mass < least)
      throw OutOfRange("the share of the lighter mass" + of);
    if (is_finite(dt_restitute_) && joined.expiry == Time<Scalar>::never())
      throw OutOfRange("the restitution" + of);
  }

  void part(World<Scalar, D>& world, int n) {
    const std::vector<int> members_i = forest_.members_of(forest_.node(n).side[0]);
    const std::vector<int> members_j = forest_.members_of(forest_.node(n).side[1]);
    const Node node = forest_.take_node(n);
    Record<Scalar, D> record = world.open_record("restitute", node.i, node.j);
    require_apart(world, node.i, node.j);
    record.dp = node.dp;
    require_normal_impulses<Scalar, D>(world, node.i, node.j, node.dp, node.mass[0], node.mass[1]);
    const PairVelocities<Scalar, D> v = directed_response<Scalar, D>(
        world, node.i, node.j, node.limit, node.mass[0], node.mass[1],
        apply_impulse<Scalar, D>(node.mass[0], node.mass[1], world.velocity(node.i), world.velocity(node.j),
                                 node.dp));
    for (const int m : members_i) world.set_velocity(m, v.v_A);
    for (const int m : members_j) world.set_velocity(m, v.v_B);
    const Scalar mu = reduced_mass<Scalar>(node.mass[0], node.mass[1]);
    world.ledger.stored += -energy_kept(node.dp, mu);
    add_wall_impulse(world, node.mass[0], node.mass[1], node.dp);
    world.responded.add(node.i, node.j, node.limit);
    world.close_record(record);
  }

  /// Momentum that goes to the finite side of a pair from the infinite one; `to_i` is what i would get.
  static void add_wall_impulse(World<Scalar, D>& world, const Scalar& mass_i, const Scalar& mass_j,
                               const Vec& to_i) {
    const Scalar infinite = std::numeric_limits<Scalar>::infinity();
    if (mass_j == infinite) world.ledger.add_from_walls(to_i);
    if (mass_i == infinite) world.ledger.add_from_walls(Vec(-to_i));
  }

  static void move_as_one(World<Scalar, D>& world, const std::vector<int>& members, const Vec& velocity,
                          Record<Scalar, D>& record) {
    for (const int m : members) {
      if (m != record.i && m != record.j) world.involve(record, m);
    }
    for (const int m : members) world.set_velocity(m, velocity);
  }

  GroupForest<Scalar, D> forest_;
  Scalar dt_restitute_;
  Addition<Scalar, D> loaded_;  ///< to the record of the last load
};

}  // namespace tps

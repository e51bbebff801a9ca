// group_bodies for one scalar. Included by the instantiating files only.
#pragma once

#include <set>

#include "reference/engine/group_coupling.hpp"
#include "reference/engine/state_numbers.hpp"
#include "reference/equations/eq4_collision_impulse.hpp"
#include "reference/equations/tether_response.hpp"
#include "reference/run/grouped_bodies.hpp"

namespace tps {

/// A species a body, no pair laws: what happens is asked for, not predicted.
inline Scene scene_of(const GroupedBodies& question) {
  Scene scene;
  scene.dimension = question.dimension;
  for (const GroupedBodies::Body& body : question.bodies) {
    const auto n = static_cast<std::int32_t>(scene.particles.size());
    scene.species.push_back({"body " + std::to_string(n), body.mass, 0, {}});
    scene.particles.push_back({n, n, body.position, body.velocity});
  }
  return scene;
}

template <typename Scalar, int D>
class GroupedBodiesIn {
 public:
  explicit GroupedBodiesIn(const GroupedBodies& question)
      : question_(question),
        scene_(scene_of(question)),
        world_(scene_, TimingChoice{}),
        coupling_(question.bodies.size(), Scalar(0)) {}

  GroupedVelocities answer() {
    GroupedVelocities answer;
    for (const GroupedBodies::Collision& c : question_.collisions) load(c);
    answer.loaded = velocities();
    std::set<int> open;  // one member of each body
    for (const GroupBody<Scalar, D>* body : coupling_.forest().bodies()) open.insert(body->members.front());
    for (const int member : open) coupling_.restitute(world_, member);
    answer.restituted = velocities();
    return answer;
  }

 private:
  void load(const GroupedBodies::Collision& c) {
    const int i = std::min(c.i, c.j), j = std::max(c.i, c.j);
    Record<Scalar, D> record = world_.open_record("load", i, j);
    Collision<Scalar, D> collision{};
    collision.i = i;
    collision.j = j;
    collision.limit = c.limit;
    collision.mass_i = coupling_.body_mass(world_, i);
    collision.mass_j = coupling_.body_mass(world_, j);
    const PairPlaces<Scalar, D>& places = world_.places(i, j);
    collision.frame =
        collision_frame<Scalar, D>(places.u_i, places.u_j, world_.velocity(i), world_.velocity(j));
    collision.dp = impulse(c, collision);
    coupling_.collide(world_, collision, record);
    world_.close_record(record);
  }

  static Vector<Scalar, D> impulse(const GroupedBodies::Collision& c, const Collision<Scalar, D>& collision) {
    if (c.limit == Limit::inner) {
      return collision_impulse<Scalar, D>(collision.frame, collision.mass_i, collision.mass_j, Scalar(c.c));
    }
    return tether_response<Scalar, D>(collision.frame, collision.mass_i, collision.mass_j, Scalar(c.c),
                                      Scalar(c.c_revolve), Scalar(c.theta_revolve_deg))
        .dp;
  }

  std::vector<HexVector> velocities() const {
    std::vector<HexVector> list;
    for (int i = 0; i < world_.size(); ++i)
      list.push_back(detail::vector_data<Scalar, D>(world_.velocity(i)));
    return list;
  }

  const GroupedBodies& question_;
  Scene scene_;
  World<Scalar, D> world_;
  GroupCoupling<Scalar, D> coupling_;
};

template <typename Scalar>
GroupedVelocities group_in(const GroupedBodies& question) {
  try {
    if (question.dimension == 2) return GroupedBodiesIn<Scalar, 2>(question).answer();
    return GroupedBodiesIn<Scalar, 3>(question).answer();
  } catch (const OutOfRange& problem) {
    return {{}, {}, problem.what()};
  }
}

}  // namespace tps

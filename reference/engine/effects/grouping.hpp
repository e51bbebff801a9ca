// Grouping of nearly simultaneous collisions, eqs. (6) and (7), semantics §4: takes the place of eq. (3) at
// once, and has one event of its own, the restitution of a body at its expiry.
#pragma once

#include <memory>

#include "reference/engine/effect.hpp"
#include "reference/engine/effect_records.hpp"
#include "reference/engine/group_coupling.hpp"
#include "reference/engine/group_state.hpp"

namespace tps::effects {

template <typename Scalar, int D>
class Grouping final : public Effect<Scalar, D> {
 public:
  std::string_view name() const override { return "grouping"; }
  void begin(World<Scalar, D>& world, int self) override {
    self_ = self;
    auto coupling = std::make_unique<GroupCoupling<Scalar, D>>(world.particles.size(),
                                                               Scalar(world.scene.grouping->dt_restitute));
    coupling_ = coupling.get();
    world.coupling = std::move(coupling);
  }

  void queue_known(World<Scalar, D>& world) override {
    for (const GroupBody<Scalar, D>* body : coupling_->forest().bodies()) queue_expiry(world, *body);
  }

  void refresh(World<Scalar, D>& world, const std::vector<int>& touched) override {
    for (const int i : touched) {
      const GroupBody<Scalar, D>* body = coupling_->forest().body(i);
      if (body != nullptr && body->members.front() == i) queue_expiry(world, *body);
    }
  }

  void respond(World<Scalar, D>& world, const PendingEvent<Scalar>& event) override {
    coupling_->restitute(world, event.first);
  }

  void save(const World<Scalar, D>& world, StateData& state) const override {
    for (const GroupBody<Scalar, D>* body : coupling_->forest().bodies())
      state.groups.push_back(detail::group_data(world, coupling_->forest(), *body));
  }
  void load(World<Scalar, D>&, const StateData& state, const IndexOfId& index_of) override {
    for (const StateData::Group& group : state.groups)
      detail::restore_group(coupling_->forest(), group, index_of);
  }

 private:
  void queue_expiry(World<Scalar, D>& world, const GroupBody<Scalar, D>& body) {
    const int name = body.members.front();
    world.queue.push(world.pending(body.expiry, Rank::restitution, name, name, 0, self_));
  }

  GroupCoupling<Scalar, D>* coupling_ = nullptr;  ///< owned by the world
  int self_ = 0;
};

struct grouping {
  static EffectCall call(const Scene& scene) {
    EffectCall call{
        "grouping", "nearly simultaneous collisions act on groups, eqs. 6-7", {}, "\"grouping\"", {}};
    if (scene.grouping) call.because.push_back(key_of_scene("grouping"));
    call.cost = "a load and a restitution a collision, each on all particles of a group";
    return call;
  }
  static EffectRecords records(const Scene&) { return {.kinds = {{"restitute", About::pair}}}; }
  template <typename Scalar, int D>
  static std::unique_ptr<Effect<Scalar, D>> make(const Scene&) {
    return std::make_unique<Grouping<Scalar, D>>();
  }
};

}  // namespace tps::effects

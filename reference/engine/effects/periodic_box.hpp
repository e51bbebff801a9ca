// A periodic box: a pair meets by the image that is nearest, positions stay unwrapped and images are
// integers.
//
// Laws: (1) a pair's event is the earliest with any image; (2) adding edges to a position changes no event
// but by the rounding of that position; (3) without a box there is no image.
#pragma once

#include <memory>
#include <string>

#include "reference/engine/cells/region_plan.hpp"
#include "reference/engine/effect.hpp"
#include "reference/engine/periodic_box.hpp"
#include "reference/engine/world.hpp"

namespace tps::effects {

/// It has no events of its own.
template <typename Scalar, int D>
class NearestImages final : public Effect<Scalar, D> {
 public:
  std::string_view name() const override { return "periodic_box"; }
  void begin(World<Scalar, D>& world, int) override {
    world.box = std::make_unique<PeriodicBox<Scalar, D>>(world.scene);
  }
  void respond(World<Scalar, D>&, const PendingEvent<Scalar>&) override {}
};

struct periodic_box {
  static EffectCall call(const Scene& scene) {
    EffectCall call{"periodic_box", "pairs meet by their nearest images", {}, "\"box\"", {}};
    call.cost = "an image at each question of a pair";
    if (!scene.box) return call;
    call.because.push_back(key_of_scene("box"));
    call.cost += RegionPlan::of<double>(scene, {}).fits_into(*scene.box, scene.dimension)
                     ? "; cells go round it, from 16 particles on"
                     : "; all pairs are asked, as the box is too narrow for cells";
    return call;
  }
  template <typename Scalar, int D>
  static std::unique_ptr<Effect<Scalar, D>> make(const Scene&) {
    return std::make_unique<NearestImages<Scalar, D>>();
  }
};

}  // namespace tps::effects

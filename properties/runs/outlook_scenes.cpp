#include "properties/runs/outlook_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

#include "properties/runs/choices.hpp"
#include "properties/runs/scene_bounds.hpp"
#include "reference/scene/check_starts.hpp"
#include "reference/scene/pair_law.hpp"
#include "reference/scene/read_scene.hpp"
#include "reference/scene/write_scene.hpp"
#include "reference/text/input_error.hpp"

namespace tps::properties::runs {
namespace {

/// The largest component of a velocity; where all rest, a limit in the duration.
double speed_of(const Scene& scene) {
  double largest = 0;
  for (const Particle& p : scene.particles) {
    for (const double v : p.velocity) largest = std::max(largest, std::abs(v));
  }
  return largest > 0 ? largest : longest_limit(scene) / scene.duration;
}

/// In six steps of the duration the scene's speed is gained once or twice.
void let_fall(Scene& scene) {
  const double strength = pick({1.0, 2.0, 0.01});
  const double steps = pick({6.0, 1.5, 24.0});
  scene.gravity = Gravity{{}, scene.duration / steps};
  for (std::size_t k = 0; k < at(scene.dimension); ++k)
    scene.gravity->acceleration[k] =
        (k == 1 ? -1 : around_zero(2) / 4.0) * strength * speed_of(scene) / scene.duration;
}

template <typename Kick>
void kick(Scene& scene, const Kick& kicks_of) {
  for (Species& species : scene.species) {
    if (std::isfinite(species.mass))
      kicks_of(species, scene.duration / pick({2.0, 8.0, 0.5}), speed_of(scene));
  }
}

void push_at_random(Scene& scene) {
  kick(scene, [](Species& species, double tau, double speed) {
    species.random_impulses = RandomImpulses{tau, pick({1.0, 0.25, 9.0}), species.mass * speed};
  });
}

void thermalise(Scene& scene) {
  kick(scene, [](Species& species, double tau, double speed) {
    const double kT = species.mass * speed * speed;
    species.thermostat = Thermostat{tau, kT};
  });
}

/// Of what is wanted, what may stand beside the effect.
Wanted with_room_for(Outlook effect, Wanted wanted) {
  const bool by_kicks = effect == Outlook::gravity || effect == Outlook::random_impulses;
  if (!by_kicks) wanted.grouping = Wanted::Choice::never;
  const bool has_walls = effect == Outlook::walls || effect == Outlook::block || effect == Outlook::box;
  if (has_walls) wanted.infinite_masses = false;
  if (has_walls || effect == Outlook::drag || effect == Outlook::friction) wanted.outside = false;
  if (effect == Outlook::friction || effect == Outlook::box) wanted.tethers = false;
  return wanted;
}

SmallScene with(Outlook effect, SmallScene small, bool may_fall) {
  switch (effect) {
    case Outlook::gravity:
      let_fall(small.scene);
      return small;
    case Outlook::random_impulses:
      push_at_random(small.scene);
      return small;
    case Outlook::thermostat:
      thermalise(small.scene);
      return small;
    case Outlook::drag:
      small.scene.drag = Drag{pick({0.5, 4.0, 0.01}) / small.scene.duration};
      return small;
    case Outlook::friction:
      return with_friction(std::move(small));
    case Outlook::walls:
      small = between_walls(std::move(small));
      break;
    case Outlook::block:
      small = around_a_block(std::move(small));
      break;
    case Outlook::box:
      return small;  // drawn in it
  }
  if (may_fall && once_in(2)) let_fall(small.scene);
  return small;
}

/// With a second effect, where a scene can have both.
SmallScene with_also(Outlook effect, const SmallScene& small) {
  if (effect == Outlook::gravity && small.scene.gravity) return small;
  SmallScene made = with(effect, small, false);
  try {
    return {read_scene_text(write_scene(made.scene), "it")};
  } catch (const InputError&) {
    return small;
  }
}

/// As narrow as a box may be, a quarter more: everybody meets images of everybody.
SmallScene in_a_box(SmallScene small) {
  const double L = longest_limit(small.scene);
  Scene scene = shifted(small.scene, L / 4);
  const Bounds bounds = bounds_of(scene);
  scene.box.emplace();
  scene.box->edges.fill(std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < at(scene.dimension); ++k)
    scene.box->edges[k] = std::max(2.25 * L, bounds.high[k] + L * 1.25);
  return {scene};
}

/// Away from where they were drawn, rounded places have other distances.
bool start_apart(const Scene& scene) {
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Particle &a = scene.particles[j], &b = scene.particles[i];
      const PairLaw* law = pair_law(scene.pairs, a.species, b.species);
      if (law != nullptr && law->blocking &&
          start_verdict(a.position, b.position, law->blocking->distance) == StartVerdict::nearer)
        return false;
    }
  }
  return true;
}

}  // namespace

const char* name_of(Outlook effect) {
  constexpr std::array names{"gravity",  "random_impulses", "thermostat", "drag",
                             "friction", "walls",           "block",      "box"};
  return names.at(static_cast<std::size_t>(effect));
}

std::ostream& operator<<(std::ostream& out, Outlook effect) {
  return out << name_of(effect);
}

rc::Gen<SmallScene> outlook_scene(Outlook effect, const Wanted& wanted, const std::vector<Outlook>& beside) {
  const Wanted with_room = with_room_for(effect, wanted);
  const rc::Gen<SmallScene> plain = rc::gen::suchThat(
      effect == Outlook::box ? scene_in_a_box(with_room) : small_scene(with_room),
      [effect](const SmallScene& small) {
        return !small.scene.pairs.empty() && (effect != Outlook::drag || can_have_drag(small.scene));
      });
  return rc::gen::resize(rc::kNominalSize, rc::gen::exec([=] {
                           SmallScene made = with(effect, *plain, wanted.gravity);
                           for (const Outlook other : beside) {
                             if (other != effect && once_in(2)) made = with_also(other, made);
                           }
                           return made;
                         }));
}

rc::Gen<SmallScene> scene_in_a_box(const Wanted& wanted) {
  return rc::gen::suchThat(rc::gen::map(small_scene(wanted), in_a_box),
                           [](const SmallScene& small) { return start_apart(small.scene); });
}

bool can_have_drag(const Scene& scene) {
  const bool thresholds = std::ranges::any_of(scene.pairs, [](const PairLaw& law) {
    return law.tethering && law.tethering->breaks.when == BreakRule::When::impulse_above;
  });
  const bool walls_move = std::ranges::any_of(scene.particles, [&](const Particle& p) {
    const double mass = scene.species[static_cast<std::size_t>(p.species)].mass;
    return std::isinf(mass) && p.velocity != Coordinates{};
  });
  return !thresholds && !walls_move && !scene.grouping && scene.phases.empty() && scene.impulses.empty();
}

SmallScene with_friction(SmallScene small) {
  Scene& scene = small.scene;
  const auto blocking =
      std::ranges::find_if(scene.pairs, [](const PairLaw& law) { return law.blocking.has_value(); });
  if (blocking == scene.pairs.end()) return small;
  const double radius = blocking->blocking->distance / 2;
  for (Species& species : scene.species) species.radius = radius;
  int n = static_cast<int>(scene.particles.size());
  for (PairLaw& law : scene.pairs) {
    if (!law.blocking || law.blocking->distance != radius + radius) continue;
    ++n;
    law.friction = FrictionLaw{.25 * (1 + n % 4), -1 + .5 * (n % 5)};
  }
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const Particle& p = scene.particles[i];
    if (!keeps_spin(scene, p.species)) continue;
    Coordinates spin{};
    for (std::size_t k = 0; k < (scene.dimension == 2 ? 1U : 3U); ++k)
      spin[k] = (p.id + static_cast<int>(k)) % 3 - 1 + p.velocity[k];
    set_spin(scene, i, spin);
  }
  return small;
}

SmallScene between_walls(SmallScene small) {
  Scene& scene = small.scene;
  const double radius = largest_radius(scene);
  const auto count = static_cast<int>(scene.particles.size());
  const double margin = radius * (1 + count % 3);
  Wall box{.shape = Wall::Shape::box, .c_rebound = count % 2 == 0 ? 1 : 0.5};
  Wall post{
      .shape = Wall::Shape::sphere, .radius = margin / 4, .inside = false, .c_rebound = count % 4 / 4.0};
  const Bounds bounds = bounds_of(scene);
  for (std::size_t k = 0; k < at(scene.dimension); ++k) {
    box.point[k] = bounds.low[k] - radius - margin;
    box.high[k] = bounds.high[k] + radius + margin;
    post.point[k] = box.high[k] - margin / 2;
  }
  scene.walls = {box, post};
  return small;
}

SmallScene around_a_block(SmallScene small) {
  Scene& scene = small.scene;
  const double radius = largest_radius(scene);
  const auto count = static_cast<int>(scene.particles.size());
  const double margin = radius * (2 + count % 3);
  Wall hall{.shape = Wall::Shape::box, .c_rebound = 1};
  Wall block{.shape = Wall::Shape::box, .inside = false, .c_rebound = 1 - count % 4 / 4.0};
  const Bounds bounds = bounds_of(scene);
  for (std::size_t k = 0; k < at(scene.dimension); ++k) {
    hall.point[k] = bounds.low[k] - radius - margin / 2;
    hall.high[k] = bounds.high[k] + radius + margin;
    block.point[k] = bounds.high[k] + radius + margin / 4;
    block.high[k] = bounds.high[k] + radius + margin / 2;
  }
  scene.walls = {hall, block};
  return small;
}

Scene shifted(Scene scene, double by) {
  const Bounds bounds = bounds_of(scene);
  for (Particle& p : scene.particles) {
    for (std::size_t k = 0; k < at(scene.dimension); ++k) p.position[k] += by - bounds.low[k];
  }
  return scene;
}

}  // namespace tps::properties::runs

// Small scenes with what the paper leaves to its outlook: one effect each, and what may stand beside it.
#pragma once

#include <array>
#include <iosfwd>
#include <vector>

#include "properties/runs/scenes.hpp"

namespace tps::properties::runs {

enum class Outlook { gravity, random_impulses, thermostat, drag, friction, walls, block, box };

inline constexpr std::array kOutlook{
    Outlook::gravity,  Outlook::random_impulses, Outlook::thermostat, Outlook::drag,
    Outlook::friction, Outlook::walls,           Outlook::block,      Outlook::box};

const char* name_of(Outlook effect);
std::ostream& operator<<(std::ostream& out, Outlook effect);

/// Small scenes that call for an effect and hold nothing that is undefined beside it, nor what is not wanted.
/// Kicks are as strong as the scene is fast, and come some times in its duration; between walls
/// every second scene falls, too, if that is wanted. Of the effects `beside` every second scene
/// has each, where a scene can have both. Law: (1) read_scene_text accepts what write_scene writes of each,
/// and returns the same.
rc::Gen<SmallScene> outlook_scene(Outlook effect, const Wanted& wanted = {},
                                  const std::vector<Outlook>& beside = {});

/// Nothing at times of its own, no threshold, infinite masses at rest: what drag may be added to.
bool can_have_drag(const Scene& scene);

/// All species get the radius that one pair's blocking distance is twice of, and the pairs with that distance
/// friction; everybody spins.
SmallScene with_friction(SmallScene small);

/// A box around everybody, wider than the particles by a multiple of their radius, and a post in its highest
/// corner.
SmallScene between_walls(SmallScene small);

/// A box around everybody, and in its highest corner a block, a box that they are outside of.
SmallScene around_a_block(SmallScene small);

/// The scene in the corner of the positive axes.
Scene shifted(Scene scene, double by);

/// In a periodic box that is so narrow that everybody meets images of everybody. REQUIRES no tethers and no
/// infinite masses wanted.
rc::Gen<SmallScene> scene_in_a_box(const Wanted& wanted);

}  // namespace tps::properties::runs

// What a schema cannot say about a scene: whether it makes sense as physics.
#pragma once

#include "reference/scene/scene.hpp"
#include "reference/scene/scene_source.hpp"

namespace tps {

/// Reports to `source` whatever the semantics refuse, each check only where the keys it needs are sound:
///
/// - distances: a limit must be positive and finite; a tethering distance must exceed the blocking distance
///   of its pair by more than 1e-9 of itself, since pairs with a smaller gap stall (semantics §3); a
///   tethering that is not permanent needs its distance; a permanent one never breaks;
/// - infinite masses: all share one velocity (two of them never interact), and none takes an impulse;
/// - phases: until > from, a tethering that is not permanent, no two at a time for one rule of one pair;
/// - tethers at the start: two particles, once, of a pair with tethering that is not permanent, at least one
/// of
///   finite mass, within the capacities;
/// - drag: nothing that happens at times of its own, and infinite masses at rest (docs/effects.md);
/// - friction: at the sum of radii, without grouping and drag, spins where it can turn (docs/effects.md);
/// - the starts of the particles: see check_starts.hpp.
void check_scene(const Scene& scene, SceneSource& source);

/// The part of it about drag. REQUIRES species, particles, impulses and phases read.
void check_drag(const Scene& scene, SceneSource& source);

/// The part of it about friction and spins. REQUIRES species, pairs and particles read.
void check_friction(const Scene& scene, SceneSource& source);

}  // namespace tps

// The systems whose cost an event is measured, at any size.
#pragma once

#include "reference/scene/scene.hpp"

namespace tps::scale {

/// Hard spheres (diameter, mass and kT 1, c = 1) in a spherical membrane, of which they fill the part φ.
Scene hard_spheres(int particles, double filled);

/// The same in a periodic cube.
Scene periodic_spheres(int particles, double filled);

/// Chains of hard spheres, about so many spheres in all, that are tethered to their neighbours up to 1.5
/// diameters, in a spherical membrane; φ is about 0.3.
Scene chains(int particles, int beads);

/// The paper's Figure 1 at another size: vesicles and twice as many pairs of synapsins.
Scene terminal(int vesicles, bool grouped);

/// A membrane of so many particles, tethered to nearest neighbours, with thermal velocities.
Scene sheet(int particles, bool grouped);

}  // namespace tps::scale

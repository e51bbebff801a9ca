// Start velocities and directions drawn for a scene.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/scene/random.hpp"
#include "reference/scene/scene.hpp"

namespace tps {

/// A direction uniform on the sphere: a point uniform in the ball (drawn in the cube until inside),
/// normalised.
Coordinates random_direction(RandomStream& stream);

/// Gives every particle of finite mass a Maxwell velocity: `dimension` components, each normal with variance
/// temperature/mass (the temperature in units of energy), drawn from the stream (seed, scene_velocity, id);
/// then takes the velocity of the centre of mass from all of them. (1) The momentum of the finite masses is
/// zero but for the rounding of the subtraction. (2) Infinite masses keep their velocity. (3) Temperature 0
/// leaves everything at rest.
Scene with_thermal_velocities(Scene scene, double temperature);

}  // namespace tps

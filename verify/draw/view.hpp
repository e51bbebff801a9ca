// From the coordinates of a scene to those of a picture.
#pragma once

#include <array>
#include <vector>

#include "reference/scene/scene.hpp"

namespace tps {

/// A particle as the picture has it: pixels, y downwards; depth 0 is the farthest, 1 the nearest.
struct Seen {
  double x = 0;
  double y = 0;
  double radius = 0;
  double depth = 1;
};

/// Lengths are multiplied by it: the extent of coordinates of opposite sign near the largest double
/// overflows.
inline constexpr double kQuarter = 0.25;

/// How lengths and places become pixels.
struct View {
  double middle_x = 0, middle_y = 0;  ///< of what is seen, in quarters
  double half = 0;                    ///< of its larger side, in quarters
  double size = 0;                    ///< of the picture

  double pixels(double length) const;  ///< of a length in quarters
  double x(double coordinate) const;
  double y(double coordinate) const;
};

/// The view that holds all particles, and walls that have an extent.
View view_of(const Scene& scene, const std::vector<std::array<double, 3>>& positions, double size);

/// All particles fitted into a square of `size` pixels with a margin. A particle of radius 0, or one too
/// small to be seen, is drawn at least 1.5 pixels large.
std::vector<Seen> fit_to_picture(const Scene& scene, const std::vector<std::array<double, 3>>& positions,
                                 double size);

}  // namespace tps

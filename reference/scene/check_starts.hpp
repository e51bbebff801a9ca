// Whether the particles start where their limits allow them to be.
#pragma once

#include "reference/scene/scene.hpp"
#include "reference/scene/scene_source.hpp"

namespace tps {

/// Reports every pair that starts nearer than its blocking distance, and every tethered pair (listed or
/// permanent) that starts farther apart than its tethering distance, by more than 4 ulp of the largest
/// coordinate of the two positions. Within that it is a contact: honest scenes touch, and their coordinates
/// are rounded (a cradle at 0.1 i). The verdict is exact: see start_verdict. Two infinite masses never
/// interact and may start anywhere.
///
/// Pairs of species without a law cost nothing; pairs that are too near or too far are found by
/// a tree of boxes, without looking at all pairs.
/// REQUIRES that species, pairs, particles and tethers of the scene are sound. Stops where `source` is full.
void check_starts(const Scene& scene, SceneSource& source);

/// Where a distance |b - a| lies against a limit, give or take 4 ulp of the largest coordinate.
enum class StartVerdict {
  nearer,   ///< |b - a| < limit - 4 ulp
  contact,  ///< between the two
  farther,  ///< |b - a| > limit + 4 ulp
};

/// The verdict of real arithmetic on the stored numbers. Squares in double decide what is farther from the
/// limit than their rounding; rationals decide the rest.
/// (1) start_verdict(a, b, L) = start_verdict(b, a, L). REQUIRES limit > 0, all finite.
StartVerdict start_verdict(const Coordinates& a, const Coordinates& b, double limit);

/// 4 ulp of the largest coordinate of the two positions, an ulp being the distance to the next double away
/// from zero.
double start_allowance(const Coordinates& a, const Coordinates& b);

}  // namespace tps

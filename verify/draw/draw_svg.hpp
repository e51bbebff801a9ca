// A picture of a state, in the manner of the paper's Figure 1.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "reference/scene/scene.hpp"

namespace tps {

struct DrawOptions {
  double size = 720;             ///< width of the picture, in pixels, 64 to 16384; title above, legend below
  std::optional<double> time{};  ///< shown in the legend, if given
};

/// A self-contained SVG 1.1 document: no script, no style sheet, no font but generic ones, its own
/// background, so that it looks the same in a page of any colour.
///
/// Orthographic projection on the x-y plane, y upwards; particles and tethers are painted from far (small z)
/// to near, and far ones fade into the background. Containers (outer particles of permanent tethers) are
/// circles behind everything, and so are walls. Members of a cluster (Scene::clusters: connected by tethers,
/// permanent ones not counted) wear a rim in the colour of their cluster, and so do the tethers between them.
/// `positions` are those of Scene::particles, in their order; `tethers` are pairs of indices into it.
/// REQUIRES finite positions, as many as particles, and indices below their number; throws
/// std::invalid_argument that names the first one that is not. (1) A pure function of its arguments: same
/// state, same bytes. (2) One <circle class="particle"> a particle that is no container, one
/// class="container" a container, one <line class="tether"> a tether. (3) Coordinates of any finite size are
/// scaled to the picture before anything is squared or subtracted.
std::string draw_svg(const Scene& scene, const std::vector<std::array<double, 3>>& positions,
                     const std::vector<Tether>& tethers, const DrawOptions& options = {});

}  // namespace tps

#include "verify/draw/draw_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "reference/scene/clusters.hpp"
#include "verify/draw/elements.hpp"
#include "verify/draw/palette.hpp"
#include "verify/draw/view.hpp"
#include "verify/draw/walls.hpp"

namespace tps {
namespace {

/// Particles that hold others by a permanent tether: a fixed particle at least as large as the limit.
std::vector<bool> containers(const Scene& scene) {
  std::vector<bool> contains(scene.species.size(), false);
  for (const PairLaw& law : scene.pairs) {
    if (!law.tethering || law.tethering->form.when != FormRule::When::permanent) continue;
    for (const int species : {law.species_a, law.species_b}) {
      const Species& outer = scene.species[static_cast<std::size_t>(species)];
      if (std::isinf(outer.mass) && outer.radius >= law.tethering->distance) {
        contains[static_cast<std::size_t>(species)] = true;
      }
    }
  }
  std::vector<bool> result;
  for (const Particle& particle : scene.particles) {
    result.push_back(contains[static_cast<std::size_t>(particle.species)]);
  }
  return result;
}

void check(const Scene& scene, const std::vector<std::array<double, 3>>& positions,
           const std::vector<Tether>& tethers, const DrawOptions& options) {
  if (positions.size() != scene.particles.size()) {
    throw std::invalid_argument(
        fmt::format("draw: {} positions for the {} particles of the scene; give one each", positions.size(),
                    scene.particles.size()));
  }
  for (std::size_t i = 0; i < positions.size(); ++i) {
    for (const double x : positions[i]) {
      if (std::isfinite(x)) continue;
      throw std::invalid_argument(
          fmt::format("draw: particle {} has the coordinate {}; only finite ones can be drawn",
                      scene.particles[i].id, x));
    }
  }
  const auto count = static_cast<int>(positions.size());
  for (const auto& [i, j] : tethers) {
    if (i >= 0 && i < count && j >= 0 && j < count) continue;
    throw std::invalid_argument(
        fmt::format("draw: a tether of the indices {} and {}; allowed is 0 to {}", i, j, count - 1));
  }
  if (!(options.size >= 64 && options.size <= 16384)) {
    throw std::invalid_argument(fmt::format("draw: size is {} pixels; allowed is 64 to 16384", options.size));
  }
}

/// For each particle the number of its cluster, 0, 1, … by size, or −1 where it is in none.
std::vector<int> cluster_numbers(const Scene& scene, const std::vector<Tether>& tethers) {
  std::vector<int> number(scene.particles.size(), -1);
  if (!scene.clusters) return number;
  int clusters = 0;
  for (const std::vector<int>& cluster : clusters_of(scene, tethers, *scene.clusters)) {
    for (const int i : cluster) number[static_cast<std::size_t>(i)] = clusters;
    ++clusters;
  }
  return number;
}

/// Positions are unwrapped; of each particle the image in the periodic box is drawn, if there is one.
std::vector<std::array<double, 3>> in_the_box(const Scene& scene,
                                              std::vector<std::array<double, 3>> positions) {
  if (!scene.box) return positions;
  for (std::array<double, 3>& x : positions) {
    for (std::size_t k = 0; k < x.size(); ++k) {
      const double edge = scene.box->edges[k];
      if (std::isfinite(edge)) x[k] -= std::floor(x[k] / edge) * edge;
    }
  }
  return positions;
}

/// Everything but containers and texts, from far to near.
std::vector<Layer> layers_of(const Drawing& drawing, const std::vector<Tether>& tethers) {
  std::vector<Layer> layers;
  // Tethers first: at equal depth, as in a plane, their ends then lie under the particles.
  for (const auto& [i, j] : tethers) {
    layers.push_back(tether_layer(drawing, static_cast<std::size_t>(i), static_cast<std::size_t>(j)));
  }
  for (std::size_t i = 0; i < drawing.seen.size(); ++i) {
    if (!drawing.container[i]) layers.push_back(particle_layer(drawing, i));
  }
  std::stable_sort(layers.begin(), layers.end(),
                   [](const Layer& a, const Layer& b) { return a.depth < b.depth; });
  return layers;
}

}  // namespace

std::string draw_svg(const Scene& scene, const std::vector<std::array<double, 3>>& unwrapped,
                     const std::vector<Tether>& tethers, const DrawOptions& options) {
  check(scene, unwrapped, tethers, options);
  const std::vector<std::array<double, 3>> positions = in_the_box(scene, unwrapped);
  const double size = options.size;
  const double title_height = 1.5 * kLegendLine;
  const Drawing drawing{scene, options, fit_to_picture(scene, positions, size), containers(scene),
                        cluster_numbers(scene, tethers)};
  const std::vector<std::string> legend = legend_lines(drawing, size / 24, title_height + size + 5);
  const double height = title_height + size + kLegendLine * static_cast<double>(legend.size());

  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"15\" fill=\"{2}\">\n<defs>\n{3}</defs>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"{4}\"/>\n",
      size, height, hex(kInk), gradients(scene), hex(kBackground));
  svg += text_element(size / 24, kLegendLine * 1.3, scene.title);
  svg += fmt::format("<g transform=\"translate(0 {:.0f})\">\n", title_height);
  for (std::size_t i = 0; i < drawing.seen.size(); ++i) {
    if (drawing.container[i]) svg += container_element(drawing.seen[i]);
  }
  svg += wall_elements(scene, view_of(scene, positions, size), options.time.value_or(0));
  for (const Layer& layer : layers_of(drawing, tethers)) svg += layer.element;
  svg += "</g>\n";
  for (const std::string& line : legend) svg += line;
  return svg + "</svg>\n";
}

}  // namespace tps

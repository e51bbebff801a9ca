// The SVG elements of a picture, from what was worked out about its state.
#pragma once

#include <string>
#include <vector>

#include "reference/scene/scene.hpp"
#include "verify/draw/draw_svg.hpp"
#include "verify/draw/view.hpp"

namespace tps {

/// Pixels from one line of the legend to the next.
inline constexpr double kLegendLine = 24;

/// The document in the making: the state it shows and what was worked out about it.
struct Drawing {
  const Scene& scene;
  const DrawOptions& options;
  std::vector<Seen> seen;
  std::vector<bool> container;
  std::vector<int> cluster;  ///< -1: none
};

/// What is painted at one depth.
struct Layer {
  double depth = 0;
  std::string element;
};

std::string container_element(const Seen& at);
Layer particle_layer(const Drawing& drawing, std::size_t i);
Layer tether_layer(const Drawing& drawing, std::size_t i, std::size_t j);

/// Shading of spheres lit from the upper left, a gradient a species and shade of depth.
std::string gradients(const Scene& scene);

/// A line of text.
std::string text_element(double x, double y, const std::string& content);

/// The lines of the legend: the time, each species with its number of particles, the clusters.
std::vector<std::string> legend_lines(const Drawing& drawing, double left, double top);

}  // namespace tps

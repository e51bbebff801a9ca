#include "verify/draw/elements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reference/text/printable.hpp"
#include "verify/draw/palette.hpp"

namespace tps {
namespace {

constexpr std::size_t kLongestLabel = 500;  // of a title: what no picture shows

}  // namespace

std::string container_element(const Seen& at) {
  return fmt::format(
      "<circle class=\"container\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"url(#membrane)\" "
      "stroke=\"{}\" "
      "stroke-width=\"2.5\"/>\n",
      at.x, at.y, at.radius, hex(mixed(kBackground, kInk, 0.55)));
}

Layer particle_layer(const Drawing& drawing, std::size_t i) {
  const Seen& at = drawing.seen[i];
  const int species = drawing.scene.particles[i].species;
  const int cluster = drawing.cluster[i];
  const Rgb rim =
      cluster < 0 ? mixed(cyclic(kSpeciesColours, species), kInk, 0.45) : cyclic(kClusterColours, cluster);
  const double width = std::min(cluster < 0 ? 0.8 : 2.2, at.radius * (cluster < 0 ? 0.15 : 0.4));
  // Four shades of depth a species: enough to see, few enough to stay small.
  const int shade = static_cast<int>(std::lround(at.depth * 3));
  return {at.depth,
          fmt::format("<circle class=\"particle\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" "
                      "fill=\"url(#s{}d{})\" stroke=\"{}\" stroke-width=\"{:.2f}\"/>\n",
                      at.x, at.y, at.radius - width / 2, species, shade, hex(faded(rim, at.depth)), width)};
}

Layer tether_layer(const Drawing& drawing, std::size_t i, std::size_t j) {
  const Seen& from = drawing.seen[i];
  const Seen& to = drawing.seen[j];
  const int cluster = drawing.cluster[i];
  const Rgb colour = cluster < 0 ? kTether : cyclic(kClusterColours, cluster);
  const double depth = (from.depth + to.depth) / 2;
  const double width = std::clamp(std::min(from.radius, to.radius) / 4, 0.9, 3.0);
  return {depth, fmt::format("<line class=\"tether\" x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" "
                             "stroke=\"{}\" stroke-width=\"{:.2f}\" stroke-linecap=\"round\"/>\n",
                             from.x, from.y, to.x, to.y, hex(faded(colour, depth)), width)};
}

std::string gradients(const Scene& scene) {
  std::string result = fmt::format(
      "<radialGradient id=\"membrane\"><stop offset=\"0\" stop-color=\"{0}\"/><stop offset=\"0.85\" "
      "stop-color=\"{0}\"/>"
      "<stop offset=\"1\" stop-color=\"{1}\"/></radialGradient>\n",
      hex({255, 255, 255}), hex({232, 228, 218}));
  for (std::size_t species = 0; species < scene.species.size(); ++species) {
    const Rgb colour = cyclic(kSpeciesColours, static_cast<int>(species));
    for (int shade = 0; shade <= 3; ++shade) {
      const double depth = shade / 3.0;
      result += fmt::format(
          "<radialGradient id=\"s{}d{}\" cx=\"0.38\" cy=\"0.34\" r=\"0.72\"><stop offset=\"0\" "
          "stop-color=\"{}\"/>"
          "<stop offset=\"0.55\" stop-color=\"{}\"/><stop offset=\"1\" "
          "stop-color=\"{}\"/></radialGradient>\n",
          species, shade, hex(faded(mixed(colour, {255, 255, 255}, 0.65), depth)), hex(faded(colour, depth)),
          hex(faded(mixed(colour, kInk, 0.4), depth)));
    }
  }
  return result;
}

std::string text_element(double x, double y, const std::string& content) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x, y,
                     xml_text(printable(content, kLongestLabel)));
}

std::vector<std::string> legend_lines(const Drawing& drawing, double left, double top) {
  const Scene& scene = drawing.scene;
  std::vector<std::string> lines;
  const auto next_y = [&] { return top + kLegendLine * static_cast<double>(lines.size()); };
  if (drawing.options.time) {
    lines.push_back(text_element(left, next_y(), fmt::format("t = {:.6g}", *drawing.options.time)));
  }
  for (std::size_t species = 0; species < scene.species.size(); ++species) {
    int count = 0;
    bool container = false;
    for (std::size_t i = 0; i < drawing.seen.size(); ++i) {
      if (scene.particles[i].species != static_cast<int>(species)) continue;
      ++count;
      container = drawing.container[i];
    }
    const std::string key = fmt::format(
        "<circle class=\"key\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"7\" fill=\"{}\" stroke=\"{}\"/>\n", left + 7,
        next_y() - 5, container ? "url(#membrane)" : fmt::format("url(#s{}d3)", species),
        hex(mixed(kBackground, kInk, 0.55)));
    lines.push_back(
        key + text_element(left + 22, next_y(), fmt::format("{} × {}", count, scene.species[species].name)));
  }
  if (scene.clusters) {
    int clusters = 0;
    for (const int number : drawing.cluster) clusters = std::max(clusters, number + 1);
    const std::string& observed = scene.species[static_cast<std::size_t>(scene.clusters->species)].name;
    lines.push_back(text_element(
        left, next_y(),
        fmt::format("{} {} of at least {} × {}", clusters, clusters == 1 ? "cluster" : "clusters",
                    scene.clusters->at_least, observed)));
  }
  return lines;
}

}  // namespace tps

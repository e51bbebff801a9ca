#include "verify/draw/walls.hpp"

#include <fmt/format.h>

#include <cmath>

#include "verify/draw/palette.hpp"

namespace tps {
namespace {

Coordinates moved(const Coordinates& point, const Coordinates& velocity, double time) {
  Coordinates x = point;
  for (std::size_t k = 0; k < x.size(); ++k) x[k] += velocity[k] * time;
  return x;
}

std::string styled(const std::string& shape) {
  return fmt::format("<{} class=\"wall\" fill=\"none\" stroke=\"{}\" stroke-width=\"2.5\"/>\n", shape,
                     hex(mixed(kBackground, kInk, 0.55)));
}

/// The line n·x = n·p, across a picture's diagonal on both sides of the foot of its middle.
std::string line_of(const Wall& wall, const Coordinates& point, const View& view) {
  const double nx = wall.normal[0], ny = wall.normal[1];
  const double off = nx * (kQuarter * point[0] - view.middle_x) + ny * (kQuarter * point[1] - view.middle_y);
  const double x = view.size / 2 + nx * view.pixels(off), y = view.size / 2 - ny * view.pixels(off);
  const double reach = 1.5 * view.size;
  return styled(fmt::format("line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\"", x - ny * reach,
                            y - nx * reach, x + ny * reach, y + nx * reach));
}

}  // namespace

std::string wall_elements(const Scene& scene, const View& view, double time) {
  std::string all;
  for (const Wall& wall : scene.walls) {
    const Coordinates point = moved(wall.point, wall.velocity, time);
    switch (wall.shape) {
      case Wall::Shape::plane:
        if (wall.normal[2] == 0 && view.half > 0) all += line_of(wall, point, view);
        break;
      case Wall::Shape::sphere:
        all += styled(fmt::format("circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"", view.x(point[0]),
                                  view.y(point[1]), view.pixels(kQuarter * wall.radius)));
        break;
      case Wall::Shape::box: {
        const Coordinates high = moved(wall.high, wall.velocity, time);
        all += styled(fmt::format("rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"",
                                  view.x(point[0]), view.y(high[1]), view.x(high[0]) - view.x(point[0]),
                                  view.y(point[1]) - view.y(high[1])));
        break;
      }
    }
  }
  if (scene.box && std::isfinite(scene.box->edges[0]) && std::isfinite(scene.box->edges[1])) {
    all += styled(fmt::format("rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"", view.x(0),
                              view.y(scene.box->edges[1]), view.x(scene.box->edges[0]) - view.x(0),
                              view.y(0) - view.y(scene.box->edges[1])));
  }
  if (all.empty()) return all;
  // An inner picture cuts off what lies outside of it.
  return fmt::format("<svg width=\"{0:.0f}\" height=\"{0:.0f}\">\n{1}</svg>\n", view.size, all);
}

}  // namespace tps

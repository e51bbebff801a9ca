#include "verify/draw/view.hpp"

#include <algorithm>
#include <cmath>

namespace tps {
namespace {

struct Interval {
  double least = 0;
  double most = 0;
  double middle() const { return least / 2 + most / 2; }
  double half() const { return most / 2 - least / 2; }
};

double radius_of(const Scene& scene, std::size_t i) {
  return scene.species[static_cast<std::size_t>(scene.particles[i].species)].radius;
}

}  // namespace

double View::pixels(double length) const {
  const double margin = size / 24;
  const double reach = size / 2 - margin;  // from the middle to the farthest edge
  return half > 0 ? length / half * reach : 0.0;
}
double View::x(double coordinate) const {
  return size / 2 + pixels(kQuarter * coordinate - middle_x);
}
double View::y(double coordinate) const {
  return size / 2 - pixels(kQuarter * coordinate - middle_y);
}

View view_of(const Scene& scene, const std::vector<std::array<double, 3>>& positions, double size) {
  std::array<Interval, 3> box{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const double x = kQuarter * positions[i][k];
      const double r = kQuarter * radius_of(scene, i);
      if (i == 0) box[k] = {x - r, x + r};
      box[k] = {std::min(box[k].least, x - r), std::max(box[k].most, x + r)};
    }
    if (scene.box && std::isfinite(scene.box->edges[k]))
      box[k] = {std::min(box[k].least, 0.0), std::max(box[k].most, kQuarter * scene.box->edges[k])};
    for (const Wall& wall : scene.walls) {
      if (wall.shape == Wall::Shape::plane) continue;
      const double low = wall.shape == Wall::Shape::box ? wall.point[k] : wall.point[k] - wall.radius;
      const double high = wall.shape == Wall::Shape::box ? wall.high[k] : wall.point[k] + wall.radius;
      box[k] = {std::min(box[k].least, kQuarter * low), std::max(box[k].most, kQuarter * high)};
    }
  }
  return {box[0].middle(), box[1].middle(), std::max(box[0].half(), box[1].half()), size};
}

std::vector<Seen> fit_to_picture(const Scene& scene, const std::vector<std::array<double, 3>>& positions,
                                 double size) {
  const View view = view_of(scene, positions, size);
  // Depth goes by the centres, so that the nearest is 1 even when a membrane reaches farther.
  double front = 0;
  double back = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const double z = kQuarter * positions[i][2];
    front = i == 0 ? z : std::max(front, z);
    back = i == 0 ? z : std::min(back, z);
  }
  std::vector<Seen> seen;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const double z = kQuarter * positions[i][2];
    seen.push_back({.x = view.x(positions[i][0]),
                    .y = view.y(positions[i][1]),
                    .radius = std::max(1.5, view.pixels(kQuarter * radius_of(scene, i))),
                    .depth = front > back ? (z / 2 - back / 2) / (front / 2 - back / 2) : 1.0});
  }
  return seen;
}

}  // namespace tps

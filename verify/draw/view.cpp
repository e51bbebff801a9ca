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

}  // namespace

std::vector<Seen> fit_to_picture(const Scene& scene, const std::vector<std::array<double, 3>>& positions,
                                 double size) {
  const auto radius_of = [&](std::size_t i) {
    return scene.species[static_cast<std::size_t>(scene.particles[i].species)].radius;
  };
  // Quarters, because the extent of coordinates of opposite sign near the largest double overflows.
  const double quarter = 0.25;
  std::array<Interval, 3> box{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const double x = quarter * positions[i][k];
      const double r = quarter * radius_of(i);
      if (i == 0) box[k] = {x - r, x + r};
      box[k] = {std::min(box[k].least, x - r), std::max(box[k].most, x + r)};
    }
  }
  const double half = std::max(box[0].half(), box[1].half());
  const double margin = size / 24;
  const double reach = size / 2 - margin;  // pixels from the middle to the farthest edge
  const auto pixels = [&](double length) { return half > 0 ? length / half * reach : 0.0; };

  // Depth goes by the centres, so that the nearest is 1 even when a membrane reaches farther.
  double front = 0;
  double back = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const double z = quarter * positions[i][2];
    front = i == 0 ? z : std::max(front, z);
    back = i == 0 ? z : std::min(back, z);
  }
  std::vector<Seen> seen;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const double z = quarter * positions[i][2];
    seen.push_back({.x = size / 2 + pixels(quarter * positions[i][0] - box[0].middle()),
                    .y = size / 2 - pixels(quarter * positions[i][1] - box[1].middle()),
                    .radius = std::max(1.5, pixels(quarter * radius_of(i))),
                    .depth = front > back ? (z / 2 - back / 2) / (front / 2 - back / 2) : 1.0});
  }
  return seen;
}

}  // namespace tps

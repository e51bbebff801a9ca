#include "verify/scenes/placement.hpp"

#include <algorithm>

namespace tps {

bool is_free(const Placed& sphere, const std::vector<Placed>& others, double ball_radius) {
  const auto square_of_distance = [&](const Coordinates& from) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += (sphere.center[k] - from[k]) * (sphere.center[k] - from[k]);
    return sum;
  };
  const double inside = ball_radius - sphere.radius;
  if (inside <= 0 || square_of_distance({}) >= inside * inside) return false;
  return std::all_of(others.begin(), others.end(), [&](const Placed& other) {
    const double apart = sphere.radius + other.radius;
    return square_of_distance(other.center) > apart * apart;
  });
}

Coordinates random_point(RandomStream& stream, double ball_radius) {
  while (true) {
    Coordinates point{};
    double square = 0;
    for (double& x : point) {
      x = 2 * next_uniform(stream) - 1;
      square += x * x;
    }
    if (square > 1) continue;
    for (double& x : point) x *= ball_radius;
    return point;
  }
}

}  // namespace tps

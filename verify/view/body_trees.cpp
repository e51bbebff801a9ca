#include "verify/view/body_trees.hpp"

#include <cmath>

namespace tps::view {

BodyTrees::BodyTrees(const Scene& scene) : bodies_(scene.particles.size()) {
  for (const Particle& p : scene.particles)
    infinite_.push_back(std::isinf(scene.species[static_cast<std::size_t>(p.species)].mass));
}

void BodyTrees::load(int i, int j, const std::vector<int>& members) {
  const auto body = std::make_shared<Body>();
  body->number = loads_++;
  body->i = i;
  body->j = j;
  body->members = members;
  body->sides = {of(i), of(j)};
  body->grounded = grounded(i) || grounded(j) || infinite(i) || infinite(j);
  for (const int member : members) of(member) = body;
}

std::array<std::vector<int>, 2> BodyTrees::part(int i, int j) {
  std::shared_ptr<Body> body = of(i) ? of(i) : of(j);
  const bool is_root = body && body->i == i && body->j == j;
  if (is_root) {
    for (const int member : body->members) of(member) = nullptr;
  }
  std::array<std::vector<int>, 2> sides;
  for (std::size_t s = 0; s < 2; ++s) {
    const int particle = s == 0 ? i : j;
    const std::shared_ptr<Body> below = is_root ? body->sides[s] : nullptr;
    if (below) {
      sides[s] = below->members;
      for (const int member : below->members) of(member) = below;
    } else if (!infinite(particle)) {
      sides[s] = {particle};
    }
  }
  return sides;
}

int BodyTrees::number(int particle) const {
  return of(particle) == nullptr ? -1 : of(particle)->number;
}

bool BodyTrees::grounded(int particle) const {
  return of(particle) != nullptr && of(particle)->grounded;
}

}  // namespace tps::view

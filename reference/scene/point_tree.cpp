#include "reference/scene/point_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tps {
namespace {

constexpr std::size_t most_in_a_leaf = 8;

// As in check_starts.cpp: a computed square of a distance is within 2^-50 of itself of the true one, unless
// it underflows; squares below this may have.
constexpr double least_safe_square = 0x1p-900;
constexpr double square_rounding = 0x1p-48;

std::size_t longest_side(const PointTree::Box& box) {
  std::size_t longest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis) {
    // Halves: a difference of two doubles may overflow.
    const auto half = [&](std::size_t k) { return box.high[k] / 2 - box.low[k] / 2; };
    if (half(axis) > half(longest)) longest = axis;
  }
  return longest;
}

}  // namespace

PointTree::PointTree(const Scene& scene, std::vector<std::size_t> particles)
    : scene_(scene), particles_(std::move(particles)) {
  if (particles_.empty()) return;
  nodes_.push_back({box_of(0, particles_.size()), 0, particles_.size(), 0});
  for (std::size_t n = 0; n < nodes_.size(); ++n) split(n);
}

PointTree::Box PointTree::box_of(std::size_t begin, std::size_t end) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (std::size_t k = begin; k < end; ++k) {
    const Coordinates& position = scene_.particles[particles_[k]].position;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], position[axis]);
      box.high[axis] = std::max(box.high[axis], position[axis]);
    }
  }
  return box;
}

void PointTree::split(std::size_t n) {
  const std::size_t begin = nodes_[n].begin;
  const std::size_t end = nodes_[n].end;
  if (end - begin <= most_in_a_leaf) return;
  const std::size_t axis = longest_side(nodes_[n].box);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [this](std::size_t k) { return particles_.begin() + static_cast<std::ptrdiff_t>(k); };
  std::nth_element(at(begin), at(middle), at(end), [&](std::size_t a, std::size_t b) {
    return scene_.particles[a].position[axis] < scene_.particles[b].position[axis];
  });
  nodes_.push_back({box_of(begin, middle), begin, middle, 0});
  nodes_.push_back({box_of(middle, end), middle, end, 0});
  nodes_[n].second_child = nodes_.size() - 1;
}

bool may_be_nearer(const PointTree::Box& box, const Coordinates& point, double limit) {
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double outside = std::max({box.low[k] - point[k], point[k] - box.high[k], 0.0});
    square += outside * outside;
  }
  // An overflow to infinity is farther than any limit, but for one whose own square overflows.
  const double most = limit * limit * (1 + square_rounding);
  return !(square > least_safe_square && square * (1 - square_rounding) > most);
}

bool may_be_farther(const PointTree::Box& box, const Coordinates& point, double limit) {
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double across = std::max(std::fabs(box.high[k] - point[k]), std::fabs(box.low[k] - point[k]));
    square += across * across;
  }
  const double least = limit * limit * (1 - square_rounding);
  return !(least > least_safe_square && square * (1 + square_rounding) < least);
}

}  // namespace tps

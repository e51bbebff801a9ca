#include "properties/generators/groups.hpp"

#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "properties/generators/numbers.hpp"

namespace tps::properties {
namespace {

/// The links of a chain in a random order, the first `count` of them.
std::vector<int> some_links(int links, int count) {
  std::vector<int> order(static_cast<std::size_t>(links));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t k = order.size(); k > 1; --k)
    std::swap(order[k - 1], order[static_cast<std::size_t>(whole(0, static_cast<int>(k)))]);
  order.resize(static_cast<std::size_t>(count));
  return order;
}

}  // namespace

void put_group(Case& c, const Format& format) {
  c.dimension = whole(2, 4);
  c.hazard = one_of<std::string>({"chain", "wall", "pairs", "perpendicular"});
  const int bodies = c.hazard == "pairs" ? 4 : whole(2, 6);
  const auto axis = static_cast<std::size_t>(whole(0, c.dimension));
  std::vector<double>&m = c.numbers["m"], &u = c.numbers["u"], &v = c.numbers["v"];
  double along = number(format);
  for (int n = 0; n < bodies; ++n) {
    const bool wall = n == 0 && c.hazard == "wall";
    m.push_back(wall ? HUGE_VAL : finite_mass(format));
    const Vec3 across = vector(format, c.dimension);
    if (wall) along = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(c.dimension); ++k) {
      u.push_back(k == axis ? 2.0 * n : 0);
      v.push_back(k == axis ? along : wall ? 0 : across[k]);
    }
    const bool level = c.hazard == "perpendicular" && coin();
    if (!level) along = format.rounded(along - magnitude(format));
  }
  const std::vector<int> order =
      c.hazard == "pairs" ? std::vector<int>{0, 2, 1} : some_links(bodies - 1, whole(1, bodies));
  for (const int link : order) {
    const int turned = whole(0, 2);
    c.numbers["i"].push_back(link + turned);
    c.numbers["j"].push_back(link + 1 - turned);
    c.numbers["c"].push_back(coefficient(format));
  }
}

}  // namespace tps::properties

#include "reference/scene/nearest_name.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace tps {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  constexpr std::size_t longest = 64;  // a hostile name must not cost a quadratic table
  a = a.substr(0, longest);
  b = b.substr(0, longest);
  // d[i][j] is the distance of the first i characters of a and the first j of b (Wagner-Fischer, with the
  // swap of neighbours of Damerau, in the restricted form).
  std::array<std::array<std::size_t, longest + 1>, longest + 1> d;
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

std::string nearest_name(std::string_view name, const std::vector<std::string>& known) {
  constexpr std::size_t most_known =
      200;  // a hint is not worth a thousand tables for each of a thousand errors
  std::string nearest;
  std::size_t least = SIZE_MAX;
  for (std::size_t k = 0; k < std::min(known.size(), most_known); ++k) {
    const std::size_t distance = edit_distance(name, known[k]);
    if (distance >= least) continue;
    least = distance;
    nearest = known[k];
  }
  return nearest;
}

}  // namespace tps

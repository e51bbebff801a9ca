#include "reference/text/nearest_name.hpp"

#include <algorithm>
#include <array>
#include <optional>

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

namespace {

constexpr std::size_t kShortestPart = 3;  ///< of a name, that tells something

/// How well a name that is part of another one fits: less is better; absent where neither is part of the
/// other.
std::optional<std::size_t> misfit_of_part(std::string_view name, std::string_view known) {
  const bool is_shorter = name.size() <= known.size();
  const std::string_view part = is_shorter ? name : known, whole = is_shorter ? known : name;
  const std::size_t at = whole.find(part);
  if (at == std::string_view::npos || part.empty() || (at != 0 && part.size() < kShortestPart))
    return std::nullopt;
  const std::size_t order = is_shorter ? 0 : 4000, begins = at == 0 ? 0 : 2000;
  return order + begins + std::min<std::size_t>(whole.size() - part.size(), 1999);
}

}  // namespace

std::string nearest_name(std::string_view name, const std::vector<std::string>& known) {
  // A hint is not worth a thousand tables for each of a thousand errors.
  constexpr std::size_t most_known = 200;
  const std::string* best = nullptr;
  std::size_t least = 0;
  const std::size_t looked_at = std::min(known.size(), most_known);
  for (std::size_t k = 0; k < looked_at; ++k) {
    if (edit_distance(name, known[k]) <= 1) return known[k];
    const std::optional<std::size_t> misfit = misfit_of_part(name, known[k]);
    if (!misfit || (best != nullptr && *misfit >= least)) continue;
    best = &known[k];
    least = *misfit;
  }
  if (best != nullptr) return *best;
  const auto end = known.begin() + static_cast<std::ptrdiff_t>(looked_at);
  const auto nearest = std::min_element(known.begin(), end, [&](const auto& a, const auto& b) {
    return edit_distance(name, a) < edit_distance(name, b);
  });
  return nearest == end ? std::string() : *nearest;
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& known) {
  const std::string nearest = nearest_name(name, known);
  if (nearest.empty()) return ".";
  const std::size_t near = std::max<std::size_t>(1, std::max(name.size(), nearest.size()) / 3);
  if (!misfit_of_part(name, nearest) && edit_distance(name, nearest) > near) return ".";
  return "; did you mean " + nearest + "?";
}

}  // namespace tps

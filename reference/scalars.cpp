#include "reference/scalars.hpp"

#include <algorithm>

namespace tps {

const std::vector<std::string>& scalar_names() {
  static const std::vector<std::string> names(AllScalars::names.begin(), AllScalars::names.end());
  return names;
}

int significant_bits(ScalarKind scalar) {
  return AllScalars::bits.at(static_cast<std::size_t>(scalar));
}

std::optional<ScalarKind> scalar_kind(std::string_view name) {
  const auto found = std::find(scalar_names().begin(), scalar_names().end(), name);
  if (found == scalar_names().end()) return std::nullopt;
  return static_cast<ScalarKind>(found - scalar_names().begin());
}

}  // namespace tps

#include "properties/conform/offered_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "properties/conform/ask_steps.hpp"
#include "properties/conform/inquiry.hpp"
#include "properties/conform/siblings.hpp"
#include "properties/law.hpp"
#include "reference/text/nearest_name.hpp"
#include "reference/text/printable.hpp"
#include "verify/vectors/stratum.hpp"

namespace tps::properties::conform {

namespace {

/// The first pattern that fits no name; null where each fits some.
const std::string* fits_none(const std::vector<std::string>& patterns,
                             const std::vector<std::string>& names) {
  const auto fits = [&](const std::string& pattern) {
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return wanted({pattern}, name); });
  };
  const auto found = std::find_if_not(patterns.begin(), patterns.end(), fits);
  return found == patterns.end() ? nullptr : &*found;
}

}  // namespace

void check_operations(const std::vector<std::string>& patterns) {
  std::vector<std::string> names;
  for (const operations::Operation& operation : operations::catalogue()) {
    const bool has_law = std::any_of(laws().begin(), laws().end(), [&](const Law& law) {
      return std::find(law.operations.begin(), law.operations.end(), operation.op) != law.operations.end();
    });
    if (operation.is_certified || has_law) names.emplace_back(operation.name);
  }
  if (const std::string* pattern = fits_none(patterns, names)) {
    throw std::invalid_argument(
        fmt::format("{} is no operation; there are {}", printable(*pattern), fmt::join(names, ", ")));
  }
}

void check_strata(const std::vector<std::string>& patterns) {
  std::vector<std::string> names = step_rows();
  for (const vectors::Stratum& stratum : vectors::strata()) {
    names.push_back(stratum.full_name());
    if (!has(names, siblings_name(stratum.op))) names.push_back(siblings_name(stratum.op));
  }
  if (const std::string* pattern = fits_none(patterns, names)) {
    const std::string nearest = nearest_name(*pattern, names);
    throw std::invalid_argument(
        fmt::format("{} is no stratum{}; tps vectors list shows them; block_time.graze is one, *.far are "
                    "those of all operations",
                    printable(*pattern), nearest.empty() ? "" : fmt::format(" (did you mean {}?)", nearest)));
  }
}

}  // namespace tps::properties::conform

#include "verify/claims/claim.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tps::claims {

bool Claim::holds() const {
  return !figures.empty() &&
         std::all_of(figures.begin(), figures.end(), [](const Figure& figure) { return figure.holds; });
}

const std::vector<ClaimEntry>& all_claims() {
  static const std::vector<ClaimEntry> entries{
      {"collisions", "70 collisions of X, Y, Z with a light Y", collisions},
      {"stall", "the same stalls with inelastic collisions", stall},
      {"revolution", "four collisions a revolution, each keeping 0.84 of the speed", revolution},
      {"grouping", "70 collisions become 2", grouping},
      {"conservation", "grouping conserves momentum", conservation},
      {"clusters", "clusters form from isolated vesicles and synapsin pairs", clusters},
      {"impact", "clusters take impacts as deformable bodies do", impact}};
  return entries;
}

Figure exactly(std::string name, long long expected, std::string derivation, long long measured) {
  return {std::move(name), std::to_string(expected), std::move(derivation), std::to_string(measured),
          measured == expected};
}

Figure same(std::string name, std::string expected, std::string derivation, std::string measured) {
  const bool holds = measured == expected;
  return {std::move(name), std::move(expected), std::move(derivation), std::move(measured), holds};
}

Figure within(std::string name, double expected, double tolerance, std::string derivation, double measured,
              int digits) {
  return {std::move(name), fmt::format("{:.{}g} ± {:.1g}", expected, digits, tolerance),
          std::move(derivation), fmt::format("{:.{}g}", measured, digits),
          std::abs(measured - expected) <= tolerance};
}

Figure between(std::string name, double least, double most, std::string derivation, double measured,
               int digits) {
  return {std::move(name), fmt::format("{:.{}g} to {:.{}g}", least, digits, most, digits),
          std::move(derivation), fmt::format("{:.{}g}", measured, digits),
          least <= measured && measured <= most};
}

}  // namespace tps::claims

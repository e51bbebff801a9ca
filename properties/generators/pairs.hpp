// Pairs of particles about to meet a limit, most of them at an edge of the verdict tables.
#pragma once

#include <string>
#include <vector>

#include "properties/case.hpp"
#include "properties/format.hpp"

namespace tps::properties {

/// What generated pairs are aimed at; rounding may put them on either side, but "tangent", "taut" and "touch"
/// are exact in half of the cases: integers on Pythagorean axes.
const std::vector<std::string>& pair_hazards();

/// A pair and a limit of one hazard.
struct AimedPair {
  PairState pair;
  double L;
};
/// Drawn, like everything in numbers.hpp.
AimedPair pair_aimed_at(const std::string& hazard, const Format& format, int dimension);

/// Sets u_A, u_B, v_A, v_B and L of a case, aimed at one of the hazards, and says which. Called where a
/// generator is executed.
void put_pair(Case& c, const Format& format);

/// Every number a small integer times one power of two for lengths and one for speeds.
void put_integer_pair(Case& c);

}  // namespace tps::properties

// Runs laws: generates cases, and shrinks what breaks.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "properties/implementation.hpp"
#include "properties/law.hpp"

namespace tps::properties {

/// Which cases: numbers `first` to `first + count` of a seed. A case is a function of law, format, seed and
/// number alone.
struct Extent {
  std::uint64_t seed = 20260101;
  std::uint64_t first = 0;
  std::uint64_t count = 500;
  bool bitwise = false;  ///< a law that says bitwise is broken where it holds to rounding only
};

/// A case in which a law does not hold.
struct Finding {
  const Law* law;
  std::uint64_t number;  ///< of the case that was generated
  Case generated, shrunk;
  Outcome outcome;                  ///< of the shrunk case
  std::vector<Question> questions;  ///< that the law asked about the shrunk case
  int shrinks = 0;
};

/// What became of the cases of one law.
struct Tally {
  std::uint64_t held = 0, outside = 0, skipped = 0;
  std::uint64_t rounding = 0;                    ///< of those that held: in their last bits they did not
  std::uint64_t refused = 0;                     ///< questions that have an answer, and got none
  std::string in_last_bits;                      ///< of the first of them, what differed
  std::map<std::string, std::uint64_t> hazards;  ///< cases in which the law held, by hazards_of()
  std::string why_not;                           ///< of the latest case outside, skipped
};

/// Whether a case that held to rounding is to count as broken.
Outcome judged(Outcome outcome, bool bitwise);

struct Examined {
  Outcome outcome;
  std::vector<Question> questions;
};

/// One case.
Examined examine(const Law& law, Implementation& subject, const Case& c, bool bitwise = false);

/// The cases of an extent, until one is a finding or `stop` says so. A refusal is a finding only where no
/// case of the extent is another: the first, when all have been asked.
std::optional<Finding> check_law(
    const Law& law, Implementation& subject, const Extent& extent, Tally& tally,
    const std::function<bool()>& stop = [] { return false; });

/// The case of a law with a number.
Case generated_case(const Law& law, const Format& format, std::uint64_t seed, std::uint64_t number);

}  // namespace tps::properties

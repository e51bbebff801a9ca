// How far rounding may move the answer to a timing query, by the stable formulas and by the printed ones
// (docs/conform.md derives both).
#pragma once

#include <optional>
#include <string>

#include "verify/exact/timing_query.hpp"

namespace tps::properties::conform {

/// What somebody says of a timing query.
struct TimeAnswer {
  std::optional<std::string> verdict;
  std::optional<double> t;  ///< none where there is no event
};

enum class Margin {
  stable,   ///< the rounding of a stable evaluation explains it
  printed,  ///< that of b² − 4ac and (−b ± √)/2a does
  none,
};

/// The narrowest margin within which an answer is right, in numbers of `bits` bits.
Margin margin_of(const exact::TimingQuery& query, const TimeAnswer& answer, int bits);

/// The narrowest margin within which "before", "equal", "after" or "none" may be said of two queries: "none"
/// where neither has to happen, "equal" where no error tells the times apart.
Margin margin_of_order(const exact::TimingQuery& first, const exact::TimingQuery& second,
                       const std::string& order, int bits);

}  // namespace tps::properties::conform

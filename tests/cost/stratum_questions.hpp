// The questions that the tests of all scalars share, and who can be asked them.
#pragma once

#include <string>
#include <vector>

#include "verify/cost/questions.hpp"

namespace tps::cost {

/// How a stratum can be asked.
struct Asked {
  bool in_single;   ///< every number rounded to single precision, so that all scalars are asked the same
  int fewest_bits;  ///< scalars with fewer do not hold the hazard, or cannot resolve it
};

inline Asked asked(const std::string& stratum) {
  if (stratum == "any_scale" || stratum == "wide" || stratum == "subnormal") return {false, 113};
  if (stratum == "units") return {false, 53};  // squares leave the range of float
  if (stratum == "near_static" || stratum == "offset_origin" || stratum == "graded_limit") return {false, 53};
  if (stratum == "taut") return {true, 53};  // h and c are rounding noise: u cond is about 1 in float
  return {true, 24};
}

inline std::vector<TimingQuery> questions_for(const std::string& stratum, int count) {
  std::vector<TimingQuery> result;
  for (const TimingQuery& query : questions(stratum, 5, count)) {
    result.push_back(asked(stratum).in_single ? in_single_precision(query) : query);
  }
  return result;
}

}  // namespace tps::cost

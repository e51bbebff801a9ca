// What a number or vector of an operation's input may be, by its key.
#pragma once

#include <string_view>

namespace tps::operations {

enum class Domain {
  vector,              ///< 2 or 3 finite numbers, as many as in every other vector
  direction,           ///< a vector of length 1, to 2^-10: so that short formats have one, too
  spin,                ///< an angular velocity: one finite number in the plane, three in space
  number,              ///< finite
  length,              ///< finite, above 0
  rate,                ///< 1/time: finite, above 0
  not_negative,        ///< finite, at least 0
  mass,                ///< above 0, "inf" allowed
  coefficient,         ///< in [0, 1]
  signed_coefficient,  ///< in [-1, 1]
  angle,               ///< degrees in [1e-6, 90 − 1e-6]
};

Domain domain_of(std::string_view key);

}  // namespace tps::operations

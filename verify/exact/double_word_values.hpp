// The coefficients of stage 2 before they are rounded to double: for who shows them.
#pragma once

#include "verify/exact/double_word.hpp"
#include "verify/exact/timing_query.hpp"

namespace tps::exact {

/// a, h, c, D to the bounds that double_word_coefficients() tells, where it is in range.
struct DoubleWordValues {
  DoubleWord a, h, c, D;
};
DoubleWordValues double_word_values(const TimingQuery& query);

}  // namespace tps::exact

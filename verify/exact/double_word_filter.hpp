// Stage 2: the coefficients in double words from the exact r and v (docs/exact.md, "Stage 2").
#pragma once

#include <array>

#include "verify/exact/double_filter.hpp"
#include "verify/exact/double_word.hpp"

namespace tps::exact {

/// y − x of each component, exactly. REQUIRES no overflow.
inline std::array<DoubleWord, 3> exact_difference(const Vec3& y, const Vec3& x) {
  return {two_sum(y[0], -x[0]), two_sum(y[1], -x[1]), two_sum(y[2], -x[2])};
}

/// a, h, c, D with errors of order u², rounded to double at the end. The bounds include that last rounding
/// only as far as signs go: rounding to double cannot change a sign.
/// Law: where `in_range`, a sign certified here is the exact one.
Coefficients double_word_coefficients(const TimingQuery& query);

}  // namespace tps::exact

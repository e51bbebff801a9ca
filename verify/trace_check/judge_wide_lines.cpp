#include <algorithm>
#include <limits>
#include <type_traits>

#include "reference/run/run.hpp"
#include "reference/scalars.hpp"
#include "verify/trace_check/judge_lines_impl.hpp"
#include "verify/trace_check/wide.hpp"

namespace tps::check {
namespace {

/// Half an ulp; three quarters for Boost's binary floats (docs/decisions.md, N18).
template <typename Scalar>
Precision<Wide> precision_of() {
  using Limits = std::numeric_limits<Scalar>;
  const Wide half_ulp = ldexp(Wide(1), -Limits::digits);
  const bool hardware = std::is_floating_point_v<Scalar>;
  // The smallest numbers of Boost's types are below those of the type that judges them.
  const int smallest = std::max<int>(Limits::min_exponent, -(1 << 24)) - Limits::digits;
  return {hardware ? half_ulp : Wide(half_ulp * 3 / 2), ldexp(Wide(1), smallest), Limits::digits, false};
}

Precision<Wide> precision_named(std::string_view scalar) {
  return AllScalars::with<Precision<Wide>>(scalar_kind(scalar).value(),
                                           []<typename Scalar>() { return precision_of<Scalar>(); });
}

}  // namespace

std::unique_ptr<LineJudge> judge_of_wide(const JudgeParts& parts, std::string_view scalar,
                                         std::string_view state, std::uint64_t number) {
  return line_judge<Wide>(parts, precision_named(scalar), state, number);
}

}  // namespace tps::check

#include "verify/exact/refined_root.hpp"

#include "verify/exact/double_word_filter.hpp"
#include "verify/exact/newton_step.hpp"

namespace tps::exact {
namespace {

/// On which side of closest approach a hit is: −1 before it.
TPS_IN_EVERY_COPY double side_of(Kind kind) {
  return kind == Kind::block ? -1 : 1;
}

}  // namespace

std::optional<double> RefinedTime::rounded() const {
  const RoundedEnds<double> ends = rounded_ends(t, correction, error);
  if (ends.low == ends.high) return ends.low;
  return std::nullopt;
}

double approximate_time(Kind kind, Verdict verdict, const Coefficients& q) {
  return verdict == Verdict::turning ? approximate_turning(q) : approximate_hit(q, side_of(kind));
}

TPS_WITH_FMA std::optional<RefinedTime> refined_time(const TimingQuery& query, Verdict verdict, double t) {
  if (!usual_size(t)) return std::nullopt;
  const StateAt<double> at = state_at(relative_position(query), exact_difference(query.v_B, query.v_A), t);
  const double wide = widening(query);
  const NewtonStep<double> step = verdict == Verdict::turning
                                      ? step_to_turning(at, wide)
                                      : step_to_hit(at, query.L, side_of(query.kind), wide);
  if (!step.holds) return std::nullopt;
  return RefinedTime{t, step.correction, step.error};
}

}  // namespace tps::exact

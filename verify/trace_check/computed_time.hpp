// When something is by the clock of a run: a start hi + lo and a duration, added as docs/engine.md says, in
// the trace's own scalar.
#pragma once

#include <cmath>
#include <limits>

#include "verify/certified/exact_timing.hpp"
#include "verify/trace_check/number.hpp"

namespace tps::check {
namespace detail {

template <typename Scalar>
struct Sum {
  Scalar hi, lo;
};

/// Knuth's TwoSum.
template <typename Scalar>
Sum<Scalar> exact_sum(Scalar x, Scalar y) {
  const Scalar sum = x + y;
  const Scalar y_part = sum - x;
  const Scalar x_part = sum - y_part;
  return {sum, (x - x_part) + (y - y_part)};
}

/// hi + lo + dt: hi + dt exactly, lo added with one rounding, and both parts made one sum again.
template <typename Scalar>
Sum<Scalar> later_by(const Sum<Scalar>& t, Scalar dt) {
  const Sum<Scalar> sum = exact_sum(t.hi, dt);
  if (std::isinf(sum.hi)) return {sum.hi, Scalar(0)};
  return exact_sum(sum.hi, Scalar(sum.lo + t.lo));
}

}  // namespace detail

/// For double and float the same bits as the run's; for wider scalars to the working precision. Infinite
/// where the scalar has no such time.
template <typename Number>
Instant<Number> later_by(const Instant<Number>& t, const Number& dt, const Precision<Number>& precision) {
  if constexpr (std::is_same_v<Number, double>) {
    if (precision.is_float) {
      const Instant<float> start = in_floats(t);
      const detail::Sum<float> sum = detail::later_by<float>({start.hi, start.lo}, static_cast<float>(dt));
      const detail::Sum<double> wide = detail::exact_sum<double>(sum.hi, sum.lo);
      return {wide.hi, wide.lo};
    }
    const detail::Sum<double> sum = detail::later_by<double>({t.hi, t.lo}, dt);
    return {sum.hi, sum.lo};
  } else {
    return {Number(t.hi + t.lo + dt), Number(0)};
  }
}

/// The time of a query as a certified run has it: the nearest number of its scalar. `t` is the nearest
/// double; where that lies half-way between two floats, exact order decides.
inline double rounded_once(certified::ExactTiming& exact, const TimingQuery& query, double t,
                           const Precision<double>& precision) {
  if (!precision.is_float || std::isinf(t)) return t;
  const auto nearest = static_cast<float>(t);
  const double off = t - static_cast<double>(nearest);
  if (off == 0 || std::isinf(nearest)) return nearest;
  const float other = std::nextafter(nearest, off > 0 ? HUGE_VALF : 0.F);
  if (off != static_cast<double>(other) - t) return nearest;
  const std::weak_ordering side = exact.order(Moment{0, 0, query, 1}, Moment{t, 0, std::nullopt, 1});
  if (side < 0) return std::min(nearest, other);
  return side > 0 ? std::max(nearest, other) : nearest;
}

/// The latest computed time of something that can be exactly before what is computed for t: either misses its
/// moment by less than 1.1 u of the time (docs/engine.md, "Order").
inline Instant<double> latest_rival(const Instant<double>& t, const Precision<double>& precision) {
  const double u = static_cast<double>(precision.u);
  const double smallest = static_cast<double>(precision.smallest);
  return later_by(t, 8 * u * t.hi + 8 * smallest, precision);
}

/// Whether a run in the trace's scalar can have an event at a time: whether the scalar has that time at all.
template <typename Number>
bool is_a_time(const Instant<Number>& t, const Precision<Number>& precision) {
  if constexpr (std::is_same_v<Number, double>) {
    return precision.is_float ? t.hi <= static_cast<double>(std::numeric_limits<float>::max())
                              : std::isfinite(t.hi);
  } else {
    return true;
  }
}

/// The last one.
template <typename Number>
Instant<Number> last_time(const Precision<Number>& precision) {
  if (precision.is_float) return {Number(std::numeric_limits<float>::max()), Number(0)};
  return {std::numeric_limits<Number>::max(), Number(0)};
}

}  // namespace tps::check

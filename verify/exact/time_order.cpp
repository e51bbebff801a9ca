#include "verify/exact/time_order.hpp"

#include <algorithm>
#include <optional>

#include "verify/exact/double_time.hpp"
#include "verify/exact/exact_order.hpp"
#include "verify/exact/exact_verdict.hpp"
#include "verify/exact/refined_root.hpp"

namespace tps::exact {
namespace {

/// A certified verdict and what is known of the time.
struct Event {
  const TimingQuery& query;
  VerdictWithCoefficients known;
};

BoundedTime in_double(const Event& event) {
  const Coefficients& q = event.known.coefficients;
  if (at_once(event.known.verdict)) return {0, 0};
  if (!q.in_range) return {0, HUGE_VAL};
  return bounded_time(event.query.kind, event.known.verdict, q);
}

std::optional<Order> order_in_double(const Event& first, const Event& second) {
  const BoundedTime t1 = in_double(first);
  const BoundedTime t2 = in_double(second);
  const double difference = t1.t - t2.t;
  // Twice the errors: the sums and the difference are rounded, by far less than that.
  const double error = 2 * (t1.error + t2.error) + 2 * unit_roundoff * std::fabs(difference);
  if (difference > error) return Order::after;
  if (difference < -error) return Order::before;
  return std::nullopt;
}

std::optional<RefinedTime> in_double_words(const Event& event) {
  const Verdict verdict = event.known.verdict;
  if (at_once(verdict)) return RefinedTime{0, 0, 0};
  if (!event.known.coefficients.in_range) return std::nullopt;
  const double t = approximate_time(event.query.kind, verdict, event.known.coefficients);
  const std::optional<RefinedTime> once = refined_time(event.query, verdict, t);
  if (!once) return std::nullopt;
  return refined_time(event.query, verdict, once->t + once->correction);
}

std::optional<Order> order_in_double_words(const Event& first, const Event& second) {
  const std::optional<RefinedTime> t1 = in_double_words(first);
  const std::optional<RefinedTime> t2 = in_double_words(second);
  if (!t1 || !t2) return std::nullopt;
  const DoubleWord apart = two_sum(t1->t, -t2->t);
  const double corrections = t1->correction - t2->correction;
  const double low = apart.lo + corrections;
  const double difference = apart.hi + low;
  const double error =
      2 * (t1->error + t2->error) + 4 * unit_roundoff *
                                        (std::fabs(difference) + std::fabs(apart.lo) +
                                         std::fabs(t1->correction) + std::fabs(t2->correction));
  if (difference > error) return Order::after;
  if (difference < -error) return Order::before;
  return std::nullopt;
}

Order order_by_integers(const Event& first, const Event& second, Counters& counters) {
  const LiftUnits units = common_units(units_of(first.query), units_of(second.query));
  const LiftedQuadratic q1 = lifted_quadratic(first.query, units);
  const LiftedQuadratic q2 = lifted_quadratic(second.query, units);
  counters.largest_bits = std::max({counters.largest_bits, largest_bits(q1), largest_bits(q2)});
  const Sign sign = sign_of_difference(algebraic_time(first.query.kind, first.known.verdict, q1),
                                       algebraic_time(second.query.kind, second.known.verdict, q2));
  return sign == Sign::zero ? Order::equal : sign == Sign::positive ? Order::after : Order::before;
}

}  // namespace

Order time_order(const TimingQuery& first, const TimingQuery& second, Counters& counters) {
  ++counters.order.calls;
  const Event one{first, verdict_with_coefficients(first, counters)};
  const Event two{second, verdict_with_coefficients(second, counters)};
  if (!occurs(one.known.verdict) && !occurs(two.known.verdict)) return Order::none;
  if (!occurs(two.known.verdict)) return Order::before;
  if (!occurs(one.known.verdict)) return Order::after;
  if (at_once(one.known.verdict) && at_once(two.known.verdict)) return Order::equal;

  const std::optional<Order> by_doubles = order_in_double(one, two);
  if (by_doubles) return *by_doubles;
  ++counters.order.uncertain;
  const std::optional<Order> by_double_words = order_in_double_words(one, two);
  if (by_double_words) return *by_double_words;
  ++counters.order.exact;
  return order_by_integers(one, two, counters);
}

}  // namespace tps::exact

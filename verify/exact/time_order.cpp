#include "verify/exact/time_order.hpp"

#include <algorithm>
#include <optional>

#include "verify/exact/double_time.hpp"
#include "verify/exact/exact_order.hpp"
#include "verify/exact/exact_verdict.hpp"
#include "verify/exact/plane_time.hpp"
#include "verify/exact/refined_root.hpp"

namespace tps::exact {
namespace {

/// When a query is asked, the query with its certified verdict if there is one, and what its time counts.
struct Event {
  double hi, lo;
  const TimingQuery* query;
  int multiple;
  VerdictWithCoefficients known;

  bool happens() const { return query == nullptr || occurs(known.verdict); }
  bool at_start() const { return query == nullptr || at_once(known.verdict); }
};

Event event_at(double hi, double lo, const TimingQuery* query, int multiple, Counters& counters) {
  if (query == nullptr) return {hi, lo, query, multiple, {}};
  return {hi, lo, query, multiple, verdict_with_coefficients(*query, counters)};
}

std::optional<Order> order_of(double difference, double error) {
  if (difference > error) return Order::after;
  if (difference < -error) return Order::before;
  return std::nullopt;
}

BoundedTime in_double(const Event& event) {
  if (event.at_start()) return {0, 0};
  const Coefficients& q = event.known.coefficients;
  if (!q.in_range) return {0, HUGE_VAL};
  const BoundedTime time = bounded_time(event.query->kind, event.known.verdict, q);
  return {event.multiple * time.t, event.multiple * time.error};
}

std::optional<Order> order_in_double(const Event& first, const Event& second) {
  const BoundedTime t1 = in_double(first);
  const BoundedTime t2 = in_double(second);
  const DoubleWord apart = two_sum(first.hi, -second.hi);
  const double low = first.lo - second.lo;
  const double rest = apart.lo + low;
  const double starts = apart.hi + rest;
  const double times = t1.t - t2.t;
  const double difference = starts + times;
  const double rounded = std::fabs(low) + std::fabs(rest) + std::fabs(starts) + std::fabs(times);
  return order_of(difference,
                  2 * (t1.error + t2.error) + 2 * unit_roundoff * (rounded + std::fabs(difference)));
}

std::optional<RefinedTime> in_double_words(const Event& event) {
  if (event.at_start()) return RefinedTime{0, 0, 0};
  const Verdict verdict = event.known.verdict;
  if (!event.known.coefficients.in_range) return std::nullopt;
  const double t = approximate_time(event.query->kind, verdict, event.known.coefficients);
  const std::optional<RefinedTime> once = refined_time(*event.query, verdict, t);
  if (!once) return std::nullopt;
  const std::optional<RefinedTime> twice = refined_time(*event.query, verdict, once->t + once->correction);
  if (!twice) return std::nullopt;
  const int k = event.multiple;
  return RefinedTime{k * twice->t, k * twice->correction, k * twice->error};
}

std::optional<Order> order_in_double_words(const Event& first, const Event& second) {
  const std::optional<RefinedTime> t1 = in_double_words(first);
  const std::optional<RefinedTime> t2 = in_double_words(second);
  if (!t1 || !t2) return std::nullopt;
  const DoubleWord starts = two_sum(first.hi, -second.hi);
  const DoubleWord times = two_sum(t1->t, -t2->t);
  const DoubleWord high = two_sum(starts.hi, times.hi);
  const double low =
      ((starts.lo + times.lo) + high.lo) + ((first.lo - second.lo) + (t1->correction - t2->correction));
  const double difference = high.hi + low;
  const double absolute = std::fabs(starts.lo) + std::fabs(times.lo) + std::fabs(high.lo) +
                          std::fabs(first.lo) + std::fabs(second.lo) + std::fabs(t1->correction) +
                          std::fabs(t2->correction);
  return order_of(difference, 2 * (t1->error + t2->error) + 8 * unit_roundoff * absolute +
                                  2 * unit_roundoff * std::fabs(difference));
}

/// The last bit of any of the four starts.
int unit_of_starts(const Event& first, const Event& second) {
  return std::min({unit_of(first.hi), unit_of(first.lo), unit_of(second.hi), unit_of(second.lo)});
}

/// The units that serve the queries whose times count; nothing where none does.
std::optional<LiftUnits> units_of_queries(const Event& first, const Event& second) {
  std::optional<LiftUnits> units;
  for (const Event* event : {&first, &second}) {
    if (event->at_start()) continue;
    const LiftUnits own = units_of(*event->query);
    units = units ? common_units(*units, own) : own;
  }
  return units;
}

AlgebraicTime algebraic_time_of(const Event& event, const std::optional<LiftUnits>& units,
                                Counters& counters) {
  if (event.at_start()) return {1, 0, 0, 0, 0};
  if (event.query->kind == Kind::plane) return plane_time(*event.query, *units);
  const LiftedQuadratic quadratic = lifted_quadratic(*event.query, *units);
  counters.largest_bits = std::max(counters.largest_bits, largest_bits(quadratic));
  return algebraic_time(event.query->kind, event.known.verdict, quadratic);
}

Order order_by_integers(const Event& first, const Event& second, Counters& counters) {
  const std::optional<LiftUnits> units = units_of_queries(first, second);
  const int of_starts = unit_of_starts(first, second);
  const int of_times = units ? units->length - units->speed : of_starts;
  const int unit = std::min(of_times, of_starts);
  const Integer scale = Integer(1) << static_cast<unsigned>(of_times - unit);
  const Integer offset =
      lifted(first.hi, unit) + lifted(first.lo, unit) - lifted(second.hi, unit) - lifted(second.lo, unit);
  counters.largest_bits = std::max(counters.largest_bits, bits_of(offset));
  const AlgebraicTime t1 = stretched(algebraic_time_of(first, units, counters), scale * first.multiple);
  const AlgebraicTime t2 = stretched(algebraic_time_of(second, units, counters), scale * second.multiple);
  const Sign sign = sign_of_difference(t1, t2, offset);
  return sign == Sign::zero ? Order::equal : sign == Sign::positive ? Order::after : Order::before;
}

Order order(const Event& first, const Event& second, Counters& counters) {
  ++counters.order.calls;
  if (!first.happens() && !second.happens()) return Order::none;
  if (!second.happens()) return Order::before;
  if (!first.happens()) return Order::after;
  const bool same_start = first.hi == second.hi && first.lo == second.lo;
  if (same_start && first.at_start() && second.at_start()) return Order::equal;

  const std::optional<Order> by_doubles = order_in_double(first, second);
  if (by_doubles) return *by_doubles;
  ++counters.order.uncertain;
  const std::optional<Order> by_double_words = order_in_double_words(first, second);
  if (by_double_words) return *by_double_words;
  ++counters.order.exact;
  return order_by_integers(first, second, counters);
}

}  // namespace

Order time_order(const TimingQuery& first, const TimingQuery& second, Counters& counters) {
  return order(event_at(0, 0, &first, 1, counters), event_at(0, 0, &second, 1, counters), counters);
}

Order moment_order(const Moment& first, const Moment& second, Counters& counters) {
  const auto event = [&](const Moment& moment) {
    return event_at(moment.hi, moment.lo, moment.query ? &*moment.query : nullptr, moment.multiple, counters);
  };
  return order(event(first), event(second), counters);
}

KnownMoment known_moment(const Moment& moment, Counters& counters) {
  return {moment,
          moment.query ? verdict_with_coefficients(*moment.query, counters) : VerdictWithCoefficients{}};
}

Order moment_order(const KnownMoment& first, const KnownMoment& second, Counters& counters) {
  const auto event = [](const KnownMoment& moment) {
    return Event{moment.hi, moment.lo, moment.query ? &*moment.query : nullptr, moment.multiple,
                 moment.known};
  };
  return order(event(first), event(second), counters);
}

}  // namespace tps::exact

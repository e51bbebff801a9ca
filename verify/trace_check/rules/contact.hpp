// Rule contact: at its event a pair is at its limit and moves the right way, eqs. (1) and (2).
#pragma once

#include "reference/equations/square_root.hpp"
#include "reference/version.hpp"
#include "verify/trace_check/bodies_now.hpp"
#include "verify/trace_check/context.hpp"
#include "verify/trace_check/rules/direction.hpp"
#include "verify/trace_check/rules/limit_flight.hpp"
#include "verify/trace_check/rules/order.hpp"
#include "verify/trace_check/rules/readings.hpp"
#include "verify/trace_check/step_as_case.hpp"

namespace tps::check {

/// The limit at which a collision happens, in the numbers of the trace; nothing where the pair has none.
template <typename Number>
std::optional<LimitAsked<Work<Number>>> limit_of(const Model<Number>& model, const EventLine<Number>& event) {
  using W = Work<Number>;
  const PairRules<Number>& rules = model.rules.of(event.i, event.j);
  if (event.kind == Kind::rebound) {
    if (!rules.blocks) return std::nullopt;
    return LimitAsked<W>{false, W(rules.inner), false};
  }
  if (!rules.can_tether) return std::nullopt;
  return LimitAsked<W>{true, W(rules.outer), model.responded(event.i, event.j, true)};
}

/// A pair on its way to the limit where it collides, as three rules ask for it.
template <typename Number>
struct Arrival {
  LimitFlight<Number> flight;  ///< until the event
  std::optional<CertifiedTime> certified;

  bool is(int i, int j) const { return flight.i == i && flight.j == j; }
};

/// Nothing where the pair has no such limit.
template <typename Number>
std::optional<Arrival<Number>> arrival_of(const Context<Number>& c, const EventLine<Number>& event) {
  const auto limit = limit_of(c.model, event);
  if (!limit) return std::nullopt;
  const Vec<Number> image = c.model.nearest_image(event.i, event.j, event.t);
  const PairFlight<Number> pair = pair_flight(c.model, event.i, event.j, image);
  const auto q = quadratic_of(pair.relative(), limit->L, c.u(), c.timing, c.scale());
  Arrival<Number> arrival{{event.i, event.j, pair, *limit, q, elapsed(pair.start, event.t)}, {}};
  if constexpr (std::is_same_v<Number, double>) {
    if (c.certified()) arrival.certified = certified_time(c, pair, *limit);
  }
  return arrival;
}

namespace detail {

/// Certified timing: the time is the exact root, rounded once; a clock that has passed it stays.
inline bool at_certified_time(const Context<double>& c, const EventLine<double>& event,
                              const PairFlight<double>& pair, const LimitAsked<long double>& asked,
                              const CollisionTime<double>& answer) {
  using W = long double;
  const bool counts = !asked.responded || answer.verdict == TimingVerdict::hit ||
                      answer.verdict == TimingVerdict::turning ||
                      (asked.outer && c.semantics >= kDirectedSemantics);
  if (!answer.t || !counts) return false;
  const W t = W(*answer.t) * (asked.responded && answer.verdict == TimingVerdict::turning ? 2 : 1);
  const W dt = elapsed(pair.start, event.t);
  // A float run's times are those of double, rounded once more.
  const W rounding =
      c.time_error(event.t) +
      (c.model.precision.is_float ? half_ulp(c, t) * W(1.001) + c.model.precision.smallest : W(0));
  if (std::fabs(dt - t) <= rounding) return true;
  const bool clock_had_passed = event.t == c.model.now && dt > t;
  return clock_had_passed && dt - t <= W(2.5) * c.u() * std::fabs(W(event.t.hi)) + rounding;
}

/// The residual of the time, where the pair neither grazes nor starts at its limit, in units of the rounding
/// that is to be expected: that of the time and that of the distance.
template <typename Number>
void add_time_residual(const Context<Number>& c, const EventLine<Number>& event,
                       const Quadratic<Work<Number>>& q, const Work<Number>& dt) {
  using W = Work<Number>;
  const auto since_start = [&](int i) {
    return !c.model.fixed(i) && c.model.flight(i).since == Instant<Number>{};
  };
  if (since_start(event.i) || since_start(event.j) || c.tally.seen_before(as_double(dt))) return;
  const bool outer = event.kind != Kind::rebound;
  const W D = q.discriminant();
  if (!(q.a > W(0)) || D < q.h * q.h / W(4) || dt <= W(0)) return;
  const W root = square_root(D);
  const W t = outer ? (q.h > W(0) ? W(-q.c / (q.h + root)) : W((root - q.h) / q.a)) : W(q.c / (root - q.h));
  if (t <= W(0)) return;
  const W ulp = c.u() * t;
  const W rounding = ulp + (c.certified() ? W(0) : W(q.q_error / (c.scale() * W(16) * root)));
  // A pair that is all but at its limit: where it meets it is rounding of places, of which an ulp of the time
  // is no measure.
  if (ulp * W(1 << 20) < rounding) return;
  c.tally.residual(Quantity::time, as_double(t), as_double(W((dt - t) / rounding)),
                   as_double(W(ulp / rounding)));
}

}  // namespace detail

template <typename Number>
void judge_contact(const Context<Number>& c, const EventLine<Number>& event,
                   const std::optional<Arrival<Number>>& arrival) {
  using W = Work<Number>;
  using std::abs;
  const Model<Number>& model = c.model;
  const bool outer = event.kind != Kind::rebound;
  const char* which = outer ? "outer" : "inner";
  c.tally.demand(Rule::contact, arrival.has_value(), [&](Finding& f) {
    f.message = fmt::format("{} at the {} limit, which the pair {} does not have", name(event.kind), which,
                            c.pair(event.i, event.j));
  });
  if (!arrival || model.groups.together(event.i, event.j)) return;
  const PairFlight<Number>& pair = arrival->flight.pair;
  const LimitAsked<W>& limit = arrival->flight.asked;
  // In a periodic box it may be another image that it meets (D28).
  const bool other_image =
      model.edges && detail::exact_sign(pair.u_i, pair.u_j, pair.v_i, pair.v_j, pair.image, pair.edges) < 0;
  if (!outer && model.responded(event.i, event.j, false) && !other_image) {
    c.tally.demand(Rule::contact, false, [&](Finding& f) {
      f.message =
          fmt::format("{} has rebounded already, and neither of the two has changed its velocity since",
                      c.pair(event.i, event.j));
      f.equation = "(2)";
      f.reading = reading_of_repeat(c, event);
    });
    return;
  }
  const Quadratic<W>& q = arrival->flight.q;
  const W& dt = arrival->flight.dt;
  const bool image_is_open =
      model.edges && model.images_are_open(limit.L, c.time_error(event.t) * length(q.v));
  if (image_is_open || q.blur_error >= limit.L * limit.L) {
    for (const Rule rule : {Rule::contact, Rule::earliest, Rule::bounds}) {
      c.tally.cannot_tell(rule, [&] {
        return image_is_open
                   ? fmt::format("where {} fly so far while the time is rounded that it may be another image",
                                 c.pair(event.i, event.j))
                   : fmt::format("where the distance of {} is uncertain by {}, its limit being {}",
                                 c.pair(event.i, event.j), shown(pair.blur), shown(limit.L));
      });
    }
    return;
  }
  const auto describe = [&](Finding& f) {
    const W distance = length(q.r + dt * q.v);
    const Due<W> expected = due(q, limit);
    std::string after = shown(dt);
    std::string when = "never gets there";
    if (!expected.must_be_none) {
      const bool early = dt < expected.earliest;
      auto [found, bound] = told_apart(dt, early ? expected.earliest : expected.latest);
      after = found;
      when = fmt::format("is due there {} than {}", early ? "not earlier" : "not later", bound);
    }
    const auto [at, L] = told_apart(distance, limit.L);
    f.message = fmt::format("{} is at distance {} after {}, {} its {} limit {}; on its straight lines it {}",
                            c.pair(event.i, event.j), at, after, distance > limit.L ? "beyond" : "within",
                            which, L, when);
    f.equation = "(2)";
    f.replay = replay_of_time(pair, outer, limit.L, model.scene.dimension);
  };
  if constexpr (std::is_same_v<Number, double>) {
    if (c.certified()) {
      const CollisionTime<double> answer =
          arrival->certified ? arrival->certified->answer
                             : c.exact.answer(timing_query(pair, outer, static_cast<double>(limit.L)));
      c.tally.demand(Rule::contact, detail::at_certified_time(c, event, pair, limit, answer), describe);
      detail::add_time_residual(c, event, q, dt);
      return;
    }
  }
  const Due<W> expected = due(q, limit);
  const W slack = c.time_error(event.t);
  const bool in_time =
      !expected.must_be_none && dt >= expected.earliest - slack && dt <= expected.latest + slack;
  const W ulps = W(6) * c.scale() * abs(q.at(dt)) / q.q_error;
  const bool at_root = ulps <= W(6) * c.scale();
  // At another root of q, the distance is right and the time is not.
  if (in_time || !at_root)
    c.tally.within(Rule::contact, in_time && !at_root ? 0.0 : as_double(ulps), 6, describe);
  else
    c.tally.demand(Rule::contact, false, [&](Finding& f) {
      describe(f);
      // The smaller of two roots behind the start: where the pair has just been pulled, that is at once.
      if (outer && (dt < expected.earliest || expected.must_be_none)) f.reading = readings::kLiteralRoot;
    });
  detail::add_time_residual(c, event, q, dt);
}

/// At an inner limit a pair approaches, at an outer one it separates; a vanishing v_n has the sign of
/// rounding: that of the positions turns the axis, and while the time is late v_n grows by a of it.
template <typename Number>
void judge_approach(const Context<Number>& c, const EventLine<Number>& event,
                    const LimitFlight<Number>& flight, const BodiesNow<Number>& b) {
  using W = Work<Number>;
  const bool outer = event.kind != Kind::rebound;
  const W v_n = b.v_n();
  const W wrong_way = outer ? W(-v_n) : v_n;
  const Quadratic<W>& q = flight.q;
  const W of_time =
      (q.h_error + q.a * q.t_error * flight.dt + q.q_error * length(q.v) / q.L) / (c.scale() * b.distance());
  const W unit = unit_of_v_n(c, b) + of_time / W(kRoundingsOfApproach);
  const double off = std::max(0.0, as_double(W(wrong_way / unit)));
  c.tally.within(Rule::contact, off, kRoundingsOfApproach, [&](Finding& f) {
    f.message = fmt::format("{} {} at its {} limit, v_n = {}", c.pair(b.i, b.j),
                            outer ? "approaches" : "separates", outer ? "outer" : "inner", shown(v_n));
    f.equation = "(4)";
  });
}

}  // namespace tps::check

// A pair on its way to one of its limits, which rules earliest and bounds judge.
#pragma once

#include "verify/trace_check/context.hpp"
#include "verify/trace_check/pair_flight.hpp"
#include "verify/trace_check/step_as_case.hpp"

namespace tps::check {

/// Until a moment.
template <typename Number>
struct LimitFlight {
  int i, j;
  PairFlight<Number> pair;
  LimitAsked<Work<Number>> asked;
  Quadratic<Work<Number>> q;
  Work<Number> dt;

  const char* limit() const { return asked.outer ? "outer" : "inner"; }
};

/// What exact arithmetic says of a pair at a limit.
struct CertifiedTime {
  TimingQuery query;
  CollisionTime<double> answer;
  exact::VerdictWithCoefficients known;
};

/// Nothing where the numbers of the pair are none of the scalar's.
inline std::optional<CertifiedTime> certified_time(const Context<double>& c, const PairFlight<double>& pair,
                                                   const LimitAsked<long double>& asked) {
  const TimingQuery query = timing_query(pair, asked.outer, static_cast<double>(asked.L));
  if (!valid(query)) return std::nullopt;
  const exact::KnownTime time = c.exact.known_answer(query);
  return CertifiedTime{query, time.answer, time.known};
}

namespace detail {

template <typename Number>
void say_about(const Context<Number>& c, const LimitFlight<Number>& flight, Finding& f) {
  f.particles = {c.model.id(flight.i), c.model.id(flight.j)};
  f.equation = "(2)";
  f.replay = replay_of_time(flight.pair, flight.asked.outer, flight.asked.L, c.model.scene.dimension);
}

}  // namespace detail

}  // namespace tps::check

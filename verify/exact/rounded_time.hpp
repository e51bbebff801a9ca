// The correctly rounded time of a timing query.
#pragma once

#include <optional>
#include <span>

#include "verify/exact/counters.hpp"
#include "verify/exact/exact_verdict.hpp"
#include "verify/exact/timing_query.hpp"
#include "verify/exact/verdict.hpp"

namespace tps::exact {

/// The certified answer to a timing query: t is infinity where the time exceeds every double.
using TimingAnswer = CollisionTime<double>;

/// Exact verdict, and the double nearest to the exact time (ties to even, overflow to infinity, subnormals
/// and underflow to zero as IEEE 754 rounds).
///
/// REQUIRES valid(query). Laws:
///   (1) the time is the rounding of the real number, whatever stage found it;
///   (2) exchanging A and B changes nothing;
///   (3) multiplying lengths by 2^k and velocities by 2^m multiplies t by 2^(k−m) while all are normal
///   doubles.
TimingAnswer rounded_time(const TimingQuery& query, Counters& counters);

/// rounded_time() of each query, four at a time where the processor has registers of four doubles (AVX2).
/// What stage 1 leaves open is asked alone: of queries that mostly graze, this is not faster. REQUIRES as
/// many answers as queries, each query valid. Laws:
///   (1) answers and counts are those of rounded_time(), on every processor and in every order of the
///   queries.
void rounded_times(std::span<const TimingQuery> queries, std::span<TimingAnswer> answers, Counters& counters);

/// The same with the verdict that the time is of, for who asks for both.
struct KnownTime {
  TimingAnswer answer;
  VerdictWithCoefficients known;
};
KnownTime known_time(const TimingQuery& query, Counters& counters);

/// The same by integers alone: what the fast path is compared with.
TimingAnswer rounded_time_by_integers(const TimingQuery& query, Counters& counters);

}  // namespace tps::exact

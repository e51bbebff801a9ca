// What `--timing certified` asks: the exact answers of verify/exact/, in the engine's words.
#pragma once

#include "reference/engine/timing.hpp"
#include "verify/exact/rounded_time.hpp"
#include "verify/exact/time_order.hpp"

namespace tps::certified {

/// Owns the counters of every filter: one a run.
class ExactTiming final : public CertifiedTiming {
 public:
  CollisionTime<double> answer(const TimingQuery& query) override;
  std::weak_ordering order(const Moment& first, const Moment& second) override;
  /// The answer with the verdict that it is of.
  exact::KnownTime known_answer(const TimingQuery& query) { return exact::known_time(query, counters_); }
  /// For moments that are compared more than once.
  exact::KnownMoment known(const Moment& moment) { return exact::known_moment(moment, counters_); }
  std::weak_ordering order(const exact::KnownMoment& first, const exact::KnownMoment& second);
  const TimingCounters& counters() const override { return counters_; }

 private:
  TimingCounters counters_;
};

}  // namespace tps::certified

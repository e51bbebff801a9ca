// What `--timing certified` asks: the exact answers of verify/exact/, in the engine's words.
#pragma once

#include "reference/engine/timing.hpp"

namespace tps::certified {

/// Owns the counters of every filter: one a run.
class ExactTiming final : public CertifiedTiming {
 public:
  CollisionTime<double> answer(const TimingQuery& query) override;
  std::weak_ordering order(const Moment& first, const Moment& second) override;
  const TimingCounters& counters() const override { return counters_; }

 private:
  TimingCounters counters_;
};

}  // namespace tps::certified

// How a run answers eq. (2), and what it needs for certified answers. The reference computes none of those
// itself: whoever starts a run with certified timing passes in something that does.
#pragma once

#include <compare>

#include "reference/engine/timing_counters.hpp"
#include "reference/equations/timing_query.hpp"
#include "reference/equations/timing_verdict.hpp"

namespace tps {

enum class Timing {
  paper,      ///< coefficients and quotients as eq. (2) prints them (eq2_paper_time.hpp)
  stable,     ///< the formulas that do not cancel (eq2_collision_time.hpp)
  certified,  ///< what real arithmetic gives on the stored states: verdict, rounded time, order
};

/// Answers timing queries as real arithmetic would, and counts what that took.
class CertifiedTiming {
 public:
  virtual ~CertifiedTiming() = default;
  /// Exact verdict, and the double nearest to the exact time. REQUIRES valid(query).
  virtual CollisionTime<double> answer(const TimingQuery& query) = 0;
  /// Exact order; a query without an event comes after everything. REQUIRES finite starts, valid queries.
  virtual std::weak_ordering order(const Moment& first, const Moment& second) = 0;
  virtual const TimingCounters& counters() const = 0;
};

/// REQUIRES `certifier` for Timing::certified; it must outlive the run.
struct TimingChoice {
  Timing timing = Timing::stable;
  CertifiedTiming* certifier = nullptr;
};

}  // namespace tps

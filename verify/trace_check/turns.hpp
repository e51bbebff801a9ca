// Whose turn it is: what orders the events of a run, and the events so far in that order.
#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "reference/equations/timing_query.hpp"
#include "verify/certified/exact_timing.hpp"
#include "verify/trace_check/line.hpp"

namespace tps::check {

/// What decides when something comes: its exact moment under certified timing, else its computed time; at one
/// time its rank and its ids.
template <typename Number>
struct Turn {
  Instant<Number> t;             ///< computed, which is what a trace records
  std::optional<Moment> moment;  ///< under certified timing
  int rank = check::rank(Kind::rebound);
  int first = -1, second = -1;  ///< particles; of a body twice its first one, of what concerns nobody −1
};

inline Moment known_moment(const Instant<double>& t) {
  return {t.hi, t.lo, std::nullopt, 1};
}

/// How many steps a run has made. The nodes of one restitution are one step: nothing is asked between them.
using StepNumber = std::uint64_t;

/// The steps of a run by their turns. Of the steps behind any given one the latest turn is at hand, since
/// only steps that no later one exceeds are kept.
template <typename Number>
class Turns {
 public:
  explicit Turns(certified::ExactTiming& exact) : exact_(exact) {}

  /// REQUIRES both with moments, or both without.
  std::weak_ordering order(const Turn<Number>& a, const Turn<Number>& b) const {
    const std::weak_ordering by_time = order_in_time(a, b);
    if (by_time != 0) return by_time;
    return std::tie(a.rank, a.first, a.second) <=> std::tie(b.rank, b.first, b.second);
  }
  std::weak_ordering order_in_time(const Turn<Number>& a, const Turn<Number>& b) const {
    if (a.moment && b.moment) return exact_.order(*a.moment, *b.moment);
    if (a.t < b.t) return std::weak_ordering::less;
    return b.t < a.t ? std::weak_ordering::greater : std::weak_ordering::equivalent;
  }

  void happened(StepNumber step, const Turn<Number>& turn) {
    while (!kept_.empty() && order(turn, kept_.back().turn) >= 0) kept_.pop_back();
    kept_.push_back({step, turn});
  }
  /// The latest turn of the steps behind `step`; null if there are none.
  const Turn<Number>* latest_since(StepNumber step) const {
    const auto found = std::upper_bound(kept_.begin(), kept_.end(), step,
                                        [](StepNumber s, const Past& past) { return s < past.step; });
    return found == kept_.end() ? nullptr : &found->turn;
  }
  /// Where a broken trace goes back in time nothing before says anything about what follows.
  void forget() { kept_.clear(); }

 private:
  struct Past {
    StepNumber step;
    Turn<Number> turn;
  };
  certified::ExactTiming& exact_;
  std::vector<Past> kept_;  ///< steps ascending, turns descending
};

}  // namespace tps::check

// Whose turn it is: what orders the events of a run, and the events so far in that order.
#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "reference/equations/timing_query.hpp"
#include "verify/certified/exact_timing.hpp"
#include "verify/trace_check/computed_time.hpp"
#include "verify/trace_check/line.hpp"

namespace tps::check {

/// What decides when something comes: its exact moment under certified timing, else its computed time; at one
/// time its rank and its ids.
template <typename Number>
struct Turn {
  Instant<Number> t;                         ///< computed, which is what a trace records
  std::optional<exact::KnownMoment> moment;  ///< under certified timing
  int rank = kRankOfPair;
  int first = -1, second = -1;  ///< particles; of a body twice its first one, of what concerns nobody −1
};

inline exact::KnownMoment known_moment(const Instant<double>& t) {
  return {{t.hi, t.lo, std::nullopt, 1}};
}

/// How many steps a run has made. The nodes of one restitution are one step: nothing is asked between them.
using StepNumber = std::uint64_t;

template <typename Number>
struct PastTurn {
  StepNumber step;
  Turn<Number> turn;
};

/// Where a segment of a trace begins (docs/check.md, "Segments"): steps up to `step` are of before.
template <typename Number>
struct Border {
  StepNumber step = 0;
  Instant<Number> t;       ///< of the last event before it
  Instant<Number> behind;  ///< what is computed to be later than this is exactly later than all of before
  bool knows_before = false;
  std::vector<PastTurn<Number>> before;  ///< steps ascending; those of before that can matter
};

/// The steps of a run by their turns. Of the steps behind any given one the latest turn is at hand, since
/// only steps that no later one exceeds are kept.
template <typename Number>
class Turns {
 public:
  explicit Turns(certified::ExactTiming& exact, std::optional<Border<Number>> border = std::nullopt)
      : exact_(exact), border_(std::move(border)) {}

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

  /// Whether what waits since a step has waited since before the segment.
  bool is_of_before(StepNumber since) const { return border_ && since <= border_->step; }
  /// The latest turn behind `since` that can be behind `turn`; null if there is none. What happened before
  /// the segment is gone through only where it is within rounding of `turn`, which is rare; where it is not
  /// known, that is remembered.
  const Turn<Number>* latest_since(StepNumber since, const Turn<Number>& turn) const {
    const Turn<Number>* latest = latest_since(since);
    if (!is_of_before(since) || is_behind_border(turn)) return latest;
    needed_before_ = needed_before_ || !border_->knows_before;
    for (const Past& past : border_->before) {
      if (past.step > since && (latest == nullptr || order(past.turn, *latest) > 0)) latest = &past.turn;
    }
    return latest;
  }
  /// Whether a verdict hung on what happened before the segment, and that was not known.
  bool needed_before() const { return needed_before_; }

  /// The border of a segment that begins behind `step`, at t.
  Border<Number> border_here(StepNumber step, const Instant<Number>& t,
                             const Precision<Number>& precision) const {
    Border<Number> border{step, t, farthest_rival(t, precision), true, {}};
    if (border_) border.before = border_->before;
    border.before.insert(border.before.end(), kept_.begin(), kept_.end());
    std::erase_if(border.before,
                  [&](const Past& past) { return farthest_rival(past.turn.t, precision) < t; });
    return border;
  }
  /// Where what was before is not known.
  static Border<Number> unknown_border(const Instant<Number>& t, const Precision<Number>& precision) {
    return {0, t, farthest_rival(t, precision), false, {}};
  }

  /// Where a broken trace goes back in time nothing before says anything about what follows.
  void forget() {
    kept_.clear();
    if (border_) border_->before.clear();
  }

 private:
  using Past = PastTurn<Number>;

  static Instant<Number> farthest_rival(const Instant<Number>& t, const Precision<Number>& precision) {
    if constexpr (std::is_same_v<Number, double>) return latest_rival(t, precision);
    return t;  // never certified
  }
  bool is_behind_border(const Turn<Number>& turn) const {
    if constexpr (std::is_same_v<Number, double>) {
      if (turn.moment) return exact_.order(*turn.moment, known_moment(border_->behind)) > 0;
    }
    return border_->t < turn.t;
  }

  certified::ExactTiming& exact_;
  std::vector<Past> kept_;  ///< steps ascending, turns descending; of this segment
  std::optional<Border<Number>> border_;
  mutable bool needed_before_ = false;
};

}  // namespace tps::check

// How Checker judges what a run left waiting at its end. Included by the instantiating sources only.
#pragma once

#include "verify/trace_check/checker.hpp"
#include "verify/trace_check/paths.hpp"

namespace tps::check {

template <typename Number>
void Checker<Number>::take(const EndLine<Number>& end) {
  const Context<Number>& c = context_;
  if (ended_) {
    tally_.demand(Rule::end, false, [](Finding& f) { f.message = "a second end"; });
    return;
  }
  ended_ = true;
  model_.asked = end.t;
  judge_end(c, end);
  judge_drag_end(c, end);
  judge_parted(c, "the run ends");
  earliest_held_ = bounds_held_ = true;
  judge_until_end(model_.now, Until::last_event);
  if (end.reason == "duration" && !(end.t < model_.now)) judge_until_end(end.t, Until::duration);
  if (end.reason == "no_more_events" && !model_.scene.drag)
    judge_until_end(last_time(model_.precision), Until::ever);
  if (end.reason == "no_more_events" && model_.scene.drag && !(last_clock(c) < model_.now))
    judge_until_end(last_clock(c), Until::duration);
  if (earliest_held_) tally_.pass(Rule::earliest);
  if (bounds_held_) tally_.pass(Rule::bounds);
}

/// Up to the last event everybody is asked who can have met somebody since; from there on, until the duration
/// or for ever, everybody whose straight path comes near another's.
template <typename Number>
void Checker<Number>::judge_until_end(const Instant<Number>& end, Until until) {
  std::vector<LeftWaiting> left;
  Happening<Number> happening;
  happening.t = end;
  happening.until = until;
  happening.left = &left;
  if (until == Until::last_event) {
    renew_anchors(end, happening);
    for (int i = 0; i < model_.size(); ++i) judge_meetings(i, end, happening);
    for (int i = 0; i < model_.size(); ++i) judge_at_walls(i, end, happening);
    return;
  }
  judge_known_at_end(context_, end, until, left);
  judge_ahead(end, happening);
  for (int i = 0; i < model_.size(); ++i) judge_at_walls(i, end, happening);
  judge_left(end, left);
}

/// A particle from now on. Its place has the roundings of the one where it started and of the way since.
template <typename Number>
Path Checker<Number>::path_of(int i) const {
  using std::abs;
  const Flight<Number>& f = model_.flight(i);
  const Vec<W> x = model_.position(i, model_.now);
  const W way = abs(elapsed(f.since, model_.now)) * largest(widened<W>(f.velocity));
  const W coordinates = largest(x) + largest(widened<W>(f.position)) + way;
  Path path{i, {}, {}, as_double(W(W(16) * model_.precision.u * coordinates + model_.blur(i)))};
  for (std::size_t k = 0; k < 3; ++k) {
    path.position[k] = static_cast<double>(x[k]);
    path.velocity[k] = static_cast<double>(f.velocity[k]);
  }
  return path;
}

template <typename Number>
void Checker<Number>::judge_ahead(const Instant<Number>& until, const Happening<Number>& happening) {
  const auto judge = [&](int i, int j) {
    const bool held = earliest_held_ && bounds_held_;
    earliest_held_ = bounds_held_ = true;
    judge_meeting(i, j, until, happening);
    const bool good = earliest_held_ && bounds_held_;
    earliest_held_ = earliest_held_ && held;
    bounds_held_ = bounds_held_ && held;
    return good;
  };
  if (model_.edges && happening.until != Until::ever) {
    // To the end of a duration it is not far, and a straight path would have an image behind every edge.
    renew_anchors(until, happening);
    for (int i = 0; i < model_.size(); ++i) judge_meetings(i, until, happening);
    return;
  }
  if (model_.edges) {
    for (int i = 0; i < model_.size(); ++i) {
      for (int j = i + 1; j < model_.size(); ++j) judge_meeting(i, j, until, happening);
    }
    return;
  }
  std::vector<Path> paths;
  for (const int i : neighbours_.short_reaching()) paths.push_back(path_of(i));
  // Exact moments may be behind the end that their computed times are not.
  const double u = as_double(model_.precision.u);
  const double duration = as_double(elapsed(model_.now, until)) + 32 * u * static_cast<double>(until.hi);
  Paths(std::move(paths), neighbours_.reach()).each_near_pair(duration, judge);
  for (const int i : neighbours_.far_reaching()) {
    for (int j = 0; j < model_.size(); ++j) judge_meeting(i, j, until, happening);
  }
  for (int i = 0; i < model_.size(); ++i) {
    for (const int j : model_.tethers[Model<Number>::at(i)]) judge_meeting(i, j, until, happening);
    for (const int j : permanent_[Model<Number>::at(i)]) judge_meeting(i, j, until, happening);
  }
}

/// A certified run ends at its duration when the computed time of what is exactly next is behind it: what is
/// exactly later is left, even if its computed time is not behind the end.
template <typename Number>
void Checker<Number>::judge_left(const Instant<Number>& end, std::vector<LeftWaiting>& left) {
  if constexpr (std::is_same_v<Number, double>) {
    const auto clock_at = [&](const LeftWaiting& item) { return std::max(item.turn.t, model_.now); };
    const Turn<double>* next_behind = nullptr;
    for (const LeftWaiting& item : left) {
      if (end < clock_at(item) && (!next_behind || turns_.order(item.turn, *next_behind) < 0))
        next_behind = &item.turn;
    }
    for (const LeftWaiting& item : left) {
      if (end < clock_at(item) || (next_behind && turns_.order(item.turn, *next_behind) > 0)) continue;
      Told told;
      const int i = item.turn.first, j = item.turn.second;
      if (i >= 0 && i != j) {
        told = told_of(i, j);
        if (!told.say(Told::overdue, item.outer)) continue;
        note_told(i, j, told);
      }
      earliest_held_ = false;
      tally_.demand(Rule::earliest, false, item.describe);
    }
  }
}

}  // namespace tps::check

// Where Checker begins and ends (docs/check.md, "Segments"). Included by the instantiating sources only.
#pragma once

#include "verify/trace_check/checker.hpp"

namespace tps::check {

template <typename Number>
std::optional<Border<Number>> Checker<Number>::border_of(const std::optional<TakenUp<Number>>& taken_up,
                                                         const Precision<Number>& precision) {
  if (!taken_up) return std::nullopt;
  if (taken_up->waits != nullptr) return taken_up->waits->border;
  return Turns<Number>::unknown_border(instant_in_state<Number>(taken_up->state.last_event), precision);
}

template <typename Number>
bool Checker<Number>::ends_segment() {
  if (ended_ || !state_holds_ || !is_whole_in_state(context_)) return false;
  judge_until_end(model_.now, Until::last_event);
  return std::ranges::all_of(told_, [](const SmallMap<int, Told>& told) { return told.empty(); });
}

template <typename Number>
Waits<Number> Checker<Number>::waits() const {
  Waits<Number> waits = waits_;
  waits.border = turns_.border_here(waits_.step, model_.now, model_.precision);
  return waits;
}

}  // namespace tps::check

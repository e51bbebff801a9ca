// The answers to a timing query (semantics §1): which case of the quadratic of eq. (2) it is, and when.
// Shared by every way of computing them, so that they speak one language (docs/eq2.md).
#pragma once

#include <optional>
#include <string_view>

namespace tps {

/// Which case of the quadratic a timing query fell into. h = r·v (of a plane n·v), D = h² − ac.
enum class TimingVerdict {
  static_pair,    ///< v = 0: the distance does not change
  receding,       ///< blocking, h ≥ 0: not approaching
  overlap,        ///< blocking, approaching from inside the limit: at once
  contact,        ///< blocking, approaching from exactly the limit: at once
  miss,           ///< blocking, D < 0: passes by
  tangent,        ///< blocking, D = 0: touches without approach, the impulse would be zero
  hit,            ///< reaches the limit at t
  taut,           ///< tethering, separating from exactly the limit: at once
  overstretched,  ///< tethering, separating from outside the limit: at once
  turning,        ///< tethering, outside and never back inside by itself: pulled where it turns outward
};

/// The name of a verdict in files and reports.
constexpr std::string_view name(TimingVerdict verdict) {
  constexpr std::string_view names[] = {"static",  "receding", "overlap", "contact",       "miss",
                                        "tangent", "hit",      "taut",    "overstretched", "turning"};
  return names[static_cast<int>(verdict)];
}

/// Whether the verdict has a time.
constexpr bool occurs(TimingVerdict verdict) {
  return verdict != TimingVerdict::static_pair && verdict != TimingVerdict::receding &&
         verdict != TimingVerdict::miss && verdict != TimingVerdict::tangent;
}

/// Whether that time is 0.
constexpr bool at_once(TimingVerdict verdict) {
  return verdict == TimingVerdict::overlap || verdict == TimingVerdict::contact ||
         verdict == TimingVerdict::taut || verdict == TimingVerdict::overstretched;
}

/// The answer to a timing query: `t` ≥ 0 from now, in units of time; absent where there is no event.
template <typename Scalar>
struct CollisionTime {
  TimingVerdict verdict;
  std::optional<Scalar> t;
};

}  // namespace tps

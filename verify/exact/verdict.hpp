// Which case of the quadratic a timing query is, decided from the signs of h, c and D by one table that all
// stages share.
#pragma once

#include <optional>
#include <string_view>

#include "verify/exact/timing_query.hpp"

namespace tps::exact {

/// Verdicts of semantics §1. Named as in files; the same names as the reference's, but no code of it.
enum class Verdict {
  static_pair,
  receding,
  overlap,
  contact,
  miss,
  tangent,
  hit,
  taut,
  overstretched,
  turning,
};

constexpr std::string_view name(Verdict verdict) {
  constexpr std::string_view names[] = {"static",  "receding", "overlap", "contact",       "miss",
                                        "tangent", "hit",      "taut",    "overstretched", "turning"};
  return names[static_cast<int>(verdict)];
}

/// Whether the verdict has a time, and whether that time is 0.
constexpr bool occurs(Verdict verdict) {
  return verdict != Verdict::static_pair && verdict != Verdict::receding && verdict != Verdict::miss &&
         verdict != Verdict::tangent;
}
constexpr bool at_once(Verdict verdict) {
  return verdict == Verdict::overlap || verdict == Verdict::contact || verdict == Verdict::taut ||
         verdict == Verdict::overstretched;
}

/// A sign, or the statement that a stage cannot tell.
enum class Sign { negative, zero, positive, uncertain };

/// The sign of a number known as x ± bound. A NaN in either is uncertain.
constexpr Sign sign_within(double x, double bound) {
  if (x > bound) return Sign::positive;
  if (x < -bound) return Sign::negative;
  return Sign::uncertain;
}

/// Blocking: "at distance L and approaching". REQUIRES v ≠ 0.
/// Law: never nullopt when no sign is uncertain.
constexpr std::optional<Verdict> decide_block(Sign h, Sign c, Sign D) {
  if (h == Sign::uncertain) return std::nullopt;
  if (h != Sign::negative) return Verdict::receding;
  if (c == Sign::uncertain) return std::nullopt;
  if (c == Sign::negative) return Verdict::overlap;
  if (c == Sign::zero) return Verdict::contact;
  if (D == Sign::uncertain) return std::nullopt;
  if (D == Sign::negative) return Verdict::miss;
  return D == Sign::zero ? Verdict::tangent : Verdict::hit;
}

/// Tethering: "at distance L and separating". REQUIRES v ≠ 0.
/// Law: never nullopt when no sign is uncertain.
constexpr std::optional<Verdict> decide_tether(Sign h, Sign c, Sign D) {
  if (c == Sign::uncertain) return std::nullopt;
  if (c == Sign::negative) return Verdict::hit;
  if (h == Sign::uncertain) return std::nullopt;
  if (c == Sign::zero) return h == Sign::negative ? Verdict::hit : Verdict::taut;
  if (h != Sign::negative) return Verdict::overstretched;
  if (D == Sign::uncertain) return std::nullopt;
  return D == Sign::positive ? Verdict::hit : Verdict::turning;
}

constexpr std::optional<Verdict> decide(Kind kind, Sign h, Sign c, Sign D) {
  return kind == Kind::block ? decide_block(h, c, D) : decide_tether(h, c, D);
}

}  // namespace tps::exact

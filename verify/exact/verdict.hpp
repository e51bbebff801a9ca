// Which case of the quadratic a timing query is, decided from the signs of h, c and D by one table that all
// stages share.
#pragma once

#include <optional>

#include "reference/equations/timing_verdict.hpp"
#include "verify/exact/timing_query.hpp"

namespace tps::exact {

/// The verdicts of semantics §1 are the reference's words; what decides between them shares no code with it.
using Verdict = TimingVerdict;
using tps::at_once;
using tps::occurs;

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

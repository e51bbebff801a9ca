// Exact coefficients of a timing query, the errors that a stable evaluation may make in them, and what
// follows for landings and verdicts. Heavy header: only sources of laws include it.
#pragma once

#include <optional>

#include "properties/laws/compare.hpp"
#include "verify/exact/verdict.hpp"

namespace tps::properties {

/// h, c and D of eq. (2), exact to 150 digits.
struct Coefficients {
  explicit Coefficients(const LimitQuery& q)
      : r(wide(q.pair.u_B) - wide(q.pair.u_A)), v(wide(q.pair.v_B) - wide(q.pair.v_A)), L(q.L) {
    distance = norm(r);
    a = dot(v, v);
    h = dot(r, v);
    c = dot(r, r) - L * L;
    D = h * h - a * c;
  }

  WideVector r, v;
  Wide L, distance, a, h, c, D;
};

/// How far from L a `hit` may land, worst case. With D off by δD the squared distance is off by δD/a, the
/// distance by δD/(2aL). First form: a L² 5u, |r × v|² 4u relative and 6u |r × v||r||v| from its minors (|r ×
/// v| ≤ |v| L): 5u L
/// + 3u |r|. Second form (|r| < 2L at a hit): h² 12u a L², a c 20u a L²: 16u L ≤ 8u (|r| + L). The time's own
/// roundings: c 4u, √D, sum, quotient and a 6u, times the way |v|t ≤ |r| + L. Rounding r and v: 1u of each
/// way. In all 20u (|r| + L).
inline Wide landing_error(const Coefficients& q, const Wide& u) {
  return 20 * u * (q.distance + q.L) * kSlack;
}

/// The verdict that every stable evaluation finds; absent where rounding may decide. Errors: h 5u |r||v| (its
/// sum 3u, r and v 1u each); c 8u (|r| + L)²; D as for landing_error(), by either form: u (37 a L² + 4 |r ×
/// v|² + 6 |r × v||r||v|).
inline std::optional<exact::Verdict> certain_verdict(TimingKind kind, const Coefficients& q, const Wide& u) {
  using exact::Sign;
  if (q.a == 0) return exact::Verdict::static_pair;
  const auto sign = [](const Wide& x, const Wide& error) {
    return x > error ? Sign::positive : x < -error ? Sign::negative : Sign::uncertain;
  };
  const Wide speed = sqrt(q.a);
  const Wide crossed = norm(cross(q.r, q.v));
  const Wide reach = q.distance + q.L;
  const Wide error_D = 37 * q.a * q.L * q.L + 4 * crossed * crossed + 6 * crossed * q.distance * speed;
  return exact::decide(kind, sign(q.h, 5 * u * q.distance * speed * kSlack),
                       sign(q.c, 8 * u * reach * reach * kSlack), sign(q.D, u * error_D * kSlack));
}

/// At its time a `hit` is at the limit, a `turning` at the closest approach: h + a t errs by 11u |r||v| (h
/// 5u, a 5u, their quotient 1u).
inline Outcome arrives(const LimitQuery& query, const Time& at, const Wide& u) {
  const Coefficients q(query);
  if (at.verdict == "turning" && at.t) {
    return at_most("r·v at the turning point", abs(Wide(q.h + q.a * *at.t)),
                   11 * u * q.distance * sqrt(q.a) * kSlack);
  }
  if (at.verdict != "hit" || !at.t) return {};
  return at_most("the distance to the limit at the time of the hit", abs(Wide(norm(q.r + *at.t * q.v) - q.L)),
                 landing_error(q, u));
}

}  // namespace tps::properties

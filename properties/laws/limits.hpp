// Exact coefficients of a timing query, the errors that a stable evaluation may make in them, and what
// follows for landings and verdicts. Heavy header: only sources of laws include it.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <optional>

#include "properties/laws/compare.hpp"
#include "reference/equations/square_root.hpp"
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

/// Whether h and the sign of c come out without rounding, ties included: every length R units or less, every
/// speed V units or less, so that no term has more than 16 R² V² units, which the format holds.
inline bool is_exact(const LimitQuery& q, const Wide& u) {
  const auto size_in_units = [](std::initializer_list<const Vec3*> vectors) {
    double largest = 0;
    int unit = std::numeric_limits<int>::max();
    for (const Vec3* x : vectors) {
      for (const double component : *x) {
        if (component == 0) continue;
        largest = std::max(largest, std::fabs(component));
        int exponent = std::ilogb(component);
        while (std::ldexp(component, -exponent) != std::trunc(std::ldexp(component, -exponent))) --exponent;
        unit = std::min(unit, exponent);
      }
    }
    return largest == 0 ? Wide(0) : ldexp(Wide(largest), -unit);
  };
  const Vec3 limit{q.L, 0, 0};
  const Wide R = size_in_units({&q.pair.u_A, &q.pair.u_B, &limit}),
             V = size_in_units({&q.pair.v_A, &q.pair.v_B});
  return 16 * (2 * R) * (2 * R) * (2 * V) * (2 * V) * u <= 1;
}

/// The verdict that every stable evaluation finds; absent where rounding may decide. Errors: h 5u |r||v| (its
/// sum 3u, r and v 1u each); c 8u (|r| + L)²; none of both where is_exact(); D as for landing_error(), by
/// either form: u (37 a L² + 4 |r × v|² + 6 |r × v||r||v|).
inline std::optional<exact::Verdict> certain_verdict(const LimitQuery& query, const Wide& u) {
  using exact::Sign;
  const Coefficients q(query);
  if (q.a == 0) return exact::Verdict::static_pair;
  const auto sign = [](const Wide& x, const Wide& error) {
    if (error == 0 && x == 0) return Sign::zero;
    return x > error ? Sign::positive : x < -error ? Sign::negative : Sign::uncertain;
  };
  const Wide speed = square_root(q.a);
  const Wide crossed = norm(cross(q.r, q.v));
  const Wide reach = q.distance + q.L;
  const Wide rounding = is_exact(query, u) ? Wide(0) : Wide(u * kSlack);
  const Wide error_D = 37 * q.a * q.L * q.L + 4 * crossed * crossed + 6 * crossed * q.distance * speed;
  return exact::decide(query.kind, sign(q.h, 5 * rounding * q.distance * speed),
                       sign(q.c, 8 * rounding * reach * reach), sign(q.D, u * error_D * kSlack));
}

/// At its time a `hit` is at the limit, a `turning` at the closest approach: h + a t errs by 11u |r||v| (h
/// 5u, a 5u, their quotient 1u).
inline Outcome arrives(const LimitQuery& query, const Time& at, const Wide& u) {
  const Coefficients q(query);
  if (at.verdict == "turning" && at.t) {
    return at_most("r·v at the turning point", abs(Wide(q.h + q.a * *at.t)),
                   11 * u * q.distance * square_root(q.a) * kSlack);
  }
  if (at.verdict != "hit" || !at.t) return {};
  return at_most("the distance to the limit at the time of the hit", abs(Wide(norm(q.r + *at.t * q.v) - q.L)),
                 landing_error(q, u));
}

/// What `check` says of each of the two timing queries that the subject offers, by its kind.
template <typename Check>
Outcome of_each_kind(const Interview& ask, Check check) {
  Outcome all;
  for (const TimingKind kind : ask.timing_kinds()) all = all_of(std::move(all), check(kind));
  return all;
}

/// An answer and its question, which real arithmetic answers as it does another one, times 2^power.
struct TimedAnswer {
  LimitQuery query;
  Time at;
};

/// Bitwise, or else to rounding: the verdicts are those of a stable evaluation, and both times arrive.
inline Outcome same_to(const std::string& what, const TimedAnswer& one, const TimedAnswer& other, int power,
                       const Wide& u) {
  Time expected = other.at;
  if (expected.t) expected.t = ldexp(*expected.t, power);
  const Outcome bitwise = same(what, one.at, expected);
  if (bitwise.kind == Outcome::Kind::holds) return bitwise;
  const auto certain = certain_verdict(other.query, u);
  for (const TimedAnswer* each : {&one, &other}) {
    if (certain && each->at.verdict != name(*certain)) return bitwise;
    const Outcome arrival = arrives(each->query, each->at, u);
    if (arrival.kind != Outcome::Kind::holds) return broken(bitwise.why + "; " + arrival.why);
  }
  return to_rounding(bitwise.why + ", both right to rounding");
}

}  // namespace tps::properties

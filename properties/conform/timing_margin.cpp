#include "properties/conform/timing_margin.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "properties/laws/limits.hpp"
#include "reference/equations/square_root.hpp"

namespace tps::properties::conform {
namespace {

using exact::Sign;
using exact::Verdict;

LimitQuery limit_query(const exact::TimingQuery& q) {
  return {q.kind, {q.u_A, q.u_B, q.v_A, q.v_B}, q.L};
}

/// Bounds of h, c, D, and of |r + vt|² − L² at the time of a hit.
struct Errors {
  Wide h, c, D, q;
};

/// As certain_verdict() and landing_error() have them (properties/laws/limits.hpp).
Errors stable_errors(const LimitQuery& query, const Coefficients& q, const Wide& u) {
  const Wide rounding = is_exact(query, u) ? Wide(0) : Wide(u * kSlack);
  const Wide speed = square_root(q.a), crossed = norm(cross(q.r, q.v)), reach = q.distance + q.L;
  const Wide landing = landing_error(q, u);
  return {5 * rounding * q.distance * speed, 8 * rounding * reach * reach,
          u * kSlack * (37 * q.a * q.L * q.L + 4 * crossed * crossed + 6 * crossed * q.distance * speed),
          landing * (2 * q.L + landing)};
}

/// With P² = |r|² + L²: a 5u, h 5u|r||v| and c 8u P² as above; so h² 11u a P², a c 14u a P², their difference
/// 1u a P²: D 26u a P². The root, the sum −h ± √D of terms up to √a P that may cancel, and the quotient leave
/// t off by (5 + 1.5 + 2)u P/√a + 6u t with t ≤ 2P/√a: |r + vt|² by 2√D times that, 41u P², and by δD/a.
Errors printed_errors(const LimitQuery& query, const Coefficients& q, const Wide& u) {
  const Errors stable = stable_errors(query, q, u);
  const Wide square = q.distance * q.distance + q.L * q.L;
  return {stable.h, stable.c, 26 * u * kSlack * q.a * square, 67 * u * kSlack * square};
}

std::vector<Sign> possible_signs(const Wide& x, const Wide& error) {
  if (error == 0 && x == 0) return {Sign::zero};
  if (x > error) return {Sign::positive};
  if (x < -error) return {Sign::negative};
  return {Sign::negative, Sign::zero, Sign::positive};
}

/// Every verdict that signs within the errors lead to.
std::vector<Verdict> possible_verdicts(const LimitQuery& query, const Coefficients& q, const Errors& e) {
  if (q.a == 0) return {Verdict::static_pair};
  std::vector<Verdict> verdicts;
  for (const Sign h : possible_signs(q.h, e.h)) {
    for (const Sign c : possible_signs(q.c, e.c)) {
      for (const Sign D : possible_signs(q.D, e.D)) verdicts.push_back(*exact::decide(query.kind, h, c, D));
    }
  }
  return verdicts;
}

/// A hit is on its branch of the quadratic: blocking while the pair approaches, tethering while it separates.
bool is_on_branch(const LimitQuery& query, const Coefficients& q, const Errors& e, const Wide& t) {
  if (q.D <= 4 * e.D) return true;
  const Wide slope = q.h + q.a * t;
  return query.kind == exact::Kind::block ? slope < 0 : slope > 0;
}

bool is_time_of(Verdict verdict, const LimitQuery& query, const Coefficients& q, const Errors& e,
                const std::optional<double>& t, const Wide& u) {
  if (occurs(verdict) != t.has_value()) return false;
  if (!t) return true;
  if (std::isnan(*t) || std::isinf(*t) || *t < 0) return false;
  if (at_once(verdict)) return *t == 0;
  const Wide at(*t);
  if (verdict == Verdict::turning)
    return abs(Wide(q.h + q.a * at)) <= 11 * u * q.distance * square_root(q.a) * kSlack;
  const WideVector apart = q.r + at * q.v;
  return abs(Wide(dot(apart, apart) - q.L * q.L)) <= e.q && is_on_branch(query, q, e, at);
}

bool explains(const Errors& e, const LimitQuery& query, const Coefficients& q, const TimeAnswer& answer,
              const Wide& u) {
  for (const Verdict verdict : possible_verdicts(query, q, e)) {
    if (answer.verdict && *answer.verdict != name(verdict)) continue;
    if (is_time_of(verdict, query, q, e, answer.t, u)) return true;
  }
  return false;
}

/// Whether something happens, when, and how far that may be off; no time where rounding decides it.
struct Moment {
  bool may_occur = false, may_not_occur = false;
  std::optional<Wide> t = {};
  Wide error = 0;
};

Moment moment_of(const LimitQuery& query, const Coefficients& q, const Errors& e, const Wide& u) {
  const std::vector<Verdict> verdicts = possible_verdicts(query, q, e);
  Moment moment{.may_occur = std::any_of(verdicts.begin(), verdicts.end(), occurs),
                .may_not_occur = !std::all_of(verdicts.begin(), verdicts.end(), occurs)};
  if (std::all_of(verdicts.begin(), verdicts.end(), at_once)) {
    moment.t = 0;
  } else if (verdicts.size() > 1 || !moment.may_occur) {
    return moment;
  } else if (verdicts[0] == Verdict::turning) {
    moment.t = -q.h / q.a;
    moment.error = 11 * u * q.distance / square_root(q.a) * kSlack;
  } else if (q.D > 4 * e.D) {
    const Wide root = square_root(q.D);
    moment.t = (query.kind == exact::Kind::block ? Wide(-q.h - root) : Wide(-q.h + root)) / q.a;
    moment.error = e.q / root;  // 2 √D δt = δq, and as much again for the curvature
  }
  return moment;
}

/// Whether the first of two that happen may be said to come before the second.
bool may_precede(const Moment& first, const Moment& second, const Wide& u) {
  if (!first.t || !second.t) return true;
  const Wide error = first.error + second.error + u * (abs(*first.t) + abs(*second.t));
  return *first.t - *second.t < error;
}

bool explains_order(const std::string& order, const Moment& first, const Moment& second, const Wide& u) {
  const bool before = may_precede(first, second, u), after = may_precede(second, first, u);
  if (order == "none") return first.may_not_occur && second.may_not_occur;
  if (order == "equal") return first.may_occur && second.may_occur && before == after;
  if (order == "before") return first.may_occur && (second.may_not_occur || before);
  if (order == "after") return second.may_occur && (first.may_not_occur || after);
  return false;
}

}  // namespace

Margin margin_of(const exact::TimingQuery& query, const TimeAnswer& answer, int bits) {
  const LimitQuery asked = limit_query(query);
  const Coefficients q(asked);
  const Wide u = ldexp(Wide(1), -bits);
  // An answer as a double has its own rounding.
  const Wide u_of_time = std::max(u, Wide(ldexp(Wide(1), -53)));
  if (explains(stable_errors(asked, q, u_of_time), asked, q, answer, u_of_time)) return Margin::stable;
  return explains(printed_errors(asked, q, u_of_time), asked, q, answer, u_of_time) ? Margin::printed
                                                                                    : Margin::none;
}

Margin margin_of_order(const exact::TimingQuery& first, const exact::TimingQuery& second,
                       const std::string& order, int bits) {
  const Wide u = ldexp(Wide(1), -bits);
  const std::array<LimitQuery, 2> asked{limit_query(first), limit_query(second)};
  const std::array<Coefficients, 2> q{Coefficients(asked[0]), Coefficients(asked[1])};
  const auto explained_by = [&](Errors (*errors)(const LimitQuery&, const Coefficients&, const Wide&)) {
    return explains_order(order, moment_of(asked[0], q[0], errors(asked[0], q[0], u), u),
                          moment_of(asked[1], q[1], errors(asked[1], q[1], u), u), u);
  };
  if (explained_by(stable_errors)) return Margin::stable;
  return explained_by(printed_errors) ? Margin::printed : Margin::none;
}

}  // namespace tps::properties::conform

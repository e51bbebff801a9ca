// Eq. (2): what the answers to timing queries say (docs/eq2.md).
#include <algorithm>

#include "properties/generators/cases.hpp"
#include "properties/generators/numbers.hpp"
#include "properties/generators/pairs.hpp"
#include "properties/law.hpp"
#include "properties/laws/limits.hpp"

namespace tps::properties::timing {
namespace {

std::vector<Op> both() {
  return {Op::block_time, Op::tether_time};
}

/// Holds for each kind of limit.
template <typename Check>
Outcome for_each_limit(const Interview& ask, const Case& c, Check check) {
  return of_each_kind(ask, [&](TimingKind kind) { return check(LimitQuery{kind, c.pair(), c.number("L")}); });
}

Outcome a_hit_is_at_the_limit(Interview& ask, const Case& c) {
  return for_each_limit(ask, c, [&](const LimitQuery& q) { return arrives(q, ask.time(q), ask.u()); });
}

// Two limits farther apart than both landings can err are passed in their order.
Outcome a_larger_limit_is_not_later(Interview& ask, const Case& c) {
  const PairState p = c.pair();
  const Coefficients inner({TimingKind::block, p, c.number("L")});
  const Coefficients outer({TimingKind::block, p, c.number("L_larger")});
  if (!(outer.L - inner.L > 2 * landing_error(outer, ask.u())))
    return outside("the limits are nearer to each other than landings err");
  const Time first = ask.block_time(p, c.number("L"));
  if (first.verdict != "hit") return outside("no hit at the inner limit");
  const Time later = ask.block_time(p, c.number("L_larger"));
  if (!later.t) return broken("the inner limit is " + text(first) + ", the outer one " + text(later));
  return at_most("the time of the outer limit", *later.t, *first.t);
}

void two_limits(Case& c, const Format& format) {
  put_pair(c, format);
  const double factor = 1 + std::ldexp(1.0, whole(6 - format.bits, 3));
  c.set("L_larger", format.rounded(c.number("L") * factor));
}

Outcome a_time_goes_with_its_verdict(Interview& ask, const Case& c) {
  return for_each_limit(ask, c, [&](const LimitQuery& q) {
    const Time at = ask.time(q);
    const auto is = [&](std::initializer_list<const char*> verdicts) {
      return std::find(verdicts.begin(), verdicts.end(), at.verdict) != verdicts.end();
    };
    const bool block = q.kind == TimingKind::block;
    const bool now = block ? is({"overlap", "contact"}) : is({"taut", "overstretched"});
    const bool never = block ? is({"static", "receding", "miss", "tangent"}) : is({"static"});
    const bool later = block ? is({"hit"}) : is({"hit", "turning"});
    if (now) return at.t && *at.t == 0 ? Outcome{} : broken(text(at) + "; it is at once: t = 0");
    if (never) return !at.t ? Outcome{} : broken(text(at) + "; it has no time");
    if (later) return at.t && *at.t >= 0 ? Outcome{} : broken(text(at) + "; its time is at least 0");
    return broken(std::string(operations::name(operations::timing_of(q.kind))) + " has no verdict " +
                  at.verdict);
  });
}

Outcome away_from_boundaries_the_verdict_is_right(Interview& ask, const Case& c) {
  std::size_t uncertain = 0;
  const Outcome all = for_each_limit(ask, c, [&](const LimitQuery& q) {
    const auto certain = certain_verdict(q, ask.u());
    if (certain) return same("verdict, and the right one", ask.time(q).verdict, std::string(name(*certain)));
    ++uncertain;
    return Outcome{};
  });
  return uncertain == ask.timing_kinds().size() ? outside("rounding may decide every verdict") : all;
}

}  // namespace

void add_laws(std::vector<Law>& laws) {
  const std::string page = "docs/eq2.md";
  laws.push_back(
      {{"Eq2Laws.Law3ALargerLimitIsNotLater", "(2) law 3",
        "a larger L is never reached later, where the limits are farther apart than landings err", page},
       {Op::block_time},
       cases(two_limits),
       a_larger_limit_is_not_later});
  laws.push_back(
      {{"Eq2Laws.Law4AHitIsAtTheLimit", "(2) law 4",
        "at the time of a hit the distance is L to 20u (|r| + L), at that of a turning r·v = 0", page},
       both(),
       cases(put_pair),
       a_hit_is_at_the_limit,
       kOfEach});
  laws.push_back(
      {{"Eq2Laws.Law5ATimeGoesWithItsVerdict", "(2) law 5",
        "t is 0 where the verdict is at once, absent where nothing occurs, at least 0 elsewhere", page},
       both(),
       cases(put_pair),
       a_time_goes_with_its_verdict,
       kOfEach});
  laws.push_back({{"Eq2Laws.Law6AwayFromBoundariesTheVerdictIsRight", "(2) law 6",
                   "where rounding cannot decide, by the errors of a stable evaluation or since there is "
                   "none, the verdict is the exact one",
                   page},
                  both(),
                  cases(put_pair),
                  away_from_boundaries_the_verdict_is_right,
                  kOfEach});
}

}  // namespace tps::properties::timing

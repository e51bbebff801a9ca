// The order of two events (semantics §1; docs/exact.md, docs/eq2.md).
#include <array>

#include "properties/generators/cases.hpp"
#include "properties/generators/numbers.hpp"
#include "properties/generators/pairs.hpp"
#include "properties/law.hpp"
#include "properties/laws/compare.hpp"

namespace tps::properties::order {
namespace {

const std::array<std::string, 3> kPrefixes{"first.", "second.", "third."};

/// The query under a prefix of keys.
LimitQuery query(const Case& c, const std::string& prefix) {
  return {c.integer(prefix + "kind") == 0 ? TimingKind::block : TimingKind::tether,
          {c.vector(prefix + "u_A"), c.vector(prefix + "u_B"), c.vector(prefix + "v_A"),
           c.vector(prefix + "v_B")},
          c.number(prefix + "L")};
}

void put_query(Case& c, const std::string& prefix, const LimitQuery& q) {
  c.set(prefix + "kind", q.kind == TimingKind::block ? 0 : 1);
  c.set(prefix + "u_A", q.pair.u_A);
  c.set(prefix + "u_B", q.pair.u_B);
  c.set(prefix + "v_A", q.pair.v_A);
  c.set(prefix + "v_B", q.pair.v_B);
  c.set(prefix + "L", q.L);
}

TimingKind any_kind() {
  return one_of({TimingKind::block, TimingKind::tether});
}

LimitQuery any_query(int dimension, const Format& format) {
  const AimedPair aim = pair_aimed_at(one_of(pair_hazards()), format, dimension);
  return {any_kind(), aim.pair, aim.L};
}

/// The same time by other numbers, or one that is a bit away.
LimitQuery next_to(LimitQuery q, const std::string& hazard, const Format& format) {
  const int power = whole(-6, 7);
  q.pair = scaled(q.pair, power, power);
  q.L = std::ldexp(q.L, power);
  if (coin()) q.pair = swapped(q.pair);
  if (hazard == "one_bit") q.L = format.rounded(q.L * (1 + std::ldexp(1.0, 1 - format.bits)));
  return q;
}

/// Queries of neighbouring times, under the first prefixes.
void put_queries(Case& c, const Format& format, std::size_t count) {
  c.dimension = whole(2, 4);
  c.hazard = one_of<std::string>({"unrelated", "same_time", "one_bit"});
  const LimitQuery first = any_query(c.dimension, format);
  put_query(c, kPrefixes[0], first);
  for (std::size_t n = 1; n < count; ++n) {
    put_query(c, kPrefixes[n],
              c.hazard == "unrelated" ? any_query(c.dimension, format) : next_to(first, c.hazard, format));
  }
}

void one_query(Case& c, const Format& format) {
  put_queries(c, format, 1);
  c.set("power", whole(-6, 7));
}
void two_queries(Case& c, const Format& format) {
  put_queries(c, format, 2);
}
void three_queries(Case& c, const Format& format) {
  put_queries(c, format, 3);
}

Outcome is_one_of_four(const std::string& order) {
  if (order == "before" || order == "after" || order == "equal" || order == "none") return {};
  return broken("order is " + order + "; allowed: before, after, equal, none");
}

Outcome antisymmetric(Interview& ask, const Case& c) {
  const LimitQuery p = query(c, kPrefixes[0]), q = query(c, kPrefixes[1]);
  const std::string forth = ask.order(p, q);
  const std::string back = ask.order(q, p);
  const std::string reverse = forth == "before" ? "after" : forth == "after" ? "before" : forth;
  return all_of(is_one_of_four(forth), same("the order of second and first", back, reverse));
}

Outcome a_query_ties_with_itself(Interview& ask, const Case& c) {
  const LimitQuery q = query(c, kPrefixes[0]);
  const int power = c.integer("power");
  const LimitQuery twin{q.kind, swapped(scaled(q.pair, power, power)), std::ldexp(q.L, power)};
  const std::string expected = ask.time(q).t ? "equal" : "none";
  return all_of(same("a query with itself", ask.order(q, q), expected),
                same("with its mirror image, 2^power larger", ask.order(q, twin), expected));
}

Outcome transitive(Interview& ask, const Case& c) {
  const LimitQuery p = query(c, kPrefixes[0]), q = query(c, kPrefixes[1]), r = query(c, kPrefixes[2]);
  const std::string pq = ask.order(p, q);
  const std::string qr = ask.order(q, r);
  const std::string pr = ask.order(p, r);
  if (pq == qr) return same("first to third, as first to second and second to third", pr, pq);
  if (pq == "equal" || pq == "none") return same("first to third, where first and second tie", pr, qr);
  if (qr == "equal" || qr == "none") return same("first to third, where second and third tie", pr, pq);
  return outside("the second is the first or the last of the three");
}

Outcome agrees_with_times(Interview& ask, const Case& c) {
  const LimitQuery p = query(c, kPrefixes[0]), q = query(c, kPrefixes[1]);
  const std::string order = ask.order(p, q);
  const Time first = ask.time(p), second = ask.time(q);
  const auto said = [&](const char* what) {
    return broken("order is " + order + ", " + what + ": " + text(first) + ", " + text(second));
  };
  if (first.t && !second.t) return order == "before" ? Outcome{} : said("only the first occurs");
  if (!first.t && second.t) return order == "after" ? Outcome{} : said("only the second occurs");
  if (!first.t) return order == "none" ? Outcome{} : said("neither occurs");
  if (order == "before") return *first.t <= *second.t ? Outcome{} : said("but the times fall");
  if (order == "after") return *first.t >= *second.t ? Outcome{} : said("but the times rise");
  return order == "equal" && *first.t == *second.t ? Outcome{} : said("but the times are");
}

}  // namespace

void add_laws(std::vector<Law>& laws) {
  const std::string page = "docs/exact.md";
  const std::vector<Op> order{Op::order}, and_times{Op::order, Op::block_time, Op::tether_time};
  laws.push_back({{"OrderLaws.Law1ExchangedItIsReversed", "order law 1",
                   "second to first is the reverse of first to second", page},
                  order,
                  cases(two_queries),
                  antisymmetric});
  laws.push_back({{"OrderLaws.Law2AQueryTiesWithItself", "order law 2",
                   "a query ties with itself and with its mirror image at 2^k times the size", page},
                  and_times,
                  cases(one_query),
                  a_query_ties_with_itself});
  laws.push_back({{"OrderLaws.Law3Transitive", "order law 3",
                   "before is transitive, and ties may stand for each other", page},
                  order,
                  cases(three_queries),
                  transitive});
  laws.push_back(
      {{"OrderLaws.Law4AgreesWithTheTimes", "order law 4",
        "the times of the same implementation do not fall from before to after; an event is before none",
        page},
       and_times,
       cases(two_queries),
       agrees_with_times});
}

}  // namespace tps::properties::order

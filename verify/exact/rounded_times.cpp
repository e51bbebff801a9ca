#include <array>

#include "verify/exact/four_queries.hpp"
#include "verify/exact/rounded_time.hpp"

namespace tps::exact {
namespace {

/// What a query gets whose signs are known: its verdict, if these decide, and where its time is.
struct Decision {
  enum Time : std::uint8_t { none, zero, of_hit, of_turning };
  bool known = false;
  Verdict verdict{};
  Time time = none;
};

constexpr Decision decision(Kind kind, Sign h, Sign c, Sign D) {
  const std::optional<Verdict> verdict = decide(kind, h, c, D);
  if (!verdict) return {};
  if (!occurs(*verdict)) return {true, *verdict, Decision::none};
  if (at_once(*verdict)) return {true, *verdict, Decision::zero};
  return {true, *verdict, *verdict == Verdict::turning ? Decision::of_turning : Decision::of_hit};
}

constexpr Sign sign_of(std::size_t number) {
  constexpr Sign signs[] = {Sign::uncertain, Sign::negative, Sign::positive, Sign::uncertain};
  return signs[number];
}
constexpr std::size_t sign_number(const FourAnswers::Signs& signs, unsigned n) {
  return (signs.negative >> n & 1U) | (signs.positive >> n & 1U) << 1U;
}

/// decide() as a table, for no processor foresees which way a random query goes.
constexpr auto decisions = [] {
  std::array<Decision, 128> table{};
  for (std::size_t n = 0; n < table.size(); ++n)
    table[n] = decision(n / 64 == 0 ? Kind::block : Kind::tether, sign_of(n / 16 % 4), sign_of(n / 4 % 4),
                        sign_of(n % 4));
  return table;
}();

bool is_plain(const TimingQuery& query) {
  return query.kind != Kind::plane && is_at_home(query);
}

/// Whether all four may be asked together.
bool are_plain(const TimingQuery* queries) {
  return is_plain(queries[0]) && is_plain(queries[1]) && is_plain(queries[2]) && is_plain(queries[3]);
}

void ask_four(const TimingQuery* queries, TimingAnswer* answers, Counters& counters) {
  const FourAnswers four = four_answers(queries);
  for (unsigned n = 0; n < 4; ++n) {
    const Decision& decided =
        decisions[(queries[n].kind == Kind::block ? 0U : 64U) + 16 * sign_number(four.h, n) +
                  4 * sign_number(four.c, n) + sign_number(four.D, n)];
    const unsigned proven[] = {1, 1, four.hit_is_proven >> n & 1U, four.turning_is_proven >> n & 1U};
    const double times[] = {0, 0, four.hit[n], four.turning[n]};
    if (decided.known && (four.in_range >> n & proven[decided.time]) != 0) {
      ++counters.verdict.calls;
      counters.time.calls += decided.time != Decision::none;
      answers[n] = {decided.verdict, times[decided.time]};
      if (decided.time == Decision::none) answers[n].t.reset();
    } else {
      answers[n] = rounded_time(queries[n], counters);
    }
  }
}

}  // namespace

void rounded_times(std::span<const TimingQuery> queries, std::span<TimingAnswer> answers,
                   Counters& counters) {
  const bool in_fours = has_registers_of_four();
  std::size_t n = 0;
  while (n < queries.size()) {
    if (in_fours && n + 4 <= queries.size() && are_plain(&queries[n])) {
      ask_four(&queries[n], &answers[n], counters);
      n += 4;
    } else {
      answers[n] = rounded_time(queries[n], counters);
      ++n;
    }
  }
}

}  // namespace tps::exact

// The strata of order.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "verify/exact/exact_verdict.hpp"
#include "verify/exact/time_order.hpp"
#include "verify/vectors/one_bit.hpp"
#include "verify/vectors/stratum.hpp"
#include "verify/vectors/timing_strata.hpp"

namespace tps::vectors {
namespace {

using exact::Kind;
using exact::TimingQuery;
using exact::Vec3;

struct Pair {
  TimingQuery first, second;
};

exact::Order order_of(const Pair& pair) {
  exact::Counters counters;
  return exact::time_order(pair.first, pair.second, counters);
}

TimingQuery from(std::string_view family, Random& random) {
  const auto& table = exact::strata::timing_strata();
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const auto& f) { return f.name == family; });
  return found->query(random, exact::strata::any_kind(random), 3);
}

Pair independent(Random& random, std::string_view family) {
  const TimingQuery first = from(family, random);
  return {first, from(family, random)};
}

/// A query that will have an event later.
TimingQuery with_event(Random& random, std::string_view family) {
  for (int attempt = 0; attempt < 10000; ++attempt) {
    const TimingQuery query = from(family, random);
    exact::Counters counters;
    const exact::Verdict verdict = exact::exact_verdict(query, counters);
    if (exact::occurs(verdict) && !exact::at_once(verdict)) return query;
  }
  throw std::logic_error("no event found; the families of timing_strata() have changed");
}

void mirrored(Vec3& x, std::size_t turn, std::size_t mirror) {
  std::rotate(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(turn), x.end());
  x[mirror] = -x[mirror];
}

/// The same event seen otherwise: axes exchanged and one reversed, A and B exchanged, lengths and velocities
/// in another unit. All of it is exact, so the times are equal.
TimingQuery same_event(Random& random, TimingQuery query) {
  const auto turn = static_cast<std::size_t>(random.integer(0, 2));
  const auto mirror = static_cast<std::size_t>(random.integer(0, 2));
  for (Vec3* x : {&query.u_A, &query.u_B, &query.v_A, &query.v_B}) mirrored(*x, turn, mirror);
  if (random.coin()) {
    std::swap(query.u_A, query.u_B);
    std::swap(query.v_A, query.v_B);
  }
  const int unit = random.integer(-60, 60);
  return exact::strata::scaled(query, unit, unit);
}

Pair exact_tie(Random& random) {
  const TimingQuery first = with_event(random, random.coin() ? "plain" : "graze");
  return {first, same_event(random, first)};
}

/// A blocking and a tethering query of one relative motion on a line, in contact and taut at the same
/// instant: the limits differ by what the pair moves through.
Pair mixed_tie(Random& random) {
  const int speed = random.integer(1, 9);
  const int t = random.integer(1, 99);
  const int inner = random.integer(1, 50);
  const int outer = random.integer(1, 50);
  const TimingQuery block =
      exact::strata::relative(Kind::block, {double(-inner - speed * t), 0, 0}, {double(speed), 0, 0}, inner);
  const TimingQuery tether =
      exact::strata::relative(Kind::tether, {0, double(outer - speed * t), 0}, {0, double(speed), 0}, outer);
  return random.coin() ? Pair{block, tether} : Pair{tether, block};
}

/// One number of the second query changed in its last bit.
Pair near_tie(Random& random) {
  Pair pair = exact_tie(random);
  double& x = random.coin() ? pair.second.L : pair.second.u_B[static_cast<std::size_t>(random.integer(0, 2))];
  x = std::nextafter(x, random.coin() ? HUGE_VAL : -HUGE_VAL);
  return pair;
}

/// The limit of the second query beside that tie by 2^-k of it. A pair that turns does so whatever its limit.
Pair graded_tie(Random& random) {
  Pair pair;
  do {
    pair = exact_tie(random);
    pair.second.L *= beside_one(random, 5, 45);
  } while (order_of(pair) == exact::Order::equal);
  return pair;
}

/// Such a pair in other units of length and of time.
Pair scaled_tie(Random& random) {
  const Pair pair = graded_tie(random);
  const int length = random.integer(-90, 90), speed = random.integer(-90, 90);
  return {exact::strata::scaled(pair.first, length, speed),
          exact::strata::scaled(pair.second, length, speed)};
}

/// Tethered to where it is, and another event before or behind the first pull.
Pair coincident(Random& random) {
  TimingQuery first = from("plain", random);
  first.kind = Kind::tether;
  first.u_B = first.u_A;
  const TimingQuery second = with_event(random, "plain");
  return random.coin() ? Pair{first, second} : Pair{second, first};
}

std::pair<Pair, Pair> order_twins(Random& random) {
  for (int attempt = 0; attempt < 10000; ++attempt) {
    Pair pair = exact_tie(random);
    double& x = pair.second.L;
    const double step = std::ldexp(1.0, -random.integer(2, 45));
    const double first = x * (1 - step);
    const double last = x * (1 + step);
    if (const auto found = twins(pair, x, first, last, order_of)) return *found;
  }
  throw std::logic_error("no change of order found; the families of timing_strata() have changed");
}

Json order_input(const Pair& pair) {
  const auto side = [](const TimingQuery& query) {
    Json in{{"kind", query.kind == Kind::block ? "block" : "tether"}};
    in.update(timing_input(query, 3));
    return in;
  };
  return {{"first", side(pair.first)}, {"second", side(pair.second)}};
}

}  // namespace

void add_order_strata(std::vector<Stratum>& strata) {
  const auto add = [&](const char* name, const char* why, auto pair_of, int committed = 100) {
    strata.push_back(
        {Op::order, name, why, committed, [name, pair_of](Random& random, std::uint64_t) -> Problem {
           return {order_input(pair_of(random)), {name}};
         }});
  };
  for (const char* family :
       {"plain", "graze", "integers", "near_static", "any_scale", "wide", "subnormal", "float32"}) {
    add(family, "two queries of this timing stratum",
        [family](Random& random) { return independent(random, family); });
  }
  add("exact_tie", "one event in two exact descriptions", exact_tie);
  add("mixed_tie", "a blocking and a tethering event at the same instant", mixed_tie);
  add("near_tie", "an exact tie with one number changed in its last bit", near_tie);
  add("graded_tie", "an exact tie with one limit changed by 2^-k of it, k from 5 to 45", graded_tie, 30);
  add("scaled_tie", "such a pair, lengths times 2^i, velocities times 2^j, i and j from -90 to 90",
      scaled_tie, 20);
  add("coincident", "a pull of two particles at one point, and another event", coincident, 30);
  strata.push_back({Op::order, "twins", "one bit apart on the two sides of a change of order", 120,
                    [](Random& random, std::uint64_t number) -> Problem {
                      const auto [one, other] = order_twins(random);
                      return {order_input(number % 2 == 0 ? one : other), {"twin"}};
                    },
                    2});
}

}  // namespace tps::vectors

// Eq. (2): what does not matter to a timing query (docs/eq2.md).

#include "properties/generators/cases.hpp"
#include "properties/generators/numbers.hpp"
#include "properties/generators/pairs.hpp"
#include "properties/law.hpp"
#include "properties/laws/limits.hpp"

namespace tps::properties::invariance {
namespace {

std::vector<Op> both() {
  return {Op::block_time, Op::tether_time};
}

/// Each query answers alike, bitwise, about the case's pair and another one.
Outcome same_times(Interview& ask, const std::string& what, const Case& c, const PairState& other) {
  return of_each_kind(ask, [&](TimingKind kind) {
    const LimitQuery one{kind, other, c.number("L")}, two{kind, c.pair(), c.number("L")};
    const char* op = kind == TimingKind::block ? ", block_time" : ", tether_time";
    return same_to(what + op, {one, ask.time(one)}, {two, ask.time(two)}, 0, ask.u());
  });
}

Outcome swap_of_names(Interview& ask, const Case& c) {
  return same_times(ask, "A and B exchanged", c, swapped(c.pair()));
}

void with_powers(Case& c, const Format& format) {
  put_pair(c, format);
  const int most = format.largest_case_exponent() * 2 / 3;
  c.set("power", whole(-most, most));
}

Outcome powers_of_two(Interview& ask, const Case& c) {
  const PairState p = c.pair();
  const double L = c.number("L");
  const int power = c.integer("power");
  const auto check = [&](TimingKind kind) {
    const auto asked = [&](const LimitQuery& query) { return TimedAnswer{query, ask.time(query)}; };
    const TimedAnswer at = asked({kind, p, L});
    return all_of(
        same_to("lengths and velocities times 2^power",
                asked({kind, scaled(p, power, power), std::ldexp(L, power)}), at, 0, ask.u()),
        same_to("velocities times 2^power", asked({kind, scaled(p, 0, power), L}), at, -power, ask.u()));
  };
  return of_each_kind(ask, check);
}

void with_signs(Case& c, const Format& format) {
  put_pair(c, format);
  c.set("axes", whole(1, 8));
}

template <typename Map>
PairState mapped(const PairState& p, Map map) {
  return {map(p.u_A), map(p.u_B), map(p.v_A), map(p.v_B)};
}

Outcome reflections(Interview& ask, const Case& c) {
  const auto flipped = [&](const Vec3& x) {
    Vec3 y = x;
    for (std::size_t k = 0; k < 3; ++k) {
      if ((c.integer("axes") >> k & 1) != 0) y[k] = 0 - y[k];
    }
    return y;
  };
  return same_times(ask, "axes reflected", c, mapped(c.pair(), flipped));
}

void with_rotation(Case& c, const Format& format) {
  put_pair(c, format);
  c.set("axes", whole(0, 4));
}

/// A quarter turn in the plane; in space one about an axis, or the cycle of all three.
Vec3 turned(const Vec3& x, int axes, int dimension) {
  if (dimension == 2) return {0 - x[1], x[0], 0};
  if (axes == 3) return {x[2], x[0], x[1]};
  const auto first = static_cast<std::size_t>(axes);
  const std::size_t second = (first + 1) % 3;
  Vec3 y = x;
  y[first] = 0 - x[second];
  y[second] = x[first];
  return y;
}

// Sums of three squares depend on their order, so in space the turned answer only has to be an answer: the
// right verdict where rounding does not decide, a time that arrives before the turn, too.
Outcome rotations(Interview& ask, const Case& c) {
  const PairState other =
      mapped(c.pair(), [&](const Vec3& x) { return turned(x, c.integer("axes") % 4, c.dimension); });
  if (c.dimension == 2) return same_times(ask, "a quarter turn", c, other);
  const auto check = [&](TimingKind kind) {
    const LimitQuery query{kind, c.pair(), c.number("L")};
    const Time at = ask.time(query);
    const Time of_turned = ask.time({kind, other, c.number("L")});
    if (certain_verdict(query, ask.u()) && at.verdict != of_turned.verdict)
      return broken("turned: " + text(of_turned) + "; before: " + text(at));
    return arrives(query, of_turned, ask.u());
  };
  return of_each_kind(ask, check);
}

void in_motion(Case& c, const Format& format) {
  if (coin()) {
    put_pair(c, format);
  } else {
    put_integer_pair(c);
  }
  const auto offset = [&] {
    Vec3 x{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(c.dimension); ++k) x[k] = small_integer();
    return x;
  };
  c.set("u_offset", offset());
  c.set("v_offset", offset());
}

/// a + b where that is a number of the format.
Vec3 exact_sum(const Vec3& a, const Vec3& b, const Interview& ask) {
  const Vec3 sum = ask.passed(wide(a) + wide(b));
  if (!(wide(sum) == wide(a) + wide(b)))
    throw Unanswered{outside("the shift rounds a number, so it is another question")};
  return sum;
}

Outcome galilean_shifts(Interview& ask, const Case& c) {
  const PairState p = c.pair();
  const Vec3 u = c.vector("u_offset"), v = c.vector("v_offset");
  const PairState other{exact_sum(p.u_A, u, ask), exact_sum(p.u_B, u, ask), exact_sum(p.v_A, v, ask),
                        exact_sum(p.v_B, v, ask)};
  return same_times(ask, "seen from a place in motion", c, other);
}

}  // namespace

void add_laws(std::vector<Law>& laws) {
  const std::string page = "docs/eq2.md";
  laws.push_back({{"Eq2Laws.Law1SwapOfNames", "(2) law 1", "A and B may be exchanged, bitwise", page},
                  both(),
                  cases(put_pair),
                  swap_of_names,
                  kOfEach});
  laws.push_back(
      {{"Eq2Laws.Law2PowersOfTwo", "(2) law 2",
        "lengths and velocities times 2^k leave verdict and t as they are, velocities alone divide t by "
        "2^k, bitwise",
        page},
       both(),
       cases(with_powers),
       powers_of_two,
       kOfEach});
  laws.push_back({{"Eq2Laws.Law7Reflections", "(2) law 7", "axes may be reflected, bitwise", page},
                  both(),
                  cases(with_signs),
                  reflections,
                  kOfEach});
  laws.push_back({{"Eq2Laws.Law8Rotations", "(2) law 8",
                   "axes may be exchanged: bitwise in the plane, to rounding in space", page},
                  both(),
                  cases(with_rotation),
                  rotations,
                  kOfEach});
  laws.push_back(
      {{"Eq2Laws.Law9GalileanShifts", "(2) law 9",
        "a common offset of positions, and one of velocities, matter to nothing where they are exact, "
        "bitwise",
        page},
       both(),
       cases(in_motion),
       galilean_shifts,
       kOfEach});
}

}  // namespace tps::properties::invariance

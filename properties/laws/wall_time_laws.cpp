// The time to a plane wall, docs/effects.md.
#include <array>

#include "properties/generators/cases.hpp"
#include "properties/generators/numbers.hpp"
#include "properties/law.hpp"
#include "properties/laws/compare.hpp"
#include "properties/laws/plane_approach.hpp"

namespace tps::properties::wall {
namespace {

constexpr std::size_t kLeaning = 6;  ///< from here on a case's "axes" stands for a normal along no axis

/// The axes first, in both directions.
Vec3 normal_of(const Case& c, const Format& format) {
  const auto n = static_cast<std::size_t>(c.integer("axes"));
  const auto dimension = static_cast<std::size_t>(c.dimension);
  Vec3 normal{};
  if (n < kLeaning) {
    normal[n / 2 % dimension] = n % 2 == 0 ? 1 : -1;
    return normal;
  }
  const std::array<Vec3, 2> leaning = dimension == 2 ? std::array<Vec3, 2>{{{.6, .8, 0}, {-.8, .6, 0}}}
                                                     : std::array<Vec3, 2>{{{2, -3, 6}, {-6, 2, 3}}};
  const Vec3& along = leaning[n % 2];
  for (std::size_t k = 0; k < 3; ++k) normal[k] = format.rounded(dimension == 2 ? along[k] : along[k] / 7);
  return normal;
}

/// A particle and a plane; aimed at its edges along an axis, where the numbers are exact.
void before_a_plane(Case& c, const Format& format) {
  c.dimension = whole(2, 4);
  c.hazard = one_of<std::string>({"general", "general", "near", "touch", "behind", "along", "static"});
  const bool is_aimed = c.hazard != "general" && c.hazard != "static";
  const int axis = whole(0, 2 * c.dimension);
  c.set("axes",
        is_aimed || coin() ? axis : whole(static_cast<int>(kLeaning), static_cast<int>(kLeaning) + 2));
  PairState pair{vector(format, c.dimension), vector(format, c.dimension), vector(format, c.dimension),
                 vector(format, c.dimension)};
  double L = magnitude(format);
  const auto k = static_cast<std::size_t>(axis / 2);
  const double sign = axis % 2 == 0 ? 1 : -1;
  if (c.hazard == "near" || c.hazard == "touch" || c.hazard == "behind") {
    L = format.rounded(std::fabs(small_integer()) + 1);
    pair.u_A[k] = small_integer();
    const double gap = c.hazard == "touch" ? 0 : c.hazard == "near" ? .25 : -L / 2;
    pair.u_B[k] = format.rounded(pair.u_A[k] + sign * (L + gap));
    pair.v_A[k] = small_integer();
    pair.v_B[k] = format.rounded(pair.v_A[k] - sign * whole(-1, 4));
  }
  if (c.hazard == "along") pair.v_B[k] = pair.v_A[k];
  if (c.hazard == "static") pair.v_B = pair.v_A;
  c.set(pair);
  c.set("L", L);
  c.set("second.L", format.rounded(L * one_of({.015625, .5, 1.5})));
}

/// Straight towards the plane from above the point of it that is named.
void head_on(Case& c, const Format& format) {
  before_a_plane(c, format);
  c.hazard = "head_on";
  c.set("axes", whole(0, 2 * c.dimension));
  PairState pair = c.pair();
  const auto axis = static_cast<std::size_t>(c.integer("axes"));
  for (std::size_t k = 0; k < 3; ++k) {
    if (k == axis / 2) continue;
    pair.u_B[k] = pair.u_A[k];
    pair.v_B[k] = pair.v_A[k];
  }
  c.set(pair);
}

void with_powers(Case& c, const Format& format) {
  before_a_plane(c, format);
  const int most = format.largest_case_exponent() / 2;
  c.set("power_of_lengths", whole(-most, most + 1));
  c.set("power_of_speeds", whole(-most, most + 1));
}

/// A question, what real arithmetic says of it, and the answer.
struct Asked {
  Asked(Interview& ask, const Case& c, const Format& format, const char* distance = "L")
      : normal(normal_of(c, format)),
        plane(c.pair(), c.number(distance), normal, ask.u()),
        time(ask.wall_time(c.pair(), c.number(distance), normal)),
        error(time.t ? plane.residual(*time.t, ask.u()) : Wide(0)) {}

  Vec3 normal;
  PlaneApproach plane;
  Time time;
  Wide error;
};

/// Bitwise, or else to what both answers may be off by.
Outcome same_time(const std::string& what, const Time& found, const Asked& k, const Wide& factor = 1) {
  const Time expected{k.time.verdict, k.time.t ? std::optional<Wide>(*k.time.t * factor) : std::nullopt};
  const Outcome bitwise = same(what, found, expected);
  if (bitwise.kind == Outcome::Kind::holds || !found.t || !k.time.t) return bitwise;
  const Wide apart = abs(Wide(*found.t / factor - *k.time.t)) * k.plane.towards;
  return apart <= 2 * k.error ? to_rounding(bitwise.why) : bitwise;
}

Outcome the_way_is_the_gap(Interview& ask, const Case& c, const Format& format) {
  const Asked k(ask, c, format);
  if (!k.time.t) return outside("nothing occurs");
  if (*k.time.t < 0) return broken("t is " + text(*k.time.t) + "; allowed: at least 0");
  if (*k.time.t == 0) return at_most("n·r − L of what occurs at once", k.plane.gap, k.plane.gap_error);
  return at_most("the error of −n·v t = n·r − L", abs(Wide(*k.time.t * k.plane.towards - k.plane.gap)),
                 k.error);
}

Outcome away_from_boundaries_the_verdict_is_right(Interview& ask, const Case& c, const Format& format) {
  const Asked k(ask, c, format);
  const auto is = [&](const char* verdict) {
    return same("the verdict, and that of real arithmetic", k.time.verdict, std::string(verdict));
  };
  if (k.plane.is_static) return is("static");
  if (abs(k.plane.towards) <= k.plane.towards_error) return outside("rounding may decide which way it moves");
  if (k.plane.towards < 0) return is("receding");
  if (abs(k.plane.gap) <= k.plane.gap_error) return outside("rounding may decide whether it touches");
  return is(k.plane.gap < 0 ? "overlap" : "hit");
}

Outcome powers_of_two(Interview& ask, const Case& c, const Format& format) {
  const Asked k(ask, c, format);
  const int lengths = c.integer("power_of_lengths"), speeds = c.integer("power_of_speeds");
  const Time found =
      ask.wall_time(scaled(c.pair(), lengths, speeds), std::ldexp(c.number("L"), lengths), k.normal);
  return same_time("at 2^k times the size and speed", found, k, ldexp(Wide(1), lengths - speeds));
}

Outcome reflections(Interview& ask, const Case& c, const Format& format) {
  const Asked k(ask, c, format);
  std::array<Outcome, 3> outcomes;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(c.dimension); ++axis) {
    PairState mirrored = c.pair();
    Vec3 normal = k.normal;
    for (double* x :
         {&mirrored.u_A[axis], &mirrored.u_B[axis], &mirrored.v_A[axis], &mirrored.v_B[axis], &normal[axis]})
      *x = -*x;
    outcomes[axis] = same_time("reflected along axis " + std::to_string(axis),
                               ask.wall_time(mirrored, c.number("L"), normal), k);
  }
  return all_of(outcomes[0], outcomes[1], outcomes[2]);
}

Outcome linear_in_the_distance(Interview& ask, const Case& c, const Format& format) {
  const Asked one(ask, c, format), other(ask, c, format, "second.L");
  if (one.time.verdict != "hit" || other.time.verdict != "hit") return outside("not two hits");
  if (!one.time.t || !other.time.t) return broken("a hit has no time");
  const Wide way = Wide(c.number("second.L")) - Wide(c.number("L"));
  const Wide flown = (*one.time.t - *other.time.t) * one.plane.towards;
  return at_most("the error of the way between two distances", abs(Wide(flown - way)),
                 one.error + other.error);
}

/// Eq. (2) for a pair of which A does not respond: |r| − L over the speed, by a road that squares. Its
/// landing errs by 20u (|r| + L), as (2) law 4 has it.
Outcome head_on_it_is_the_block_time(Interview& ask, const Case& c, const Format& format) {
  const Asked k(ask, c, format);
  const Wide distance = k.plane.gap + Wide(c.number("L"));
  if (!(distance > 0)) return outside("the centre is not before the plane");
  const Time sphere = ask.block_time(c.pair(), c.number("L"));
  const Wide landing = 20 * ask.u() * kSlack * (distance + Wide(c.number("L")));
  if (abs(k.plane.gap) <= k.plane.gap_error + landing || abs(k.plane.towards) <= k.plane.towards_error)
    return outside("rounding may decide the verdicts");
  if (sphere.verdict != k.time.verdict)
    return broken("the plane says " + text(k.time) + ", block_time " + text(sphere));
  if (sphere.t.has_value() != k.time.t.has_value())
    return broken("the plane says " + text(k.time) + ", block_time " + text(sphere));
  if (!sphere.t) return {};
  return at_most("what the ways flown differ by", abs(Wide(*sphere.t - *k.time.t)) * k.plane.towards,
                 k.error + landing);
}

}  // namespace

void add_laws(std::vector<Law>& laws) {
  using Fill = void (*)(Case&, const Format&);
  using Check = Outcome (*)(Interview&, const Case&, const Format&);
  const auto add = [&laws](const char* id, const char* number, const char* sentence,
                           const std::vector<Op>& operations, Fill fill, Check check) {
    laws.push_back({{id, number, sentence, "docs/effects.md"},
                    operations,
                    cases(fill),
                    [check](Interview& ask, const Case& c) { return check(ask, c, ask.format()); }});
  };
  const std::vector<Op> wall{Op::wall_time};
  add("WallLaws.Law1TheWayFlownIsTheGap", "wall law 1",
      "−n·v t is n·r − L, to 6u (Σ|n_k r_k| + L) and 7u of the way; at once is at the limit or behind it",
      wall, before_a_plane, the_way_is_the_gap);
  add("WallLaws.Law2AwayFromBoundariesTheVerdictIsRight", "wall law 2",
      "where rounding cannot decide, the verdict is the exact one", wall, before_a_plane,
      away_from_boundaries_the_verdict_is_right);
  add("WallLaws.Law3PowersOfTwo", "wall law 3",
      "lengths times 2^k multiply t by 2^k, velocities times 2^k divide it, verdicts stay, bitwise", wall,
      with_powers, powers_of_two);
  add("WallLaws.Law4Reflections", "wall law 4", "axes may be reflected, the normal with them, bitwise", wall,
      before_a_plane, reflections);
  add("WallLaws.Law5LinearInTheDistance", "wall law 5",
      "from one distance to another it takes their difference over −n·v", wall, before_a_plane,
      linear_in_the_distance);
  add("WallLaws.Law6HeadOnItIsTheBlockTime", "wall law 6",
      "straight from above it is the time of a pair whose A does not respond",
      {Op::wall_time, Op::block_time}, head_on, head_on_it_is_the_block_time);
}

}  // namespace tps::properties::wall

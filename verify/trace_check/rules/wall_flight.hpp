// Rules earliest and bounds, for a particle and a wall: it is not passed, and nobody is late at it.
#pragma once

#include <limits>

#include "verify/trace_check/rules/direction.hpp"
#include "verify/trace_check/rules/earliest.hpp"
#include "verify/trace_check/rules/wall_region.hpp"

namespace tps::check {

/// A particle on its way to a surface, from the start of its flight.
template <typename Number>
struct WallFlight {
  using W = Work<Number>;
  int i;
  std::size_t n;             ///< of Model::walls
  PairFlight<Number> pair;   ///< the particle and the wall, along the axes that the distance is measured on
  PairFlight<Number> whole;  ///< along all of them
  int sign;                  ///< of r·v, exactly: −1 approaching the centre, or the plane
  LimitAsked<W> asked;       ///< of a sphere
  Quadratic<W> q;            ///< of a sphere
  W gap{0}, towards{0};      ///< of a plane: n·r − L and −n·v
  W gap_error{0}, towards_error{0};
  bool is_plane;

  const char* limit() const { return asked.outer ? "outer" : "inner"; }
};

/// A plane is where n·(u − p) = L. In double: a difference, a product and two additions a term, L, and the
/// quotient, 6u of the sum of sizes; as much less one for the velocities.
template <typename Number>
WallFlight<Number> wall_flight(const Context<Number>& c, int i, std::size_t n) {
  using W = Work<Number>;
  using std::abs;
  const Model<Number>& model = c.model;
  const WallModel<Number>& wall = model.walls[n];
  const Flight<Number>& flight = model.flight(i);
  PairFlight<Number> pair;
  pair.start = flight.since;
  pair.blur = model.blur(i);
  pair.drift = flight.drift;
  pair.u_i = flight.position;
  const Flight<Number> of_wall{wall.point, wall.velocity, {}, W(0)};
  pair.u_j =
      wall.velocity == Vec<Number>{} ? wall.point : carried(of_wall, pair.start, model.precision, pair.blur);
  pair.v_i = flight.velocity;
  pair.v_j = wall.velocity;
  const PairFlight<Number> whole = pair;
  for (Vec<Number>* x : {&pair.u_i, &pair.u_j, &pair.v_i, &pair.v_j}) *x = wall.measured(*x);
  const W L(wall.distances[Model<Number>::at(model.scene.particles[Model<Number>::at(i)].species)]);
  const int sign = wall.is_plane()
                       ? detail::exact_sign<Number>(wall.normal, Vec<Number>{}, pair.v_i, pair.v_j)
                       : detail::exact_sign<Number>(pair.u_i, pair.u_j, pair.v_i, pair.v_j);
  const LimitAsked<W> asked{wall.is_inside(), L, wall.is_inside() && sign < 0};
  WallFlight<Number> result{i, n, pair, whole, sign, asked, {}, W(0), W(0), W(0), W(0), wall.is_plane()};
  const RelativeFlight<W> relative = pair.relative();
  result.q = quadratic_of(relative, L, c.u(), c.timing, c.scale());
  if (!wall.is_plane()) return result;
  result.gap = -L;
  W gap_size = L, towards_size(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const W of_r = W(wall.normal[k]) * -relative.r[k];
    const W of_v = W(wall.normal[k]) * relative.v[k];
    result.gap += of_r;
    result.towards += of_v;
    gap_size += abs(of_r);
    towards_size += abs(of_v);
  }
  result.gap_error = c.scale() * (W(6) * c.u() * gap_size + pair.blur) + model.precision.smallest;
  result.towards_error = c.scale() * (W(6) * c.u() * towards_size + pair.drift);
  return result;
}

/// When the particle is due at the surface, within the error of the trace's timing. What the exact sign of
/// its approach rules out, never is.
template <typename Number>
Due<Work<Number>> due(const WallFlight<Number>& flight) {
  using W = Work<Number>;
  if (!flight.asked.outer && flight.sign >= 0) return never_due<W>();
  if (!flight.is_plane) return due(flight.q, flight.asked);
  const W fast = flight.towards + flight.towards_error;
  const W slow = flight.towards - flight.towards_error;
  const W least = std::max(W(0), W(flight.gap - flight.gap_error));
  const W most = std::max(W(0), W(flight.gap + flight.gap_error));
  const W ever = std::numeric_limits<W>::infinity();
  const W latest = most == W(0) ? W(0) : slow > W(0) ? W(most / slow) : ever;
  return {false, false, fast > W(0) ? W(least / fast) : W(0), latest};
}

/// Whether a particle is before this part of the wall when it is due there; of a box's outside alone it may
/// not be. What rounding decides is nobody's fault.
template <typename Number>
Within faces_when_due(const Context<Number>& c, const WallFlight<Number>& flight) {
  using W = Work<Number>;
  const WallModel<Number>& wall = c.model.walls[flight.n];
  if (!wall.surface.region) return Within::yes;
  const Due<W> expected = due(flight);
  if (expected.must_be_none || !(expected.latest < std::numeric_limits<W>::infinity()))
    return expected.must_be_none ? Within::no : Within::rounding;
  return in_region(c, wall, flight.whole, expected.earliest, expected.latest);
}

/// The question in doubles, for exact answers.
inline TimingQuery timing_query(const Context<double>& c, const WallFlight<double>& flight) {
  const PairFlight<double>& pair = flight.pair;
  const double L = static_cast<double>(flight.asked.L);
  if (!flight.is_plane) return timing_query(pair, flight.asked.outer, L);
  return {
      TimingKind::plane, pair.u_j.x, pair.u_i.x, pair.v_j.x, pair.v_i.x, L, c.model.walls[flight.n].normal.x};
}

/// The turn of a certified particle at a surface; nothing where it has none.
inline std::optional<Turn<double>> certified_turn(const Context<double>& c,
                                                  const WallFlight<double>& flight) {
  std::optional<Turn<double>> turn;
  if (!flight.is_plane) {
    turn = detail::certified_turn(c, flight.pair, flight.i, flight.i, flight.asked,
                                  certified_time(c, flight.pair, flight.asked));
  } else {
    const TimingQuery query = timing_query(c, flight);
    if (!valid(query)) return std::nullopt;
    const CollisionTime<double> answer = c.exact.answer(query);
    if (!answer.t) return std::nullopt;
    const double dt = rounded_once(c.exact, query, *answer.t, c.model.precision);
    const Instant<double>& start = flight.pair.start;
    turn = Turn<double>{later_by(start, dt, c.model.precision),
                        c.exact.known(Moment{start.hi, start.lo, query, 1})};
    turn->first = turn->second = flight.i;
  }
  if (turn) turn->rank = kRankAtWall;
  return turn;
}

namespace detail {

template <typename Number>
std::string wall_name(const Context<Number>& c, const WallFlight<Number>& flight) {
  return fmt::format("particle {} and {}", c.model.id(flight.i),
                     surface_name(c.model.walls[flight.n].surface));
}

template <typename Number>
void say_overdue(const Context<Number>& c, const WallFlight<Number>& flight, Waiting state,
                 const Work<Number>& dt, Finding& f) {
  f.particles = {c.model.id(flight.i)};
  f.equation = "(2)";
  if (state == Waiting::lost_a_tie) {
    f.reading = readings::kOrder;
    f.message = wall_name(c, flight) + " touch at exactly this moment and come first by rank and ids";
    return;
  }
  const Due<Work<Number>> expected = due(flight);
  f.message = fmt::format("{} were due to touch {} after {}, and have not within {}", wall_name(c, flight),
                          shown(expected.latest), c.shown_time(flight.pair.start), shown(dt));
}

template <typename Number>
Waiting waiting(const Context<Number>& c, const WallFlight<Number>& flight, const Work<Number>& dt,
                StepNumber since, const Happening<Number>& happening) {
  using W = Work<Number>;
  if (faces_when_due(c, flight) != Within::yes) return Waiting::not_due;
  if constexpr (std::is_same_v<Number, double>) {
    if (c.certified()) {
      const auto turn = certified_turn(c, flight);
      if (!turn) return Waiting::not_due;
      return certified_waiting(c, *turn, flight.asked.outer, since, happening, [&c, flight, dt](Finding& f) {
        say_overdue(c, flight, Waiting::overdue, dt, f);
      });
    }
  }
  const W slack = c.time_error(happening.t);
  const Due<W> expected = due(flight);
  if (expected.must_be_none) return Waiting::not_due;
  if (flight.is_plane) return expected.latest + slack * c.scale() < dt ? Waiting::overdue : Waiting::not_due;
  return computed_waiting(c, flight.q, flight.asked, dt, slack);
}

/// How far the particle came beyond the surface in flight, less what it began with, in units of what rounding
/// may do. Lengths for planes, squared lengths for spheres.
template <typename Number>
Work<Number> beyond_wall(const Context<Number>& c, const WallFlight<Number>& flight, const Work<Number>& dt,
                         const Work<Number>& time_error) {
  using W = Work<Number>;
  using std::abs;
  if (flight.is_plane) {
    const W excess = std::min(W(0), flight.gap) - (flight.gap - flight.towards * dt);
    return excess /
           ((flight.gap_error + flight.towards_error * dt) / W(6) + time_error * abs(flight.towards) / W(3));
  }
  const W unit = farthest_beyond(flight.q, c.u(), c.scale(), dt) / (W(6) * c.scale()) +
                 flight.asked.L * time_error * length(flight.q.v) / W(3);
  return excess_of(flight.q, flight.asked.outer, dt) / unit;
}

}  // namespace detail

/// Judges a particle and a surface over its flight until a moment; they wait since the step `since`.
template <typename Number>
Asked judge_wall_flight(const Context<Number>& c, int i, std::size_t n, const Instant<Number>& until,
                        StepNumber since, const Happening<Number>& happening, Told& told) {
  using W = Work<Number>;
  Asked result;
  if (until < c.model.flight(i).since) return result;
  const WallFlight<Number> flight = wall_flight(c, i, n);
  const W dt = elapsed(flight.pair.start, until);
  const bool outer = flight.asked.outer;
  const bool happens = happening.i == i && happening.wall == n;
  const Waiting state = happens ? Waiting::not_due : detail::waiting(c, flight, dt, since, happening);
  if ((state == Waiting::overdue || state == Waiting::lost_a_tie) && told.say(Told::overdue, outer)) {
    result.earliest = false;
    c.tally.demand(Rule::earliest, false, [&](Finding& f) { detail::say_overdue(c, flight, state, dt, f); });
  }
  if (state == Waiting::undecided && told.say(Told::undecided, outer)) {
    result.earliest = false;
    c.tally.undecided(Rule::earliest, [&](Finding& f) {
      f.particles = {c.model.id(i)};
      f.message = detail::wall_name(c, flight) + " graze by less than the rounding of the trace's scalar";
    });
  }
  if (happening.until == Until::ever || told.said(Told::beyond, outer)) return result;
  if (in_region(c, c.model.walls[n], flight.whole, W(0), dt) != Within::yes) return result;
  const W off = detail::beyond_wall(c, flight, dt, c.time_error(happening.t));
  if (!(off > W(6) * c.scale())) return result;
  result.bounds = c.tally.within(Rule::bounds, as_double(off), 6, [&](Finding& f) {
    f.particles = {c.model.id(i)};
    f.equation = "(1)";
    f.message = detail::wall_name(c, flight) +
                fmt::format(" come {} roundings beyond touching in flight", shown(off));
  });
  if (!result.bounds) told.say(Told::beyond, outer);
  return result;
}

}  // namespace tps::check

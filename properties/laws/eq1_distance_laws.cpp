// Eq. (1), docs/eq1.md.
#include "properties/generators/cases.hpp"
#include "properties/generators/numbers.hpp"
#include "properties/generators/pairs.hpp"
#include "properties/law.hpp"
#include "properties/laws/compare.hpp"

namespace tps::properties::eq1 {
namespace {

void flight(Case& c, const Format& format) {
  put_pair(c, format);
  c.numbers.erase("L");
  c.set("dt", number(format));
}

/// |u| of both and the way of both: a distance errs by 3u of it (docs/eq1.md).
Wide lengths_of(const PairState& p, double dt) {
  return norm(wide(p.u_A)) + norm(wide(p.u_B)) + (norm(wide(p.v_A)) + norm(wide(p.v_B))) * abs(Wide(dt));
}

Outcome swap_of_distance(Interview& ask, const Case& c) {
  const PairState p = c.pair();
  const double dt = c.number("dt");
  return same_to("distance with A and B exchanged", {ask.distance(swapped(p), dt), 0, 0},
                 {ask.distance(p, dt), 0, 0}, 6 * ask.u() * lengths_of(p, dt) * kSlack);
}

// The norm errs by 3u: r 1u, its squares, sums and root 2u.
Outcome now_is_the_separation(Interview& ask, const Case& c) {
  const PairState p = c.pair();
  const Wide distance = norm(wide(p.u_B) - wide(p.u_A));
  return at_most("the error of |u_B − u_A|", abs(Wide(ask.distance(p, 0) - distance)),
                 3 * ask.u() * distance * kSlack);
}

// Twice the error of docs/eq1.md, 3u of all lengths involved.
Outcome equal_velocities_keep_it(Interview& ask, const Case& c) {
  PairState p = c.pair();
  p.v_B = p.v_A;
  const Wide lengths = lengths_of(p, c.number("dt"));
  return at_most("the change of the distance",
                 abs(Wide(ask.distance(p, c.number("dt")) - ask.distance(p, 0))),
                 6 * ask.u() * lengths * kSlack);
}

}  // namespace

void add_laws(std::vector<Law>& laws) {
  const std::string page = "docs/eq1.md";
  laws.push_back({{"Eq1Laws.Law1SwapOfNames", "(1) law 1", "A and B may be exchanged, bitwise", page},
                  {Op::distance},
                  cases(flight),
                  swap_of_distance});
  laws.push_back({{"Eq1Laws.Law2NowItIsTheSeparation", "(1) law 2", "at dt = 0 it is |u_B − u_A|", page},
                  {Op::distance},
                  cases(flight),
                  now_is_the_separation});
  laws.push_back({{"Eq1Laws.Law3EqualVelocitiesKeepIt", "(1) law 3",
                   "equal velocities keep the distance constant, to rounding", page},
                  {Op::distance},
                  cases(flight),
                  equal_velocities_keep_it});
}

}  // namespace tps::properties::eq1

// A tethered pair on its way around: eqs. (2), (5) and (3) in turn (docs/eq5.md).
#include "properties/generators/cases.hpp"
#include "properties/generators/numbers.hpp"
#include "properties/law.hpp"
#include "properties/laws/response_errors.hpp"

namespace tps::properties::orbit {
namespace {

constexpr int kEventsOfARevolution = 4;
constexpr double kTheta = 45;

void orbiting_pair(Case& c, const Format& format) {
  c.dimension = 2;
  c.hazard = one_of<std::string>({"along_an_axis", "oblique"});
  const double unit = std::ldexp(1.0, whole(-3, 4));
  const bool oblique = c.hazard == "oblique";
  c.set("u_B", oblique ? Vec3{3 * unit, 4 * unit, 0} : Vec3{unit, 0, 0});
  const double speed = magnitude(format);
  c.set("v_B", oblique ? Vec3{format.rounded(-4 * speed), format.rounded(3 * speed), 0} : Vec3{0, speed, 0});
  c.set("L", (oblique ? 5 : 1) * unit);
  c.set(masses(format));
  c.set("c_retract", one_of({0.0, 0.25, 0.5, 0.875}));
  c.set("c_revolve", one_of({1.0, 0.5, 0.75, 0.9375, 0.0625}));
}

/// B as seen from A, which is put to rest in the origin before each question.
class Orbit {
 public:
  Orbit(Interview& ask, const Case& c)
      : ask_(ask), case_(c), r_(c.vector("u_B")), v_(c.vector("v_B")), L_(c.number("L")) {}

  void respond() {
    const TetherAnswer answer = ask_.tether_response(state(), case_.masses(), case_.number("c_retract"),
                                                     case_.number("c_revolve"), kTheta);
    if (answer.kind != "revolve")
      throw Unanswered{broken("the pair on its orbit does not revolve: " + answer.kind)};
    v_ = ask_.passed(answer.after.v_B - answer.after.v_A);
  }
  void fly() {
    const Time at = ask_.tether_time(state(), L_);
    if (at.verdict != "hit" || !at.t)
      throw Unanswered{
          broken("a pair that closes at 45° flies through its circle; the tether is " + text(at))};
    r_ = ask_.passed(wide(r_) + *at.t * wide(v_));
  }

  WideVector position() const { return wide(r_); }
  Wide speed() const { return norm(wide(v_)); }

 private:
  PairState state() const { return {{}, r_, {}, v_}; }

  Interview& ask_;
  const Case& case_;
  Vec3 r_, v_;
  double L_;
};

// One event changes the relative velocity by eq. (5) with |v_AB|/|v_ŵ| = √2, that is 43u, and eq. (3) 7u
// (Δp/μ ≤ 2|v|; v_A', v_B' together at most 5|v|), and passing it on rounds each component: e = 50u +
// 2u_passed of the speed before. Speeds multiply, so four relative errors add up. The direction errs by
// e/ratio, which the chord doubles as an arc; the flight lands within 40u L (docs/eq2.md) along a path at
// 45°, and where it lands turns the next chord: 80u and 4u_passed an event.
Outcome four_events_a_revolution(Interview& ask, const Case& c) {
  Orbit orbit(ask, c);
  const Encounter start(PairState{{}, c.vector("u_B"), {}, c.vector("v_B")});
  if (start.v_n != 0 || start.distance != Wide(c.number("L")))
    return outside("the pair does not start perpendicular at its limit");
  // At c_revolve = 0 or v = 0 nothing is left that moves on the orbit.
  if (c.number("c_revolve") == 0) return outside("a pair that a revolution stops has no orbit");
  if (start.speed == 0) return outside("a pair at rest has no orbit");
  orbit.respond();
  const Wide speed = orbit.speed();
  const WideVector position = orbit.position();
  for (int event = 0; event < kEventsOfARevolution; ++event) {
    orbit.fly();
    orbit.respond();
  }
  const Wide c_revolve(c.number("c_revolve"));
  const Wide u = ask.u(), u_passed = ask.u_passed();
  const Wide one_event = 50 * u + 2 * u_passed;
  const Wide ratio = speed_ratio(c.number("c_revolve"), kTheta);
  const Wide turn = 2 * one_event / ratio + 80 * u + 4 * u_passed;
  return all_of(at_most("the error of the speed after four events, relative to c_revolve times that before",
                        abs(Wide(orbit.speed() / (c_revolve * speed) - 1)), 4 * one_event / ratio * kSlack),
                at_most("the distance from where the revolution began", norm(orbit.position() - position),
                        4 * turn * Wide(c.number("L")) * kSlack));
}

}  // namespace

void add_laws(std::vector<Law>& laws) {
  laws.push_back({{"OrbitLaws.Law1FourEventsARevolutionAt45Degrees", "(5) law 6",
                   "at θ = 45° a pair on its orbit is back after four revolution events, slower by c_revolve",
                   "docs/eq5.md"},
                  {Op::tether_response, Op::tether_time},
                  cases(orbiting_pair),
                  four_events_a_revolution});
}

}  // namespace tps::properties::orbit

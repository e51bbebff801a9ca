// Two bodies in given conditions, an evaluation of their collision in double, and what share of each bound of
// the trace check it takes up.
#pragma once

#include <cmath>
#include <map>
#include <random>
#include <string>

#include "reference/equations/vector.hpp"
#include "verify/trace_check/rules/conservation.hpp"

namespace tps::check {

/// The largest share of its bound, by quantity; infinite where it is beyond.
using Verdicts = std::map<std::string, double>;

struct Given {
  Vector<double, 3> u_i, u_j, v_i, v_j;
  double m_i, m_j;  ///< as a run has them: of bodies, added up rounded
};

class Bench {
 public:
  struct Law {
    double mass_i = 1, mass_j = 1;
    double c_rebound = 1, c_retract = 0, c_revolve = 1, theta = 45;
    int depth = 0;  ///< loads that made body i
  };
  struct Conditions {
    double across_per_along = 1;  ///< |v_ŵ|/|v_n|
    bool outer = false;
    double speed_of_frame = 1;  ///< of the common motion, by that of the relative one
  };

  explicit Bench(const Law& law) : law_(law), scene_(scene_of(law)), model_(scene_, kDouble) {}

  /// Random positions and velocities; the members of body i get random masses that add up to about mass_i.
  Given draw(const Conditions& conditions) {
    Given given;
    const double size = std::exp2(uniform(-20, 20));
    const double speed = std::exp2(uniform(-20, 20));
    const Vector<double, 3> axis = direction();
    given.u_i = 3 * size * direction();
    given.u_j = given.u_i + size * axis;
    const Vector<double, 3> other = direction();
    const Vector<double, 3> w = (other - other.dot(axis) * axis).normalized();
    const double along = conditions.outer ? speed : -speed;
    const Vector<double, 3> v = along * axis + conditions.across_per_along * speed * w;
    // Each body takes its part of the motion by the other's mass, so that the lighter one moves.
    const double share = law_.mass_j / (law_.mass_i + law_.mass_j);
    const Vector<double, 3> way = direction();
    const Vector<double, 3> common = conditions.speed_of_frame * speed * uniform(0, 1) * way *
                                     (conditions.speed_of_frame == 1 ? std::min(share, 1 - share) : 1);
    given.v_i = common - share * v;
    given.v_j = common + (1 - share) * v;
    masses(given);
    return given;
  }

  Verdicts judge(const Given& given, Kind kind, const Vector<double, 3>& dp, const Vector<double, 3>& after_i,
                 const Vector<double, 3>& after_j) {
    const EventLine<double> event = event_of(given, kind, dp, after_i, after_j);
    const BodiesNow<double> b = bodies(given, event);
    const Expected<long double> expected =
        kind == Kind::revolve
            ? Expected<long double>{by_eq5(b, model_.rules.of(0, 1), kDouble.u), kRoundingsOfImpulse, "(5)"}
            : Expected<long double>{by_eq4(b, model_.rules.of(0, 1).c_rebound, false, kDouble.u),
                                    kRoundingsOfImpulse, "(4)"};
    Verdicts verdicts;
    add(
        verdicts, kind == Kind::revolve ? "dp by (5)" : "dp by (4)",
        [&](const auto& c) { judge_dp(c, event, b, expected); }, Rule::impulse);
    add(
        verdicts, "velocity by (3)",
        [&](const auto& c) {
          judge_free_velocities(c, event, b, expected, exchange_of(c, event, b, expected));
        },
        Rule::impulse);
    add(
        verdicts, "conservation",
        [&](const auto& c) { judge_conservation(c, event, b, expected, exchange_of(c, event, b, expected)); },
        Rule::conservation);
    return verdicts;
  }

  Verdicts judge_load(const Given& given, const Vector<double, 3>& dp, const Vector<double, 3>& kept,
                      const Vector<double, 3>& after) {
    EventLine<double> event = event_of(given, Kind::rebound, dp, after, after);
    const BodiesNow<double> b = bodies(given, event);
    const Expected<long double> expected{by_eq4(b, model_.rules.of(0, 1).c_rebound, false, kDouble.u),
                                         kRoundingsOfImpulse, "(4)"};
    Verdicts verdicts;
    add(
        verdicts, "v_load by (6)", [&](const auto& c) { check::judge_load(c, event, b, expected); },
        Rule::impulse);
    event.dp_stored = vec(kept);
    event.involved.clear();
    add(
        verdicts, "stored by (7)", [&](const auto& c) { check::judge_load(c, event, b, expected); },
        Rule::impulse);
    event.involved = event_of(given, Kind::rebound, dp, after, after).involved;
    add(
        verdicts, "momentum of load", [&](const auto& c) { judge_load_conservation(c, event, b); },
        Rule::conservation);
    return verdicts;
  }

  BodiesNow<double> bodies_of(const Given& given) const {
    return bodies(given, event_of(given, Kind::revolve, given.v_i, given.v_i, given.v_j));
  }
  /// The pair's rules in another type of number.
  template <typename Number>
  PairRules<Number> rules() const {
    return RuleTable<Number>(scene_, {Work<Number>(0x1p-53), Work<Number>(0x1p-1074), 53, false}).of(0, 1);
  }

  double uniform(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }

 private:
  inline static const Precision<double> kDouble{0x1p-53L, 0x1p-1074L, 53, false};

  static Scene scene_of(const Law& law) {
    Scene scene;
    scene.dimension = 3;
    scene.species.resize(2);
    scene.species[0].mass = law.mass_i;
    scene.species[1].mass = law.mass_j;
    PairLaw& pair = scene.pairs.emplace_back();
    pair.species_b = 1;
    pair.blocking = BlockingLaw{1, law.c_rebound};
    pair.tethering.emplace();
    pair.tethering->distance = 2;
    pair.tethering->c_retract = law.c_retract;
    pair.tethering->c_revolve = law.c_revolve;
    pair.tethering->theta_revolve_deg = law.theta;
    scene.particles.resize(2);
    for (int n = 0; n < 2; ++n)
      scene.particles[static_cast<std::size_t>(n)].id = scene.particles[static_cast<std::size_t>(n)].species =
          n;
    return scene;
  }

  Vector<double, 3> direction() {
    std::normal_distribution<double> normal;
    const double z = normal(random_), y = normal(random_),
                 x = normal(random_);  // in the same order everywhere
    return Vector<double, 3>(x, y, z).normalized();
  }

  void masses(Given& given) {
    given.m_i = law_.mass_i;
    given.m_j = law_.mass_j;
    mass_i_ = law_.mass_i;
    for (int n = 0; n < law_.depth; ++n) {
      const double member = law_.mass_i * uniform(.1, 1);
      given.m_i += member;
      mass_i_ += member;
    }
  }

  static Vec<double> vec(const Vector<double, 3>& x) { return {{x[0], x[1], x[2]}}; }

  EventLine<double> event_of(const Given& given, Kind kind, const Vector<double, 3>& dp,
                             const Vector<double, 3>& after_i, const Vector<double, 3>& after_j) const {
    EventLine<double> event;
    event.kind = kind;
    event.i = 0;
    event.j = 1;
    event.dp = vec(dp);
    event.involved = {{0, vec(given.u_i), vec(given.v_i), vec(given.u_i), vec(after_i)},
                      {1, vec(given.u_j), vec(given.v_j), vec(given.u_j), vec(after_j)}};
    return event;
  }

  BodiesNow<double> bodies(const Given&, const EventLine<double>& event) const {
    BodiesNow<double> b = bodies_now(model_, event, 0.0L);
    b.inverse_i = 1 / mass_i_;
    b.mu = 1 / (b.inverse_i + b.inverse_j);
    b.loads = law_.depth;
    return b;
  }

  template <typename Judge>
  void add(Verdicts& verdicts, const std::string& quantity, Judge judge, Rule rule) {
    verdicts[quantity] = share(quantity, judge, rule);
  }

  /// The largest share so far of what a judge of this quantity calls the bound of its rule.
  template <typename Judge>
  double share(const std::string& quantity, Judge judge, Rule rule) {
    Verdict& verdict = verdicts_[quantity];
    judge(Context<double>{model_, verdict.tally, Timing::stable, false, exact_, turns_,
                          [](const Instant<double>&) { return std::string(); }});
    return verdict.report.of(rule).violated > 0 ? HUGE_VAL : verdict.report.of(rule).worst;
  }

  struct Verdict {
    CheckReport report;
    Tally tally{report, 1, 1};
  };

  Law law_;
  Scene scene_;
  Model<double> model_;
  long double mass_i_ = 1;
  certified::ExactTiming exact_;
  Turns<double> turns_{exact_};
  std::map<std::string, Verdict> verdicts_;
  std::mt19937_64 random_{20260101};
};

}  // namespace tps::check

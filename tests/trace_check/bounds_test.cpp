// Bounds are tight: over the whole range of conditions an honest evaluation in double stays below half of
// each, and in every class of conditions some comes to a thirtieth.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <string>

#include "reference/equations/eq3_apply_impulse.hpp"
#include "reference/equations/eq6_load_velocity.hpp"
#include "reference/equations/eq7_restitution_impulse.hpp"
#include "reference/equations/tether_response.hpp"
#include "tests/trace_check/bound_bench.hpp"
#include "verify/trace_check/wide.hpp"

namespace tps::check {
namespace {

constexpr double kMost = 0.5, kLeast = 0.03;

/// Largest shares by quantity and class of conditions.
class Shares {
 public:
  void note(const std::string& quantity, const std::string& conditions, double share) {
    double& worst = worst_[quantity][conditions];
    worst = std::max(worst, share);
  }
  /// A single class may have easier conditions than others; none may be beyond half, and each quantity has to
  /// be tight in every class.
  void expect_tight(double least = kLeast) const {
    for (const auto& [quantity, classes] : worst_) {
      double lowest = 1, highest = 0;
      for (const auto& [conditions, share] : classes) {
        EXPECT_LE(share, kMost) << quantity << ", " << conditions;
        EXPECT_GE(share, least) << quantity << ", " << conditions;
        lowest = std::min(lowest, share);
        highest = std::max(highest, share);
      }
      std::printf("  %-16s %3zu classes, largest share of the bound %.3f to %.3f\n", quantity.c_str(),
                  classes.size(), lowest, highest);
    }
  }

 private:
  std::map<std::string, std::map<std::string, double>> worst_;
};

constexpr int kCases = 400;

TEST(Bounds, OfReboundsAreTightForAnyMassesAndAngles) {
  Shares shares;
  for (const double ratio : {1e-15, 1e-6, 1.0, 49.0, 1e8, 1e15}) {
    for (const double grazing : {1.0, 1e-3, 1e3}) {
      for (const double c : {0.0, 0.37, 1.0}) {
        Bench bench({.mass_i = 3, .mass_j = 3 * ratio, .c_rebound = c});
        for (int n = 0; n < kCases; ++n) {
          const Given given = bench.draw({.across_per_along = grazing, .outer = false});
          const auto frame = collision_frame<double, 3>(given.u_i, given.u_j, given.v_i, given.v_j);
          const Vector<double, 3> dp = collision_impulse<double, 3>(frame, given.m_i, given.m_j, c);
          const auto v = apply_impulse<double, 3>(given.m_i, given.m_j, given.v_i, given.v_j, dp);
          const Verdicts verdicts = bench.judge(given, Kind::rebound, dp, v.v_A, v.v_B);
          const std::string of = fmt::format("m_B/m_A {:g}, |v_w|/|v_n| {:g}, c {:g}", ratio, grazing, c);
          for (const auto& [quantity, share] : verdicts) shares.note(quantity, of, share);
        }
      }
    }
  }
  shares.expect_tight();
}

TEST(Bounds, OfRevolutionsAreTightForAnyAngleAndCondition) {
  Shares shares;
  for (const double theta : {1e-6, 1.0, 22.0, 45.0, 71.0, 90 - 1e-6}) {
    for (const double across : {1e3, 1.0, 1e-4, 1e-9, 1e-14}) {
      for (const double ratio : {1e-12, 0.9, 1e15}) {
        for (const double c : {1.0, 0.5, 1e-300}) {
          Bench bench({.mass_i = 3, .mass_j = 3 * ratio, .c_revolve = c, .theta = theta});
          for (int n = 0; n < kCases / 4; ++n) {
            const Given given = bench.draw({.across_per_along = across, .outer = true});
            const auto frame = collision_frame<double, 3>(given.u_i, given.u_j, given.v_i, given.v_j);
            if (norm<double, 3>(frame.v_w) == 0) continue;
            const Vector<double, 3> dp = revolution_impulse<double, 3>(frame, given.m_i, given.m_j, c, theta);
            const auto v = apply_impulse<double, 3>(given.m_i, given.m_j, given.v_i, given.v_j, dp);
            const Verdicts verdicts = bench.judge(given, Kind::revolve, dp, v.v_A, v.v_B);
            const std::string of =
                fmt::format("theta {:g}, |v_w|/|v_n| {:g}, m_B/m_A {:g}, c {:g}", theta, across, ratio, c);
            for (const auto& [quantity, share] : verdicts) {
              // Beside a pair left at rest the energy of a rounding is of second order; so is its share.
              const bool at_rest = c < 1e-9 && theta > 1 && quantity == "conservation";
              shares.note(quantity, of, at_rest ? std::sqrt(share) : share);
            }
          }
        }
      }
    }
  }
  shares.expect_tight();
}

// What decides between retraction and revolution, as a run computes it and as it is.
TEST(Bounds, OfTheKindOfATetheringCollisionAreTight) {
  Shares shares;
  for (const double theta : {1e-6, 22.0, 45.0, 89.0, 90 - 1e-6}) {
    for (const double across : {1e3, 1.0, 1e-4, 1e-12}) {
      const double c = .7;
      Bench bench({.c_retract = c, .theta = theta});
      const PairRules<double> rules = bench.rules<double>();
      for (int n = 0; n < kCases; ++n) {
        const Given given = bench.draw({.across_per_along = across, .outer = true});
        const auto frame = collision_frame<double, 3>(given.u_i, given.u_j, given.v_i, given.v_j);
        const BodiesNow<double> b = bench.bodies_of(given);
        const double tangential = norm<double, 3>(frame.v_w);
        const long double computed =
            static_cast<long double>(std::abs(c * frame.v_n)) - tan_degrees(theta) * tangential;
        const long double exact =
            static_cast<long double>(c) * b.v_n() - rules.tan_theta * length(b.across());
        shares.note("kind", fmt::format("theta {:g}, |v_w|/|v_n| {:g}", theta, across),
                    static_cast<double>(std::fabs(computed - exact) / margin_of_kind(b, rules, 0x1p-53L)));
      }
    }
  }
  shares.expect_tight(.01);
}

TEST(Bounds, OfLoadsAreTightForAnyMassesAndDepth) {
  Shares shares;
  for (const double ratio : {1e-15, 1e-4, 0.9, 1e7, 1e15}) {
    for (const int depth : {0, 3, 8}) {
      for (const double speeds : {1.0, 1e6}) {
        Bench bench({.mass_i = 3, .mass_j = 3 * ratio, .c_rebound = .7, .depth = depth});
        for (int n = 0; n < kCases; ++n) {
          Given given = bench.draw({.across_per_along = 1, .outer = false, .speed_of_frame = speeds});
          const auto frame = collision_frame<double, 3>(given.u_i, given.u_j, given.v_i, given.v_j);
          const Vector<double, 3> dp = collision_impulse<double, 3>(frame, given.m_i, given.m_j, .7);
          const auto kept = restitution_impulse<double, 3>(given.m_i, given.m_j, given.v_i, given.v_j, dp);
          const auto v = load_velocity<double, 3>(given.m_i, given.m_j, given.v_i, given.v_j);
          const std::string of = fmt::format("m_B/m_A {:g}, {} loads, frame {:g}", ratio, depth, speeds);
          for (const auto& [quantity, share] : bench.judge_load(given, dp, kept, v))
            shares.note(quantity, of, share);
        }
      }
    }
  }
  shares.expect_tight();
}

/// A number of the run, to 833 bits.
Vec<Wide> wide(const Vec<long double>& x) {
  return widened<Wide>(x);
}

BodiesNow<Wide> wide(const BodiesNow<double>& b) {
  BodiesNow<Wide> w;
  w.i = b.i;
  w.j = b.j;
  w.r = wide(b.r);
  w.v_i = wide(b.v_i);
  w.v_j = wide(b.v_j);
  w.v = w.v_j - w.v_i;
  w.inverse_i = Wide(1) / Wide(mass_of(b.inverse_i));
  w.inverse_j = Wide(1) / Wide(mass_of(b.inverse_j));
  w.mu = Wide(1) / (w.inverse_i + w.inverse_j);
  return w;
}

double off(const Vec<long double>& x, const Vec<Wide>& y) {
  return as_double(largest(wide(x) - y));
}

// The check's own arithmetic, long double, beside 833 bits: below a hundredth of every bound.
TEST(Bounds, AreAHundredTimesTheErrorOfTheCheckItself) {
  const Wide u = ldexp(Wide(1), -53);
  for (const double theta : {1e-6, 22.0, 89.0, 90 - 1e-6}) {
    for (const double across : {1e3, 1.0, 1e-6, 1e-13}) {
      for (const double ratio : {1e-15, 0.9, 1e15}) {
        Bench bench({.mass_i = 3, .mass_j = 3 * ratio, .c_rebound = .3, .c_revolve = .7, .theta = theta});
        for (int n = 0; n < 15; ++n) {
          const BodiesNow<double> b =
              bench.bodies_of(bench.draw({.across_per_along = across, .outer = true}));
          const BodiesNow<Wide> w = wide(b);
          const auto revolution = by_eq5(b, bench.rules<double>(), 0x1p-53L);
          const auto wide_revolution = by_eq5(w, bench.rules<Wide>(), u);
          EXPECT_LE(off(revolution.dp, wide_revolution.dp),
                    .01 * kRoundingsOfImpulse * as_double(revolution.error));
          EXPECT_LE(off(revolution.after, wide_revolution.after) * as_double(b.mu),
                    .01 * kRoundingsOfImpulse * as_double(revolution.error));
          EXPECT_LE(
              std::fabs(as_double(Wide(length(wide(revolution.after)) - length(wide_revolution.after)))),
              .01 * kRoundingsOfImpulse * as_double(revolution.speed_error / b.mu));
          const auto pull = by_eq4(b, .3, true, 0x1p-53L);
          EXPECT_LE(off(pull.dp, by_eq4(w, Wide(.3), true, u).dp),
                    .01 * kRoundingsOfImpulse * as_double(pull.error));
          EXPECT_LE(off(by_eq6(b, 0x1p-53L).velocity, by_eq6(w, u).velocity),
                    .01 * as_double(by_eq6(b, 0x1p-53L).error));
        }
      }
    }
  }
}

// Four times the bound is seen, and the bound is small: a speed wrong by 2^-44 after a revolution, whatever
// the condition of its direction.
TEST(Bounds, SeeAWrongImpulseAndAWrongSpeedInEveryCondition) {
  for (const double theta : {1e-6, 22.0, 45.0, 90 - 1e-6}) {
    for (const double across : {1e3, 1.0, 1e-4, 1e-12, 3e-16}) {
      for (const double ratio : {1e-15, 0.9, 1e15}) {
        for (int n = 0; n < 20; ++n) {
          Bench bench({.mass_i = 3, .mass_j = 3 * ratio, .c_revolve = .5, .theta = theta});
          for (int skipped = 0; skipped < n; ++skipped) bench.uniform(0, 1);
          const Given given = bench.draw({.across_per_along = across, .outer = true});
          const auto frame = collision_frame<double, 3>(given.u_i, given.u_j, given.v_i, given.v_j);
          if (norm<double, 3>(frame.v_w) == 0) continue;
          const double mu = reduced_mass<double>(given.m_i, given.m_j);
          const Vector<double, 3> after = (1 + 0x1p-44) * revolution<double, 3>(frame, .5, theta).v_AB_after;
          const Vector<double, 3> dp = mu * (frame.v_AB - after);
          const auto v = apply_impulse<double, 3>(given.m_i, given.m_j, given.v_i, given.v_j, dp);
          const Verdicts verdicts = bench.judge(given, Kind::revolve, dp, v.v_A, v.v_B);
          EXPECT_EQ(verdicts.at("conservation"), HUGE_VAL) << theta << ' ' << across << ' ' << ratio;

          const auto right = by_eq5(bench.bodies_of(given), bench.rules<double>(), 0x1p-53L);
          const auto bound = as_double(4 * kRoundingsOfImpulse * right.error);
          Bench again({.mass_i = 3, .mass_j = 3 * ratio, .c_revolve = .5, .theta = theta});
          const Vector<double, 3> wrong =
              Vector<double, 3>(as_double(right.dp[0]), as_double(right.dp[1]), as_double(right.dp[2])) +
              bound * Vector<double, 3>::UnitX();
          EXPECT_EQ(again.judge(given, Kind::revolve, wrong, v.v_A, v.v_B).at("dp by (5)"), HUGE_VAL);
        }
      }
    }
  }
}

// Beside a heavy body the rounding of a light one's velocity does not count.
TEST(Bounds, SeeAWrongCommonVelocityOfAHeavyAndALightBody) {
  for (const double ratio : {1e-15, 1e-12, 1e-4, 0.9, 1e7, 1e15}) {
    for (int n = 0; n < 20; ++n) {
      Bench bench({.mass_i = 3, .mass_j = 3 * ratio});
      for (int skipped = 0; skipped < n; ++skipped) bench.uniform(0, 1);
      const Given given = bench.draw({});
      const auto frame = collision_frame<double, 3>(given.u_i, given.u_j, given.v_i, given.v_j);
      const Vector<double, 3> dp = collision_impulse<double, 3>(frame, given.m_i, given.m_j, 1);
      const auto kept = restitution_impulse<double, 3>(given.m_i, given.m_j, given.v_i, given.v_j, dp);
      const double weighted =
          (given.m_i * given.v_i.cwiseAbs().maxCoeff() + given.m_j * given.v_j.cwiseAbs().maxCoeff()) /
          (given.m_i + given.m_j);
      const Vector<double, 3> wrong = load_velocity<double, 3>(given.m_i, given.m_j, given.v_i, given.v_j) +
                                      0x1p-47 * weighted * Vector<double, 3>::UnitY();
      const Verdicts verdicts = bench.judge_load(given, dp, kept, wrong);
      EXPECT_EQ(verdicts.at("v_load by (6)"), HUGE_VAL) << ratio;
      EXPECT_EQ(verdicts.at("momentum of load"), HUGE_VAL) << ratio;
    }
  }
}

}  // namespace
}  // namespace tps::check

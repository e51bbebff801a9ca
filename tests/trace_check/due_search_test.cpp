// Whether the interval in which an event may be due holds what the equations compute, by search for the
// worst: the share of its bounds that takes, over random pairs and then step by step uphill (docs/check.md,
// "When an event is due").
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "reference/equations/eq2_collision_time.hpp"
#include "reference/equations/eq2_paper_time.hpp"
#include "verify/trace_check/rules/bounds.hpp"

namespace tps::check {
namespace {

using W = long double;

template <typename S, int D>
class WorstOfDue {
 public:
  WorstOfDue(bool outer, Timing timing) : outer_(outer), timing_(timing), random_(20261127) {}

  /// The largest share found.
  W search(int pairs, int climbers, int steps) {
    std::vector<std::pair<W, Pair>> best;
    for (int n = 0; n < pairs; ++n) {
      const Pair pair = random_pair();
      best.emplace_back(share(pair), pair);
    }
    const auto higher = [](const auto& a, const auto& b) { return a.first > b.first; };
    std::partial_sort(best.begin(), best.begin() + climbers, best.end(), higher);
    W worst(0);
    for (int n = 0; n < climbers; ++n) {
      auto& [height, pair] = best[static_cast<std::size_t>(n)];
      for (int step = 0; step < steps; ++step) {
        const Pair near = beside(pair, std::pow(10, -16 * part()));
        if (!is_sane(near)) continue;
        const W there = share(near);
        if (there < height) continue;
        height = there;
        pair = near;
      }
      worst = std::max(worst, height);
    }
    return worst;
  }

 private:
  using V = Vector<S, D>;
  struct Pair {
    V u_A, u_B, v_A, v_B;
    S L;
    std::array<V*, 4> vectors() { return {&u_A, &u_B, &v_A, &v_B}; }
  };

  double part() { return std::uniform_real_distribution<double>(0, 1)(random_); }

  CollisionTime<S> answer(const Pair& p) const {
    if (timing_ == Timing::paper)
      return outer_ ? paper_tether_time<S, D>(p.u_A, p.u_B, p.v_A, p.v_B, p.L)
                    : paper_block_time<S, D>(p.u_A, p.u_B, p.v_A, p.v_B, p.L);
    return outer_ ? tether_time<S, D>(p.u_A, p.u_B, p.v_A, p.v_B, p.L)
                  : block_time<S, D>(p.u_A, p.u_B, p.v_A, p.v_B, p.L);
  }

  /// Whether the answer lies within the bounds times `scale`, in time and in distance.
  bool holds(const Pair& p, const CollisionTime<S>& computed, const W& scale) const {
    const W u = std::ldexp(W(1), -std::numeric_limits<S>::digits);
    RelativeFlight<W> flight;
    for (int k = 0; k < D; ++k) {
      flight.r[static_cast<std::size_t>(k)] = W(p.u_B[k]) - W(p.u_A[k]);
      flight.v[static_cast<std::size_t>(k)] = W(p.v_B[k]) - W(p.v_A[k]);
    }
    const Quadratic<W> q = quadratic_of<W>(flight, W(p.L), u, timing_, scale);
    const Due<W> expected = due<W>(q, {outer_, W(p.L), false});
    if (!computed.t) return expected.can_be_none;
    if (!std::isfinite(*computed.t)) return true;
    const W t = *computed.t;
    if (expected.must_be_none || t < expected.earliest || t > expected.latest) return false;
    return detail::excess_of(q, outer_, t) <= farthest_beyond(q, u, scale, t);
  }

  W share(const Pair& p) const {
    const W nothing = 0.02L, everything = 64;
    const CollisionTime<S> computed = answer(p);
    if (p.v_A == p.v_B || holds(p, computed, nothing)) return nothing;
    W below = nothing, above = everything;
    for (int n = 0; n < 14; ++n) {
      const W middle = std::sqrt(below * above);
      (holds(p, computed, middle) ? above : below) = middle;
    }
    return above;
  }

  /// A third is aimed to graze, in a third the pair starts near its limit.
  Pair random_pair() {
    Pair p;
    const auto fill = [&](V& x, double size) {
      for (int k = 0; k < D; ++k) x[k] = S(size * (2 * part() - 1));
    };
    fill(p.u_A, 1);
    fill(p.u_B, std::pow(10, 3 * part()));
    fill(p.v_A, 1);
    fill(p.v_B, 1);
    if (part() < .5) p.u_A.setZero();
    if (part() < .5) p.v_A.setZero();
    p.L = S(std::pow(2, part()));
    const double kind = part(), near_one = 1 + (2 * part() - 1) * std::pow(10, -8 * part());
    const Eigen::Matrix<double, D, 1> r = (p.u_B - p.u_A).template cast<double>();
    const double distance = r.norm();
    if (kind < 1. / 3 && p.L * near_one < distance) {
      V direction;
      fill(direction, 1);
      Eigen::Matrix<double, D, 1> across = direction.template cast<double>();
      across = (across - across.dot(r) / (distance * distance) * r).normalized();
      const double sine = p.L * near_one / distance;
      for (int k = 0; k < D; ++k)
        p.v_B[k] = S(p.v_A[k] - std::sqrt(1 - sine * sine) * r[k] / distance + sine * across[k]);
    } else if (kind < 2. / 3) {
      p.L = S(distance * near_one);
    }
    return p;
  }

  /// Some numbers a little changed, some to the next one.
  Pair beside(Pair p, double size) {
    const auto move = [&](S& x) {
      const double kind = part();
      if (kind < .3)
        x = S(x * (1 + size * (2 * part() - 1)));
      else if (kind < .5)
        x = std::nextafter(x, part() < .5 ? S(1e9) : S(-1e9));
    };
    for (V* vector : p.vectors()) {
      for (int k = 0; k < D; ++k) move((*vector)[k]);
    }
    move(p.L);
    return p;
  }

  static bool is_sane(Pair p) {
    for (const V* vector : p.vectors()) {
      for (int k = 0; k < D; ++k) {
        if ((*vector)[k] != 0 && (std::abs((*vector)[k]) < S(1e-9) || std::abs((*vector)[k]) > S(1e9)))
          return false;
      }
    }
    return p.L > S(1e-3) && (p.u_B - p.u_A).norm() > S(1e-6);
  }

  bool outer_;
  Timing timing_;
  std::mt19937_64 random_;
};

/// A count of roundings that all add up is not met by search, which gets less far the more of them there are;
/// a rounding left out of the count is seen as a share above this one.
constexpr W kMostFound = 0.6L, kLeastFound = 0.15L;

template <typename S, int D>
void expect_to_hold(Timing timing) {
  for (const bool outer : {false, true}) {
    const W worst = WorstOfDue<S, D>(outer, timing).search(20000, 8, 4000);
    EXPECT_LE(worst, kMostFound) << (outer ? "outer, " : "inner, ") << D << " dimensions";
    EXPECT_GE(worst, kLeastFound) << (outer ? "outer, " : "inner, ") << D << " dimensions";
    std::printf("%s limit, %d dimensions, %d bits: %.2Lf of the bound\n", outer ? "outer" : "inner", D,
                std::numeric_limits<S>::digits, worst);
  }
}

TEST(DueSearch, StableTimesOfDoublesHold) {
  expect_to_hold<double, 2>(Timing::stable);
  expect_to_hold<double, 3>(Timing::stable);
}

TEST(DueSearch, StableTimesOfFloatsHold) {
  expect_to_hold<float, 2>(Timing::stable);
  expect_to_hold<float, 3>(Timing::stable);
}

TEST(DueSearch, PrintedTimesHold) {
  expect_to_hold<double, 3>(Timing::paper);
}

}  // namespace
}  // namespace tps::check

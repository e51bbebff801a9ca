#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "properties/generators/pairs.hpp"
#include "properties/lifted.hpp"
#include "reference/equations/eq2_collision_time.hpp"

namespace tps::properties {
namespace {

template <int D>
CollisionTime<double> block(const Pair<D>& p, double L) {
  return block_time(p.u_A, p.u_B, p.v_A, p.v_B, L);
}

template <int D>
CollisionTime<double> tether(const Pair<D>& p, double L) {
  return tether_time(p.u_A, p.u_B, p.v_A, p.v_B, L);
}

bool same(const CollisionTime<double>& x, const CollisionTime<double>& y) {
  return x.verdict == y.verdict && x.t == y.t;
}

// How far from L a `hit` may land, worst case. With D off by δD the squared distance is off by δD/a, the
// distance by δD/(2aL). First form: a L² 5u, |r × v|² 4u relative and 6u |r × v||r||v| from its minors (|r ×
// v| ≤ |v| L): 5u L + 3u |r|. Second form (|r| < 2L at a hit): h² 12u a L², a c 20u a L²: 16u L ≤ 8u (|r| +
// L). The time's own roundings: c 4u, √D, sum, quotient and a 6u, times the way |v|t ≤ |r| + L. Rounding r
// and v: 1u of each way. In all 20u (|r| + L).
Wide landing_error(Wide r, Wide L) {
  return 20 * u * (r + L) * kSlack;
}

template <int D>
bool lands(const Pair<D>& p, const CollisionTime<double>& at) {
  const Vector<Wide, D> r = wide<D>(p.u_B) - wide<D>(p.u_A);
  const Vector<Wide, D> v = wide<D>(p.v_B) - wide<D>(p.v_A);
  const Wide miss = Vector<Wide, D>(r + v * Wide(*at.t)).norm() - Wide(p.L);
  return std::abs(miss) <= landing_error(r.norm(), p.L);
}

template <int D>
Pair<D> swapped(const Pair<D>& p) {
  return {p.aim, p.u_B, p.u_A, p.v_B, p.v_A, p.L};
}

template <int D>
void law1() {
  const Pair<D> p = *pair<D>();
  RC_ASSERT(same(block(p, p.L), block(swapped(p), p.L)));
  RC_ASSERT(same(tether(p, p.L), tether(swapped(p), p.L)));
}

template <int D>
void law2() {
  const Pair<D> p = *pair<D>();
  const double s = std::ldexp(1.0, *rc::gen::inRange(-40, 40));
  const Pair<D> faster{p.aim, p.u_A, p.u_B, p.v_A * s, p.v_B * s, p.L};
  const Pair<D> larger{p.aim, p.u_A * s, p.u_B * s, p.v_A * s, p.v_B * s, p.L * s};
  for (const auto query : {block<D>, tether<D>}) {
    const CollisionTime<double> at = query(p, p.L), sooner = query(faster, p.L);
    RC_ASSERT(same(query(larger, larger.L), at));
    RC_ASSERT(sooner.verdict == at.verdict);
    RC_ASSERT(!at.t || *sooner.t == *at.t / s);
  }
}

// Two limits farther apart than both landings can err are passed in their order.
template <int D>
void law3() {
  const Pair<D> p = *pair<D>();
  const CollisionTime<double> inner = block(p, p.L);
  RC_PRE(inner.verdict == TimingVerdict::hit);
  const double larger = p.L * (1 + std::ldexp(1.0, *rc::gen::inRange(-48, 3)));
  RC_PRE(Wide(larger) - Wide(p.L) > 2 * landing_error(p.r().norm(), larger));
  const CollisionTime<double> outer = block(p, larger);
  RC_ASSERT(outer.t.has_value());
  RC_ASSERT(*outer.t <= *inner.t);
}

template <int D>
void law4() {
  const Pair<D> p = *pair<D>();
  const CollisionTime<double> blocked = block(p, p.L), pulled = tether(p, p.L);
  RC_CLASSIFY(blocked.verdict == TimingVerdict::hit);
  RC_CLASSIFY(pulled.verdict == TimingVerdict::hit);
  if (blocked.verdict == TimingVerdict::hit) RC_ASSERT(lands(p, blocked));
  if (pulled.verdict == TimingVerdict::hit) RC_ASSERT(lands(p, pulled));
}

}  // namespace

RC_GTEST_PROP(Eq2Laws, Law1SwapOfNames2D, ()) {
  law1<2>();
}
RC_GTEST_PROP(Eq2Laws, Law1SwapOfNames3D, ()) {
  law1<3>();
}
RC_GTEST_PROP(Eq2Laws, Law2PowersOfTwo2D, ()) {
  law2<2>();
}
RC_GTEST_PROP(Eq2Laws, Law2PowersOfTwo3D, ()) {
  law2<3>();
}
RC_GTEST_PROP(Eq2Laws, Law3ALargerLimitIsNotLater2D, ()) {
  law3<2>();
}
RC_GTEST_PROP(Eq2Laws, Law3ALargerLimitIsNotLater3D, ()) {
  law3<3>();
}
RC_GTEST_PROP(Eq2Laws, Law4AHitIsAtTheLimit2D, ()) {
  law4<2>();
}
RC_GTEST_PROP(Eq2Laws, Law4AHitIsAtTheLimit3D, ()) {
  law4<3>();
}

}  // namespace tps::properties

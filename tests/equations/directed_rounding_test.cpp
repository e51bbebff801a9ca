// The last rounding of a response, directed: signs, least change, exactness over the range.
#include "reference/equations/directed_rounding.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "reference/equations/collision_frame.hpp"
#include "reference/equations/eq4_collision_impulse.hpp"
#include "tests/equations/every_scalar.hpp"

namespace tps::test {
namespace {

/// The archetype does what equations need and no more; integers of it are not among that.
#ifdef TPS_WIDE_SCALARS
using DirectedScalars = testing::Types<Quad, Mp50, Mp100>;
#else
using DirectedScalars = testing::Types<float, double, long double>;
#endif

template <typename Scalar>
class DirectedRounding : public testing::Test {};
TYPED_TEST_SUITE(DirectedRounding, DirectedScalars, ScalarName);

template <typename Scalar, int D>
struct Answered {
  Vector<Scalar, D> u_A, u_B;
  Scalar m_A, m_B;
  PairVelocities<Scalar, D> before, after;
  Leaving leaving;

  PairVelocities<Scalar, D> directed_after() const {
    return directed<Scalar, D>(u_A, u_B, m_A, m_B, after, leaving);
  }
};

/// A pair without restitution, so that the sign of v_n' is all rounding; masses equal, unequal, infinite.
template <typename Scalar, int D>
Answered<Scalar, D> at_rest_along_the_axis(std::mt19937_64& random, int n) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::uniform_int_distribution<int> shift(-20, 20);
  const auto vector = [&](int exponent) {
    Vector<Scalar, D> x;
    for (int k = 0; k < D; ++k) x[k] = Scalar(std::ldexp(uniform(random), exponent));
    return x;
  };
  Answered<Scalar, D> c;
  c.u_A = vector(0);
  c.u_B = vector(shift(random) / 4);
  c.before = {vector(0), vector(shift(random))};
  c.m_A = Scalar(1 + n % 2);
  c.m_B = n % 5 == 0 ? infinity<Scalar>() : Scalar(std::ldexp(1., n % 3 == 0 ? shift(random) : 0));
  const CollisionFrame<Scalar, D> frame =
      collision_frame<Scalar, D>(c.u_A, c.u_B, c.before.v_A, c.before.v_B);
  c.leaving = frame.v_n < Scalar(0) ? Leaving::apart : Leaving::together;
  const Vector<Scalar, D> dp = collision_impulse<Scalar, D>(frame, c.m_A, c.m_B, Scalar(0));
  c.after = apply_impulse<Scalar, D>(c.m_A, c.m_B, c.before.v_A, c.before.v_B, dp);
  return c;
}

template <typename Scalar, int D>
Scalar fastest(const Answered<Scalar, D>& c) {
  using std::abs;
  Scalar most(0);
  for (int k = 0; k < D; ++k) {
    most = std::max({most, Scalar(abs(c.before.v_A[k])), Scalar(abs(c.before.v_B[k])),
                     Scalar(abs(c.after.v_A[k])), Scalar(abs(c.after.v_B[k]))});
  }
  return most;
}

/// What became of one response. @return whether directed rounding changed it.
template <typename Scalar, int D>
bool judge(const Answered<Scalar, D>& c) {
  using std::abs;
  const PairVelocities<Scalar, D> v = c.directed_after();
  EXPECT_TRUE((detail::leaves<Scalar, D>(c.leaving, c.u_A, c.u_B, v)));
  const PairVelocities<Scalar, D> again = directed<Scalar, D>(c.u_A, c.u_B, c.m_A, c.m_B, v, c.leaving);
  EXPECT_TRUE(again.v_A == v.v_A && again.v_B == v.v_B);
  int changed = 0;
  for (int k = 0; k < 2 * D; ++k) {
    const bool of_A = k < D;
    const Scalar from = of_A ? c.after.v_A[k] : c.after.v_B[k - D];
    const Scalar to = of_A ? v.v_A[k] : v.v_B[k - D];
    if (from == to) continue;
    ++changed;
    EXPECT_TRUE(of_A ? c.m_A <= c.m_B : c.m_B <= c.m_A) << "the heavier body was changed";
    // docs/engine.md: 54 D u of the largest component, and the rounding.
    EXPECT_LE(Scalar(abs(to - from)), Scalar(54 * D + 2) * roundoff<Scalar>() * fastest(c));
    if (c.leaving == Leaving::together) continue;
    PairVelocities<Scalar, D> nearer = v;
    (of_A ? nearer.v_A[k] : nearer.v_B[k - D]) = next_number(to, to > from ? Rounding::down : Rounding::up);
    EXPECT_FALSE((detail::leaves<Scalar, D>(c.leaving, c.u_A, c.u_B, nearer))) << "not the least change";
  }
  const bool opposite = c.m_A == c.m_B && (c.before.v_A.array() == -c.before.v_B.array()).any();
  EXPECT_LE(changed, opposite ? 2 : 1);
  return changed != 0;
}

TYPED_TEST(DirectedRounding, TurnsEverySignByTheLeastChange) {
  std::mt19937_64 random(20261125);
  const int cases = std::is_floating_point_v<TypeParam> ? 2000 : 200;
  int turned = 0;
  for (int n = 0; n < cases; ++n) {
    turned += judge(at_rest_along_the_axis<TypeParam, 2>(random, n)) ? 1 : 0;
    turned += judge(at_rest_along_the_axis<TypeParam, 3>(random, n)) ? 1 : 0;
    if (testing::Test::HasFailure()) FAIL() << "case " << n;
  }
  EXPECT_GE(turned, cases / 2);  // a sign of rounding is wrong half of the time
}

/// A pair on a diagonal, where û is as large along one axis as along another; every other one is as fast
/// along them, too.
template <typename Scalar, int D>
Answered<Scalar, D> on_a_diagonal(std::mt19937_64& random, int n) {
  Answered<Scalar, D> c = at_rest_along_the_axis<Scalar, D>(random, n);
  const Scalar a = Scalar(1 + n % 7);
  const auto side = [&] { return random() % 2 == 0 ? a : Scalar(-a); };
  c.u_A = Vector<Scalar, D>::Zero();
  for (int k = 0; k < D; ++k) c.u_B[k] = side();
  for (auto* v : {&c.after.v_A, &c.after.v_B}) {
    if (random() % 2 == 0) {
      for (int k = 1; k < D; ++k) (*v)[k] = random() % 2 == 0 ? (*v)[0] : Scalar(-(*v)[0]);
    }
  }
  if (random() % 3 == 0) c.after.v_B = -c.after.v_A;
  if (random() % 3 == 0) c.m_B = c.m_A;
  return c;
}

template <typename Scalar, int D>
Vector<Scalar, D> exchanged(Vector<Scalar, D> x) {
  std::swap(x[0], x[1]);
  return x;
}

/// @return whether directed rounding changed it.
template <typename Scalar, int D>
bool judge_exchange(const Answered<Scalar, D>& c) {
  const auto turned = [](const auto& x) { return exchanged<Scalar, D>(x); };
  const PairVelocities<Scalar, D> v = c.directed_after();
  EXPECT_TRUE((detail::leaves<Scalar, D>(c.leaving, c.u_A, c.u_B, v)));
  const PairVelocities<Scalar, D> other = directed<Scalar, D>(
      turned(c.u_A), turned(c.u_B), c.m_A, c.m_B, {turned(c.after.v_A), turned(c.after.v_B)}, c.leaving);
  EXPECT_TRUE(other.v_A == turned(v.v_A) && other.v_B == turned(v.v_B));
  return v.v_A != c.after.v_A || v.v_B != c.after.v_B;
}

TYPED_TEST(DirectedRounding, ExchangedAxesChangeNothing) {
  std::mt19937_64 random(20261126);
  int turned = 0;
  for (int n = 0; n < 300; ++n) {
    turned += judge_exchange(on_a_diagonal<TypeParam, 2>(random, n)) ? 1 : 0;
    turned += judge_exchange(on_a_diagonal<TypeParam, 3>(random, n)) ? 1 : 0;
    if (testing::Test::HasFailure()) FAIL() << "case " << n;
  }
  EXPECT_GE(turned, 100);
}

TYPED_TEST(DirectedRounding, KeepsWhatIsRight) {
  using Scalar = TypeParam;
  const PairVelocities<Scalar, 2> v{vec<Scalar>(1, 2), vec<Scalar>(3, -7)};
  const auto same = [&](const Vector<Scalar, 2>& u_B, Leaving leaving) {
    const auto w = directed<Scalar, 2>(vec<Scalar>(0, 0), u_B, Scalar(1), Scalar(2), v, leaving);
    return w.v_A == v.v_A && w.v_B == v.v_B;
  };
  EXPECT_TRUE(same(vec<Scalar>(1, 0), Leaving::apart));
  EXPECT_TRUE(same(vec<Scalar>(-1, 0), Leaving::together));
  EXPECT_FALSE(same(vec<Scalar>(1, 0), Leaving::together));
  EXPECT_FALSE(same(vec<Scalar>(-1, 0), Leaving::apart));
}

// Head-on, v_n' = 0 is the other one's velocity: nothing creeps, whatever the sizes.
TYPED_TEST(DirectedRounding, HeadOnPairsRest) {
  using Scalar = TypeParam;
  for (const double residue : {1e-30, 1e-16, 0.3, 3.}) {
    const PairVelocities<Scalar, 2> v{vec<Scalar>(0.1 + residue, 5), vec<Scalar>(0.1, 5)};
    const auto w = directed<Scalar, 2>(vec<Scalar>(0, 1), vec<Scalar>(3, 1), Scalar(1), infinity<Scalar>(), v,
                                       Leaving::apart);
    EXPECT_EQ(w.v_A, v.v_B);
    const auto pulled = directed<Scalar, 2>(vec<Scalar>(3, 1), vec<Scalar>(0, 1), Scalar(1),
                                            infinity<Scalar>(), v, Leaving::together);
    EXPECT_EQ(pulled.v_A, v.v_B);
  }
}

// Across the axis a pulled pair would leave with v_n' = 0: it is turned inwards by one number.
TYPED_TEST(DirectedRounding, APulledPairMovesInwards) {
  using Scalar = TypeParam;
  const PairVelocities<Scalar, 2> v{vec<Scalar>(1, 0), vec<Scalar>(1, 1)};
  const auto w =
      directed<Scalar, 2>(vec<Scalar>(0, 0), vec<Scalar>(2, 0), Scalar(1), Scalar(2), v, Leaving::together);
  EXPECT_EQ(w.v_A[0], next_number(Scalar(1), Rounding::up));
  EXPECT_EQ((normal_sign<Scalar, 2>(vec<Scalar>(0, 0), vec<Scalar>(2, 0), w.v_A, w.v_B)), -1);
}

// From rest the next number is one that sums can be made of and readers take: exponents end at ±2^20.
TYPED_TEST(DirectedRounding, APulledPairAtRestAlongTheAxisMovesInwards) {
  using Scalar = TypeParam;
  using std::frexp;
  const PairVelocities<Scalar, 2> v{vec<Scalar>(0, 0), vec<Scalar>(0, 1)};
  const auto w =
      directed<Scalar, 2>(vec<Scalar>(0, 0), vec<Scalar>(2, 0), Scalar(1), Scalar(2), v, Leaving::together);
  EXPECT_GT(w.v_A[0], Scalar(0));
  int exponent = 0;
  frexp(w.v_A[0], &exponent);
  EXPECT_GT(exponent, -16500);
  EXPECT_EQ((normal_sign<Scalar, 2>(vec<Scalar>(0, 0), vec<Scalar>(2, 0), w.v_A, w.v_B)), -1);
}

TYPED_TEST(DirectedRounding, OfEqualMassesTheFasterIsSlowed) {
  using Scalar = TypeParam;
  const PairVelocities<Scalar, 2> v{vec<Scalar>(2, 0), vec<Scalar>(1, 0)};
  const auto w =
      directed<Scalar, 2>(vec<Scalar>(0, 0), vec<Scalar>(1, 0), Scalar(1), Scalar(1), v, Leaving::apart);
  EXPECT_EQ(w.v_A, v.v_B);
  const auto mirrored =
      directed<Scalar, 2>(vec<Scalar>(1, 0), vec<Scalar>(0, 0), Scalar(1), Scalar(1), v, Leaving::together);
  EXPECT_EQ(mirrored.v_A, v.v_B);
}

// Products that no scalar holds: the ends of the exponent.
TYPED_TEST(DirectedRounding, TheSignIsExactAtBothEndsOfTheRange) {
  using Scalar = TypeParam;
  using Limits = std::numeric_limits<Scalar>;
  if (!std::is_floating_point_v<Scalar>) GTEST_SKIP() << "exponents of 2^31 take gigabytes";
  const Scalar zero(0);
  for (const Scalar& size : {Limits::denorm_min(), (Limits::min)(), Scalar((Limits::max)() / 4)}) {
    const Vector<Scalar, 2> u_A(zero, zero), u_B(size, size), v_A(zero, zero);
    const Vector<Scalar, 2> v_B(size, -size), out(Scalar(2 * size), -size), in(Scalar(-2 * size), size);
    EXPECT_EQ((normal_sign<Scalar, 2>(u_A, u_B, v_A, v_B)), 0);
    EXPECT_EQ((normal_sign<Scalar, 2>(u_A, u_B, v_A, out)), 1);
    EXPECT_EQ((normal_sign<Scalar, 2>(u_A, u_B, v_A, in)), -1);
    const auto w = directed<Scalar, 2>(u_A, u_B, Scalar(1), infinity<Scalar>(), {v_A, in}, Leaving::apart);
    EXPECT_EQ((normal_sign<Scalar, 2>(u_A, u_B, w.v_A, w.v_B)), 0);
  }
}

TYPED_TEST(DirectedRounding, QuotientsAreTheNearestOnTheirSide) {
  using Scalar = TypeParam;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(1, 2);
  for (int n = 0; n < 500; ++n) {
    const Scalar a = Scalar(uniform(random)) / Scalar(3);
    const Scalar b = Scalar(uniform(random)) / Scalar(n % 2 == 0 ? 7 : -7);
    const Scalar down = rounded_quotient<Scalar>(dyadic(a), dyadic(b), Rounding::down);
    const Scalar up = rounded_quotient<Scalar>(dyadic(a), dyadic(b), Rounding::up);
    const int towards_up = (dyadic(a) - dyadic(up) * dyadic(b)).sign();
    const int towards_down = (dyadic(a) - dyadic(down) * dyadic(b)).sign();
    EXPECT_TRUE(up == down || up == next_number(down, Rounding::up)) << n;
    EXPECT_LE(b > Scalar(0) ? towards_up : -towards_up, 0) << n;
    EXPECT_GE(b > Scalar(0) ? towards_down : -towards_down, 0) << n;
  }
  const Dyadic third = dyadic(Scalar(3));
  if (std::is_floating_point_v<Scalar>) {
    const Scalar least = std::numeric_limits<Scalar>::denorm_min();
    EXPECT_EQ(rounded_quotient<Scalar>(dyadic(least), third, Rounding::up), least);
    EXPECT_EQ(rounded_quotient<Scalar>(dyadic(least), third, Rounding::down), Scalar(0));
    EXPECT_EQ(rounded_quotient<Scalar>(dyadic(Scalar(-least)), third, Rounding::down), -least);
  }
}

}  // namespace
}  // namespace tps::test

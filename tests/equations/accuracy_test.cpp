// How far the equations are from the truth, in roundoffs, over fixed samples. Both sides are asserted: a
// larger error is a defect, one below a quarter of the bound says that the bound no longer describes the
// code. The truth is computed in 100 digits from the same stored numbers, by other formulas.
#include <random>

#include "reference/equations/eq1_distance.hpp"
#include "reference/equations/eq2_collision_time.hpp"
#include "reference/equations/eq4_collision_impulse.hpp"
#include "reference/equations/eq5_revolution_impulse.hpp"
#include "reference/equations/eq6_load_velocity.hpp"
#include "reference/equations/eq7_restitution_impulse.hpp"
#include "tests/equations/every_scalar.hpp"

namespace tps::test {

template <typename Scalar>
class Accuracy : public testing::Test {
 protected:
  static constexpr int kSamples = 2000;

  /// Uniform in [-1, 1], then scaled by up to ± `decades` decades.
  Scalar number(double decades = 0) {
    const double x = std::ldexp(static_cast<double>(random_() >> 11), -52) - 1;
    const double e = std::ldexp(static_cast<double>(random_() >> 11), -52) - 1;
    return static_cast<Scalar>(x * std::pow(10.0, e * decades));
  }
  Scalar mass() { return std::abs(number(4)) + Scalar(1e-6); }
  Vector<Scalar, 3> vector() { return {number(), number(), number()}; }

  static Mp100 exact(Scalar x) { return Mp100(x); }
  static Vector<Mp100, 3> exact(const Vector<Scalar, 3>& x) { return x.template cast<Mp100>(); }
  static Mp100 length(const Vector<Mp100, 3>& x) { return sqrt(Mp100(x.squaredNorm())); }

  /// Records an error measured against a scale.
  void record(const Mp100& error, const Mp100& scale) {
    const double units =
        static_cast<double>(Mp100(abs(error) / scale)) / static_cast<double>(roundoff<Scalar>());
    worst_ = std::max(worst_, units);
  }
  void expect_worst_error(double bound) {
    EXPECT_LE(worst_, bound);
    EXPECT_GE(worst_, bound / 4) << "the bound is pessimistic";
    testing::Test::RecordProperty("worst_roundoffs", std::to_string(worst_));
  }

 private:
  std::mt19937_64 random_{20260101};
  double worst_ = 0;
};
using Narrow = testing::Types<float, double>;
TYPED_TEST_SUITE(Accuracy, Narrow, ScalarName);

// Squares 2u, two sums 2u, together halved by the root, 1u for it; and the flight's own roundings, up to
// 3 roundings of |u| + |v t|.
TYPED_TEST(Accuracy, Eq1DistanceInUnitsOfThePathsLengths) {
  for (int i = 0; i < this->kSamples; ++i) {
    const auto u_A = this->vector(), u_B = this->vector(), v_A = this->vector(), v_B = this->vector();
    const TypeParam t = this->number(2);
    const Vector<Mp100, 3> way =
        (this->exact(u_B) - this->exact(u_A)) + (this->exact(v_B) - this->exact(v_A)) * this->exact(t);
    const Mp100 scale =
        this->length(this->exact(u_A)) + this->length(this->exact(u_B)) +
        (this->length(this->exact(v_A)) + this->length(this->exact(v_B))) * abs(this->exact(t));
    this->record(this->exact(distance_after<TypeParam, 3>(u_A, u_B, v_A, v_B, t)) - this->length(way), scale);
  }
  this->expect_worst_error(3);
}

// Law (4) of block_time: the distance at the answer is L to a few u (|r| + L), grazing or not; see
// docs/eq2.md.
TYPED_TEST(Accuracy, Eq2HitsAreAtTheLimit) {
  int hits = 0, grazes = 0;
  for (int i = 0; i < 8 * this->kSamples; ++i) {
    const auto u_A = this->vector(), u_B = this->vector();
    const TypeParam far = std::pow(TypeParam(10), std::abs(this->number()) * TypeParam(4));
    const TypeParam L = std::abs(this->number()) + TypeParam(0.01);
    // B flies towards a point near the rim of A's disc of radius L.
    const Vector<TypeParam, 3> rim = u_A + this->vector().normalized() * L;
    const Vector<TypeParam, 3> start = (u_B - u_A) * far;
    const Vector<TypeParam, 3> v_B = (rim - start) * this->number(3);
    const Vector<TypeParam, 3> v_A = this->vector() * v_B.norm();
    const Vector<TypeParam, 3> v_B_moving = v_B + v_A;
    const CollisionTime<TypeParam> at = block_time<TypeParam, 3>(u_A, start, v_A, v_B_moving, L);
    if (at.verdict != TimingVerdict::hit) continue;
    ++hits;
    const Vector<Mp100, 3> r = this->exact(start) - this->exact(u_A);
    const Vector<Mp100, 3> v = this->exact(v_B_moving) - this->exact(v_A);
    const Mp100 missed_by = this->length(Vector<Mp100, 3>(r + v * this->exact(*at.t))) - this->exact(L);
    const Mp100 closest = sqrt(Mp100(abs(r.squaredNorm() - r.dot(v) * r.dot(v) / v.squaredNorm())));
    if (closest > Mp100(0.99) * this->exact(L)) ++grazes;
    this->record(missed_by, this->length(r) + this->exact(L));
  }
  EXPECT_GT(hits, this->kSamples);
  EXPECT_GT(grazes, 100);
  this->expect_worst_error(6);
}

TYPED_TEST(Accuracy, Eq2TetheringHitsFromInsideAreAtTheLimit) {
  for (int i = 0; i < 4 * this->kSamples; ++i) {
    const auto r = this->vector();
    const auto v = this->vector();
    const TypeParam L = r.norm() * (TypeParam(1) + std::abs(this->number(4)) * TypeParam(1e-3));
    const Vector<TypeParam, 3> zero = Vector<TypeParam, 3>::Zero();
    const CollisionTime<TypeParam> at = tether_time<TypeParam, 3>(zero, r, zero, v, L);
    if (at.verdict != TimingVerdict::hit) continue;
    const Mp100 missed_by =
        this->length(Vector<Mp100, 3>(this->exact(r) + this->exact(v) * this->exact(*at.t))) - this->exact(L);
    this->record(missed_by, this->length(this->exact(r)) + this->exact(L));
  }
  this->expect_worst_error(6);
}

TYPED_TEST(Accuracy, ReducedMass) {
  for (int i = 0; i < this->kSamples; ++i) {
    const TypeParam m_A = this->mass(), m_B = this->mass();
    const Mp100 mu = this->exact(m_A) * this->exact(m_B) / (this->exact(m_A) + this->exact(m_B));
    this->record(this->exact(reduced_mass<TypeParam>(m_A, m_B)) - mu, mu);
  }
  this->expect_worst_error(3);  // 1u for the inverses, 1u for the sum, 1u for its inverse
}

TYPED_TEST(Accuracy, TangentOfDegrees) {
  for (int i = 0; i < this->kSamples; ++i) {
    const TypeParam theta = TypeParam(45) + TypeParam(45) * this->number();
    if (!(theta > TypeParam(0) && theta < TypeParam(90))) continue;
    const Mp100 truth = tan(Mp100(this->exact(theta) * (acos(Mp100(-1)) / 180)));
    this->record(this->exact(tan_degrees<TypeParam>(theta)) - truth, truth);
  }
  // x = θ·(π/180): 2.5u, amplified by 2x/sin 2x ≤ π/2; the tangent and its inverse 1u each.
  this->expect_worst_error(6);
}

TYPED_TEST(Accuracy, Eq4ImpulseInUnitsOfTheLargestPossible) {
  for (int i = 0; i < this->kSamples; ++i) {
    const auto u_A = this->vector(), u_B = this->vector(), v_A = this->vector(), v_B = this->vector();
    const TypeParam m_A = this->mass(), m_B = this->mass(), c = std::abs(this->number());
    const Vector<Mp100, 3> r = this->exact(u_B) - this->exact(u_A), v = this->exact(v_B) - this->exact(v_A);
    const Mp100 mu = this->exact(m_A) * this->exact(m_B) / (this->exact(m_A) + this->exact(m_B));
    const Mp100 strength = (1 + this->exact(c)) * mu;
    const Vector<Mp100, 3> truth = strength * (v.dot(r) / r.squaredNorm()) * r;
    const Vector<TypeParam, 3> dp = collision_impulse<TypeParam, 3>(u_A, u_B, v_A, v_B, m_A, m_B, c);
    this->record(this->length(Vector<Mp100, 3>(this->exact(dp) - truth)), strength * this->length(v));
  }
  this->expect_worst_error(8);
}

TYPED_TEST(Accuracy, Eq5ImpulseInUnitsOfMassAndSpeedOverTheTangentialShare) {
  for (int i = 0; i < this->kSamples / 4; ++i) {
    const auto u_A = this->vector(), u_B = this->vector(), v_A = this->vector(), v_B = this->vector();
    const TypeParam m_A = this->mass(), m_B = this->mass(), c = std::abs(this->number());
    const TypeParam theta = TypeParam(45) + TypeParam(44) * this->number();
    const Vector<Mp100, 3> r = this->exact(u_B) - this->exact(u_A), v = this->exact(v_B) - this->exact(v_A);
    const Mp100 mu = this->exact(m_A) * this->exact(m_B) / (this->exact(m_A) + this->exact(m_B));
    const Mp100 angle = this->exact(theta) * acos(Mp100(-1)) / 180;
    const Vector<Mp100, 3> v_w = v - (v.dot(r) / r.squaredNorm()) * r;
    const Vector<Mp100, 3> direction =  // unit by construction
        v_w * (cos(angle) / this->length(v_w)) - r * (sin(angle) / this->length(r));
    const Mp100 ratio = exp(Mp100(log(this->exact(c)) * this->exact(theta) / 180));
    const Vector<Mp100, 3> truth = mu * (v - direction * Mp100(ratio * this->length(v)));
    const Vector<TypeParam, 3> dp = revolution_impulse<TypeParam, 3>(u_A, u_B, v_A, v_B, m_A, m_B, c, theta);
    this->record(this->length(Vector<Mp100, 3>(this->exact(dp) - truth)),
                 mu * this->length(v) * (this->length(v) / this->length(v_w)));
  }
  this->expect_worst_error(8);
}

TYPED_TEST(Accuracy, Eq6LoadVelocityInUnitsOfTheWeightedSpeeds) {
  for (int i = 0; i < this->kSamples; ++i) {
    const auto v_A = this->vector(), v_B = this->vector();
    const TypeParam m_A = this->mass(), m_B = this->mass();
    const Mp100 a = this->exact(m_A), b = this->exact(m_B);
    const Vector<Mp100, 3> truth = (a * this->exact(v_A) + b * this->exact(v_B)) / Mp100(a + b);
    const Vector<Mp100, 3> got = this->exact(load_velocity<TypeParam, 3>(m_A, m_B, v_A, v_B));
    for (int k = 0; k < 3; ++k) {
      const Mp100 scale = Mp100(a * abs(this->exact(v_A[k])) + b * abs(this->exact(v_B[k]))) / (a + b);
      this->record(got[k] - truth[k], scale);
    }
  }
  this->expect_worst_error(5);  // a weight 3u, its product 1u, the sum 1u
}

TYPED_TEST(Accuracy, Eq7RestitutionImpulse) {
  for (int i = 0; i < this->kSamples; ++i) {
    const auto v_A = this->vector(), v_B = this->vector(), dp = this->vector();
    const TypeParam m_A = this->mass(), m_B = this->mass();
    const Mp100 a = this->exact(m_A), b = this->exact(m_B), mu = a * b / (a + b);
    const Vector<Mp100, 3> v = this->exact(v_B) - this->exact(v_A);
    const Vector<Mp100, 3> got = this->exact(restitution_impulse<TypeParam, 3>(m_A, m_B, v_A, v_B, dp));
    for (int k = 0; k < 3; ++k) {
      this->record(got[k] - (this->exact(dp[k]) - mu * v[k]), abs(this->exact(dp[k])) + mu * abs(v[k]));
    }
  }
  this->expect_worst_error(6);  // μ 3u, v_AB 1u, the product 1u, the sum 1u
}

}  // namespace tps::test

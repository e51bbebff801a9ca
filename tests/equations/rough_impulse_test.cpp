// Walton's impulse against its laws on random pairs.
#include "reference/equations/rough_impulse.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

#include "reference/equations/eq4_collision_impulse.hpp"

namespace tps {
namespace rough_impulse_test {
namespace {

/// The velocity of B's surface against A's across the axis, from its definition.
template <int D>
Vector<double, D> slip(const Vector<double, D>& u_hat, const Vector<double, D>& v_AB,
                       const Spin<double, D>& S) {
  const Vector<double, D> g = v_AB - turned<double, D>(S, u_hat);
  return g - g.dot(u_hat) * u_hat;
}

/// Laws (1) to (3) of rough_impulse on random pairs, in the plane and in space: rounding is 2⁻⁵³ of speeds
/// and surface speeds up to 10, a few dozen times; 1e−12 is a hundred of that, and fails for any wrong
/// factor.
template <int D>
void keeps_its_laws() {
  std::mt19937_64 random(11 + D);
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  int sticking = 0;
  for (int n = 0; n < 500; ++n) {
    Vector<double, D> u, v_A, v_B;
    Spin<double, D> w_A, w_B;
    for (int k = 0; k < D; ++k) u[k] = between(-1, 1), v_A[k] = between(-1, 1), v_B[k] = between(-1, 1);
    for (int k = 0; k < w_A.size(); ++k) w_A[k] = between(-2, 2), w_B[k] = between(-2, 2);
    const double R_A = between(.2, 2), R_B = between(.2, 2), m_A = between(.3, 3), m_B = between(.3, 3);
    const double mu = between(0, 1), beta0 = between(-1, 1), c = between(0, 1);
    u = u.normalized() * (R_A + R_B);
    if ((v_B - v_A).dot(u) > 0) std::swap(v_A, v_B);
    const auto frame = collision_frame<double, D>(Vector<double, D>::Zero(), u, v_A, v_B);
    const Vector<double, D> normal = collision_impulse<double, D>(frame, m_A, m_B, c);
    const Spin<double, D> S = R_A * w_A + R_B * w_B;
    const auto rough = rough_impulse<double, D>(frame, m_A, m_B, normal.norm(), S, mu, beta0);
    sticking += rough.sticks ? 1 : 0;
    const Vector<double, D> dp = normal + rough.dp;
    const Vector<double, D> after_A = v_A + dp / m_A, after_B = v_B - dp / m_B;
    const Spin<double, D> w_A2 = w_A + spin_change<double, D>(frame.u_hat, rough.dp, m_A, R_A);
    const Spin<double, D> w_B2 = w_B + spin_change<double, D>(frame.u_hat, rough.dp, m_B, R_B);
    const Vector<double, D> g = slip<D>(frame.u_hat, v_B - v_A, S);
    const Vector<double, D> g2 =
        slip<D>(frame.u_hat, after_B - after_A, Spin<double, D>(R_A * w_A2 + R_B * w_B2));
    if (rough.sticks) {
      EXPECT_LT((g2 + beta0 * g).norm(), 1e-12);
    } else {
      EXPECT_NEAR(rough.dp.norm(), mu * normal.norm(), 1e-12);
      EXPECT_LT(g2.dot(g) / g.squaredNorm(), 1);               // slower
      EXPECT_GT(g2.dot(g) / g.squaredNorm(), -beta0 - 1e-12);  // and turned by less than what sticks
    }
    const double K = D == 2 ? .5 : .4, kappa = K / (1 + K), m = m_A * m_B / (m_A + m_B);
    const double I_A = K * m_A * R_A * R_A, I_B = K * m_B * R_B * R_B;
    const Spin<double, D> L =
        moment<double, D>(u, Vector<double, D>(-dp)) + I_A * (w_A2 - w_A) + I_B * (w_B2 - w_B);
    EXPECT_LT(L.norm(), 1e-12);
    const double energy = m_A / 2 * (after_A.squaredNorm() - v_A.squaredNorm()) +
                          m_B / 2 * (after_B.squaredNorm() - v_B.squaredNorm()) +
                          I_A / 2 * (w_A2.squaredNorm() - w_A.squaredNorm()) +
                          I_B / 2 * (w_B2.squaredNorm() - w_B.squaredNorm());
    const double v_n = frame.v_n;
    EXPECT_NEAR(energy, -(m / 2 * (1 - c * c) * v_n * v_n + rough.lost), 1e-12);
    const double beta = -g2.dot(g) / g.squaredNorm();
    EXPECT_NEAR(rough.lost, kappa * m / 2 * (1 - beta * beta) * g.squaredNorm(), 1e-12);
  }
  EXPECT_GT(sticking, 100);
  EXPECT_LT(sticking, 400);
}

TEST(RoughImpulse, KeepsItsLawsInThePlane) {
  keeps_its_laws<2>();
}
TEST(RoughImpulse, KeepsItsLawsInSpace) {
  keeps_its_laws<3>();
}

}  // namespace
}  // namespace rough_impulse_test
}  // namespace tps

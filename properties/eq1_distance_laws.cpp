#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "properties/generators/numbers.hpp"
#include "properties/generators/pairs.hpp"
#include "properties/lifted.hpp"
#include "reference/equations/eq1_distance.hpp"

namespace tps::properties {

RC_GTEST_PROP(Eq1Laws, Law1SwapOfNames, ()) {
  const auto p = *pair<3>();
  const double dt = *number();
  RC_ASSERT((distance_after(p.u_A, p.u_B, p.v_A, p.v_B, dt)) ==
            (distance_after(p.u_B, p.u_A, p.v_B, p.v_A, dt)));
}

RC_GTEST_PROP(Eq1Laws, Law2NowItIsTheSeparation, ()) {
  const auto p = *pair<3>();
  RC_ASSERT((distance_after(p.u_A, p.u_B, p.v_A, p.v_B, 0.0)) == (norm<double, 3>(p.r())));
}

// Twice the error of docs/eq1.md, 3u of all lengths involved.
RC_GTEST_PROP(Eq1Laws, Law3EqualVelocitiesKeepIt, ()) {
  const auto p = *pair<3>();
  const double dt = *number();
  const Wide now = distance_after(p.u_A, p.u_B, p.v_A, p.v_A, 0.0);
  const Wide later = distance_after(p.u_A, p.u_B, p.v_A, p.v_A, dt);
  const Wide lengths = p.u_A.norm() + p.u_B.norm() + 2 * p.v_A.norm() * std::abs(dt);
  RC_ASSERT(std::abs(later - now) <= 6 * u * lengths * kSlack);
}

}  // namespace tps::properties

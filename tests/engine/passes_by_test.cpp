// What spares most pairs a question: certain misses, and times before which nothing happens, beside the
// answers that the pairs would have had.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "reference/engine/miss_filter.hpp"
#include "reference/engine/world.hpp"
#include "verify/certified/exact_timing.hpp"

namespace tps {
namespace {

/// Two particles that pass each other at `grazing` times their limit, an hour before or after t, with stored
/// states of other ages than that; lengths are 2^scale, places some way from the origin, and B in a box is
/// an image away.
struct Passing {
  Scene scene;
  Vector<double, 3> place[2], velocity[2];
  double age[2];

  Passing(std::mt19937_64& bits, double grazing, int scale, double edge) {
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    const double L = std::ldexp(1., scale);
    const auto vector = [&] { return Vector<double, 3>(normal(bits), normal(bits), normal(bits)); };
    const Vector<double, 3> axis = vector().normalized();
    const Vector<double, 3> along = axis.cross(vector()).normalized();
    const Vector<double, 3> apart = (axis * grazing + along * normal(bits) * 2) * L;
    velocity[0] = vector() * L;
    velocity[1] = velocity[0] + along * normal(bits) * L;
    place[0] = vector() * 10 * L;
    place[1] = place[0] + apart;
    for (const int n : {0, 1}) {
      age[n] = bits() % 2 == 0 ? 0 : uniform(bits);
      place[n] -= velocity[n] * age[n];
    }
    scene.dimension = 3;
    scene.species.push_back({"ball", 1, L / 2, {}});
    scene.pairs.push_back({0, 0, BlockingLaw{L, 1}, {}});
    if (edge == 0) return;
    scene.box = PeriodicEdges{{edge * L, edge * L, edge * L}};
    place[1] += Vector<double, 3>(1, -2, 3) * edge * L;
  }
};

template <typename Scalar>
class PassesBy : public ::testing::Test {};
using Scalars = ::testing::Types<float, double, long double>;
TYPED_TEST_SUITE(PassesBy, Scalars);

/// Nor is it too late for who is asked later. From grazing ones, which rounding could turn either way, to
/// such that miss by far; near and far images.
TYPED_TEST(PassesBy, WhoIsSparedWouldHaveHadNoEvent) {
  using Scalar = TypeParam;
  std::mt19937_64 bits(1);
  certified::ExactTiming certifier;
  int spared = 0, misses = 0, foreseen = 0, close = 0;
  for (int n = 0; n < 20000; ++n) {
    const double off = std::ldexp(n % 2 == 0 ? 1. : -1., -static_cast<int>(bits() % 60));
    const double edge = n % 3 == 0 ? 0 : n % 3 == 1 ? 20 : 0x1p10;
    Passing p(bits, 1 + off, static_cast<int>(bits() % 60) - 30, edge);
    for (const Timing timing : {Timing::stable, Timing::certified}) {
      if (timing == Timing::certified && !certifiable<Scalar>) continue;
      World<Scalar, 3> world(p.scene, {timing, &certifier});
      if (p.scene.box) world.box = std::make_unique<PeriodicBox<Scalar, 3>>(p.scene);
      const Time<Scalar> now{static_cast<Scalar>(bits() % 1000), Scalar(0)};
      for (const int m : {0, 1}) {
        world.particles.push_back({p.place[m].template cast<Scalar>(), p.velocity[m].template cast<Scalar>(),
                                   after(now, static_cast<Scalar>(-p.age[m]))});
      }
      const auto L = static_cast<Scalar>(p.scene.pairs[0].blocking->distance);
      const LimitQuestion<Scalar> question{TimingKind::block, L, false};
      const auto answer = world.box ? world.timing.next(world.imaged_view(0, 1, now), question)
                                    : world.timing.next(world.view(0, 1), question);
      misses += answer ? 0 : 2;
      for (const std::size_t own : {0U, 1U}) {
        const MissFilter<Scalar, 3> filter(world.particles[own], now, world.box.get());
        const auto [is_spared, not_before] = filter.foresee(world.particles[1 - own], L);
        EXPECT_FALSE(is_spared && answer) << n;
        spared += is_spared ? 1 : 0;
        if (!(not_before > Scalar(0))) continue;
        foreseen += 1;
        close += answer && after(world.view(0, 1).start, *answer) <= after(now, not_before * Scalar(1.001))
                     ? 1
                     : 0;
        EXPECT_FALSE(answer && after(world.view(0, 1).start, *answer) < after(now, not_before)) << n;
      }
    }
  }
  EXPECT_GT(spared, misses / 3);  // half of those part, which even a float can tell
  EXPECT_GT(misses, spared);
  EXPECT_GE(close, foreseen / 2);  // the others are grazing ones, and misses that look like those
  EXPECT_EQ(foreseen > 1000, sizeof(Scalar) > sizeof(float));
}

/// The question stands at the later of the two clocks: a pair that parts now, but approached then, may have
/// met in between, and is not spared.
TEST(PassesByThen, WhoPartsNowButApproachedWhenTheQuestionStandsIsNotSpared) {
  const Time<double> now{4};
  const auto spared = [&](double clock) {
    const ParticleState<double, 3> resting{{0, 0, 0}, {0, 0, 0}, {clock}};
    const ParticleState<double, 3> passing{{clock - 2, 0.5, 0}, {1, 0, 0}, {clock}};
    const MissFilter<double, 3> filter(passing, now, nullptr);
    return filter.foresee(resting, 1).misses;
  };
  EXPECT_FALSE(spared(1));
  EXPECT_TRUE(spared(3));
  EXPECT_TRUE(spared(4));
}

}  // namespace
}  // namespace tps

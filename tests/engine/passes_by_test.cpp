// What spares most pairs a question: certain misses, beside the answers themselves.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "reference/engine/pair_timing.hpp"
#include "verify/certified/exact_timing.hpp"

namespace tps {
namespace {

/// A pair at a distance of order 1 that passes the limit at `grazing` times it, with lengths 2^scale: B at
/// rest, A beside it and on its way. An image of it is `edges` away.
template <typename Scalar>
struct Passing {
  ImagedPairView<Scalar, 3> pair{};
  Scalar limit;
  RelativeState<Scalar, 3> relative;

  Passing(std::mt19937_64& bits, double grazing, int scale, double edges) {
    std::normal_distribution<double> normal;
    const Vector<double, 3> axis = Vector<double, 3>(normal(bits), normal(bits), normal(bits)).normalized();
    const Vector<double, 3> along =
        axis.cross(Vector<double, 3>(normal(bits), normal(bits), normal(bits))).normalized();
    const Vector<double, 3> start = (axis * grazing + along * normal(bits) * 2) * std::ldexp(1., scale);
    pair.u_i = pair.stored_j = pair.v_j = Vector<Scalar, 3>::Zero();
    pair.image = {};
    limit = static_cast<Scalar>(std::ldexp(1., scale));
    pair.stored_i = start.cast<Scalar>();
    pair.v_i = (along * normal(bits)).cast<Scalar>();
    pair.image.edges.setConstant(static_cast<Scalar>(std::ldexp(edges, scale)));
    if (edges != 0) {
      pair.image.n = Vector<Scalar, 3>(1, -2, 3);
      pair.stored_j = -pair.image.n.cwiseProduct(pair.image.edges);
    }
    const Vector<Scalar, 3> apart = pair.stored_j - pair.stored_i;
    pair.u_j = pair.image.difference(pair.stored_i, pair.stored_j);
    relative.r = pair.u_j;
    relative.v = pair.v_j - pair.v_i;
    for (int k = 0; k < 3; ++k) relative.size[k] = std::abs(apart[k]) + std::abs(pair.image.shift(k));
  }
};

template <typename Scalar>
class PassesBy : public ::testing::Test {};
using Scalars = ::testing::Types<float, double, long double>;
TYPED_TEST_SUITE(PassesBy, Scalars);

/// From grazing ones, which rounding could turn either way, to such that miss by far; near and far images.
TYPED_TEST(PassesBy, WhoIsSparedWouldHaveHadNoEvent) {
  std::mt19937_64 bits(1);
  certified::ExactTiming certifier;
  int spared = 0, misses = 0;
  for (int n = 0; n < 30000; ++n) {
    const double off = std::ldexp(n % 2 == 0 ? 1. : -1., -static_cast<int>(bits() % 60));
    const double edges = n % 3 == 0 ? 0 : n % 3 == 1 ? 4 : 0x1p20;
    const Passing<TypeParam> p(bits, 1 + off, static_cast<int>(bits() % 60) - 30, edges);
    for (const Timing timing : {Timing::stable, Timing::certified}) {
      if (timing == Timing::certified && !certifiable<TypeParam>) continue;
      const PairTiming<TypeParam, 3> engine({timing, &certifier});
      const auto answer = engine.next(p.pair, {TimingKind::block, p.limit, false});
      const bool is_spared = engine.passes_by(p.relative, p.limit);
      EXPECT_FALSE(is_spared && answer) << n;
      misses += answer ? 0 : 1;
      spared += is_spared ? 1 : 0;
    }
    EXPECT_FALSE((PairTiming<TypeParam, 3>({Timing::paper, nullptr}).passes_by(p.relative, p.limit)));
  }
  EXPECT_GT(spared, misses / 3);  // half of those part whose images even a float can tell
  EXPECT_GT(misses, spared);
}

}  // namespace
}  // namespace tps

#include "reference/equations/timing_verdict.hpp"

#include <set>
#include <vector>

#include "reference/equations/eq2_collision_time.hpp"
#include "tests/equations/every_scalar.hpp"

namespace tps::test {

TEST(TimingVerdict, HasTheNamesOfFiles) {
  EXPECT_EQ(name(TimingVerdict::static_pair), "static");
  EXPECT_EQ(name(TimingVerdict::receding), "receding");
  EXPECT_EQ(name(TimingVerdict::overlap), "overlap");
  EXPECT_EQ(name(TimingVerdict::contact), "contact");
  EXPECT_EQ(name(TimingVerdict::miss), "miss");
  EXPECT_EQ(name(TimingVerdict::tangent), "tangent");
  EXPECT_EQ(name(TimingVerdict::hit), "hit");
  EXPECT_EQ(name(TimingVerdict::taut), "taut");
  EXPECT_EQ(name(TimingVerdict::overstretched), "overstretched");
  EXPECT_EQ(name(TimingVerdict::turning), "turning");
}

// One relative state for each verdict: what occurs has a time, and what is at once has the time 0.
TEST(TimingVerdict, SaysWhetherThereIsATimeAndWhetherItIsZero) {
  const Vector<double, 2> zero(0, 0);
  const std::vector<Vector<double, 2>> positions = {{-3, 0}, {3, 0},  {-.5, 0}, {-1, 0},
                                                    {-3, 2}, {-3, 1}, {1, 0}};
  const std::vector<Vector<double, 2>> velocities = {{1, 0}, {0, 1}, {0, 0}};
  std::set<TimingVerdict> seen;
  for (const auto& r : positions) {
    for (const auto& v : velocities) {
      for (const auto& answer :
           {block_time<double, 2>(zero, r, zero, v, 1.), tether_time<double, 2>(zero, r, zero, v, 1.)}) {
        seen.insert(answer.verdict);
        EXPECT_EQ(occurs(answer.verdict), answer.t.has_value()) << name(answer.verdict);
        EXPECT_EQ(at_once(answer.verdict), answer.t == 0.) << name(answer.verdict);
      }
    }
  }
  EXPECT_EQ(seen.size(), 10U);
}

}  // namespace tps::test

// What a batch keeps of an event is what its line is made of, whatever becomes of the record meanwhile.
#include "reference/run/event_batches.hpp"

#include <gtest/gtest.h>

#include "tests/run/traced_run.hpp"

namespace tps {
namespace {

/// The event number k of two particles, or of `bodies` many.
Record<double, 2> event(std::uint64_t k, int bodies = 2) {
  Record<double, 2> record;
  record.kind = "rebound";
  record.i = 0;
  record.j = 1;
  const double x = 1 / static_cast<double>(k);
  for (int n = 0; n < bodies; ++n) record.involved.push_back({n, {x, n}, {-x, 0}, {x, n + x}});
  record.dp = Vector<double, 2>(x, -x);
  record.k = k;
  record.t = {static_cast<double>(k), 0};
  record.dt = 1;
  return record;
}

class EventBatchesTest : public ::testing::Test {
 protected:
  EventBatchesTest() {
    testing::add_species(scene_, "p", 1, .5);
    for (int n = 0; n < kParticles; ++n) testing::add_particle(scene_, 0, {0, 1. * n});
    options_.trace = testing::scratch("batches.ndjson");
  }

  /// The events that `play` gives to the batches, as the trace has them behind its first line.
  template <typename Play>
  std::string written(const Play& play) {
    TraceFiles files(options_, nullptr);
    files.begin(scene_, options_, 1, nullptr);
    {
      EventBatches<double, 2> batches(scene_, files);
      play(batches);
      batches.hand_over();
    }
    files.close();
    const std::string all = testing::read_bytes(options_.trace);
    return all.substr(all.find('\n') + 1);
  }

  static constexpr int kParticles = 50;
  Scene scene_ = testing::plain_scene();
  RunOptions options_;
};

TEST_F(EventBatchesTest, AreWrittenInTheOrderInWhichTheyCame) {
  constexpr std::uint64_t kEvents = 6000;  // of six times as many batches as there are
  std::string expected;
  const std::string trace = written([&](EventBatches<double, 2>& batches) {
    for (std::uint64_t k = 1; k <= kEvents; ++k) {
      const Record<double, 2> record = event(k, k % 7 == 0 ? kParticles : 2);
      append_event<double, 2>(expected, scene_, record);
      batches.add(record);
      if (k % 3 == 0) batches.end_step();
      if (k % 3000 == 0) batches.hand_over();
    }
    batches.end_step();
  });
  EXPECT_TRUE(trace == expected);
}

TEST_F(EventBatchesTest, AStepThatIsDroppedLeavesNothing) {
  std::string expected;
  append_event<double, 2>(expected, scene_, event(1));
  append_event<double, 2>(expected, scene_, event(2));
  EXPECT_EQ(written([&](EventBatches<double, 2>& batches) {
              batches.add(event(1));
              batches.end_step();
              Addition<double, 2> own;
              own.own = {{"colour", std::string_view("red")}};
              Record<double, 2> record = event(2);
              record.addition = &own;
              batches.add(record);
              batches.add(event(3));
              batches.drop_step();
              batches.add(event(2));
              batches.end_step();
            }),
            expected);
}

TEST_F(EventBatchesTest, HoldWhatAnEffectKeepsUntilItsNextEventOnly) {
  std::string expected;
  EXPECT_EQ(written([&](EventBatches<double, 2>& batches) {
              std::string word = "red";
              Addition<double, 2> added;
              added.members = {0, 1};
              added.spins = {{0, {1}, {2}}};
              Record<double, 2> record = event(1);
              record.addition = &added;
              append_event<double, 2>(expected, scene_, record);
              batches.add(record);
              added.own = {{"colour", std::string_view(word)}};
              record.k = 2;
              append_event<double, 2>(expected, scene_, record);
              batches.add(record);
              batches.end_step();
              word = "blu";
              added = {};
            }),
            expected);
}

}  // namespace
}  // namespace tps

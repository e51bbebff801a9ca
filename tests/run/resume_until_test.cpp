// A resumed run cannot end before the state from which it goes on.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

#include "reference/run/end_of_times.hpp"
#include "reference/run/resume.hpp"
#include "tests/run/heavy_scene.hpp"
#include "tests/run/traced_run.hpp"

namespace tps {
namespace {

using testing::read_bytes;
using testing::scratch;
using testing::write_bytes;

// An end by time that the state has behind it is none: nothing is written. At the state's own time it is one.
TEST(Resume, AnEndBeforeTheStateIsRefused) {
  for (const std::optional<Drag>& drag : {std::optional<Drag>{}, std::optional<Drag>{Drag{.01}}}) {
    Scene scene = testing::heavy_scene();
    scene.drag = drag;
    RunOptions options = testing::options_for("double", 50);
    options.state_every = 7;
    options.trace = scratch("whole.ndjson");
    options.checkpoint = scratch("whole.checkpoint");
    const double now = run_scene(scene, options).t;
    const std::string whole = read_bytes(options.trace);
    for (const std::string& from : {options.trace, options.checkpoint}) {
      RunOptions again;
      again.trace = from == options.trace ? scratch("other.ndjson") : options.trace;
      write_bytes(scratch("other.ndjson"), "kept");
      for (const double until : {0., now / 2, now * .75}) {
        again.until = until;
        EXPECT_THROW(resume_run(from, again), EndsBeforeState) << until;
      }
      again.trace = scratch("other.ndjson");
      EXPECT_EQ(read_bytes(again.trace), "kept");
      EXPECT_EQ(read_bytes(options.trace), whole);
    }
    RunOptions last;
    last.trace = scratch("other.ndjson");
    last.until = std::nextafter(now, HUGE_VAL);  // a clock has a second part
    const RunSummary summary = resume_run(options.trace, last);
    EXPECT_EQ(summary.end, "duration");
    EXPECT_EQ(summary.t, *last.until);
    EXPECT_GE(summary.events, 50U);
  }
}

}  // namespace
}  // namespace tps

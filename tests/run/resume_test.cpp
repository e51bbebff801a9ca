// A run that was cut short anywhere goes on to the same bytes (issue: "killed at any moment").
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "reference/run/trace_file.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/output.hpp"
#include "tests/run/busy_scene.hpp"
#include "tests/run/heavy_scene.hpp"
#include "tests/run/traced_run.hpp"
#include "verify/certified/exact_timing.hpp"
#include "verify/scenes/terminal.hpp"

namespace tps {
namespace {

using testing::heavy_scene;
using testing::options_for;
using testing::read_bytes;
using testing::scratch;
using testing::write_bytes;

RunOptions with_states(const std::string& scalar, std::uint64_t max_events, std::uint64_t state_every = 7) {
  RunOptions options = options_for(scalar, max_events);
  options.state_every = state_every;
  return options;
}

struct Whole {
  Scene scene;
  std::string scalar;
  std::uint64_t events;
  Timing timing = Timing::stable;
};

RunOptions options_of(const Whole& w, std::uint64_t max_events) {
  static certified::ExactTiming certifier;
  RunOptions options = with_states(w.scalar, max_events);
  options.timing = w.timing;
  options.certifier = &certifier;
  return options;
}

std::string whole_trace(const Whole& w) {
  RunOptions options = options_of(w, w.events);
  options.trace = scratch("whole.ndjson");
  run_scene(w.scene, options);
  return read_bytes(options.trace);
}

std::vector<Whole> cases() {
  return {{busy_scene(.01), "double", 400},
          {busy_scene(.01), "float", 200},
          {busy_scene(.01), "mp50", 60},
          {heavy_scene(), "double", 200},
          {busy_scene(.01), "double", 400, Timing::certified},
          {busy_scene(.01), "float", 200, Timing::certified},
          {heavy_scene(), "double", 200, Timing::paper}};
}

TEST(Resume, AfterAnyNumberOfEventsGivesTheSameBytes) {
  for (const Whole& w : cases()) {
    const std::string whole = whole_trace(w);
    const std::uint64_t step = w.events / 20;
    for (std::uint64_t cut = 0; cut < w.events; cut += step + 1) {
      RunOptions options = options_of(w, cut);
      options.trace = scratch("cut.ndjson");
      run_scene(w.scene, options);
      RunOptions on = options_of(w, w.events);
      on.trace = options.trace;
      if (cut % 2 == 0) {  // to another file; the first one stays what it was
        const std::string before = read_bytes(options.trace);
        on.trace = scratch("other.ndjson");
        resume_run(options.trace, on);
        EXPECT_EQ(read_bytes(options.trace), before);
      } else {
        resume_run(options.trace, on);
      }
      ASSERT_EQ(read_bytes(on.trace), whole) << w.scalar << " cut after " << cut;
    }
  }
}

TEST(Resume, FromACheckpointGivesTheSameBytes) {
  for (const Whole& w : cases()) {
    const std::string whole = whole_trace(w);
    for (const std::uint64_t cut : {std::uint64_t{3}, std::uint64_t{7}, w.events / 2, w.events - 1}) {
      RunOptions options = options_of(w, cut);
      options.trace = scratch("cut.ndjson");
      options.checkpoint = scratch("checkpoint.json");
      run_scene(w.scene, options);
      RunOptions on = options_of(w, w.events);
      on.trace = options.trace;
      resume_run(options.checkpoint, on);
      ASSERT_EQ(read_bytes(on.trace), whole) << w.scalar << " cut after " << cut;
    }
  }
}

TEST(Resume, AfterAnEndByTimeGivesTheSameBytes) {
  Scene scene = busy_scene(.01);
  RunOptions options = with_states("double", std::numeric_limits<std::uint64_t>::max());
  options.trace = scratch("whole.ndjson");
  run_scene(scene, options);
  const std::string whole = read_bytes(options.trace);
  for (const double until : {0., .3, .5, 1.7}) {
    options.until = until;
    options.trace = scratch("cut.ndjson");
    run_scene(scene, options);
    RunOptions on = options;
    on.until.reset();
    resume_run(options.trace, on);
    EXPECT_EQ(read_bytes(options.trace), whole) << until;
  }
}

TEST(Resume, ACheckpointOfAnotherRunIsRefused) {
  RunOptions options = with_states("double", 20);
  options.trace = scratch("a.ndjson");
  run_scene(heavy_scene(), options);
  RunOptions other = with_states("double", 20);
  other.checkpoint = scratch("b.json");
  Scene scene = heavy_scene();
  scene.particles[4].velocity[0] = .5;
  run_scene(scene, other);
  const std::string before = read_bytes(options.trace);
  EXPECT_THROW(resume_run(other.checkpoint, options), InputError);
  EXPECT_EQ(read_bytes(options.trace), before);
}

TEST(Resume, AFileCutOffAtAnyByteGoesOnOrSaysThatItHoldsNoState) {
  const Whole w{heavy_scene(), "double", 40};
  const std::string whole = whole_trace(w);
  const std::size_t first_state_end = whole.find('\n', whole.find("\n{\"state\":0") + 1) + 1;
  std::vector<std::size_t> cuts = {0,
                                   1,
                                   whole.find('\n'),
                                   whole.find('\n') + 1,
                                   first_state_end - 1,
                                   first_state_end,
                                   whole.size() - 1,
                                   whole.size()};
  for (std::size_t cut = 97; cut < whole.size(); cut += 997) cuts.push_back(cut);
  for (const std::size_t cut : cuts) {
    RunOptions on = with_states("double", w.events);
    on.trace = scratch("cut.ndjson");
    write_bytes(on.trace, whole.substr(0, cut));
    if (cut < first_state_end) {
      EXPECT_THROW(resume_run(on.trace, on), InputError) << cut;
      EXPECT_EQ(read_bytes(on.trace), whole.substr(0, cut));
    } else {
      resume_run(on.trace, on);
      ASSERT_EQ(read_bytes(on.trace), whole) << cut;
    }
  }
}

/// The trace of `w` with its last full state changed, resumed for a few events: an answer or an InputError.
bool resumes(const std::string& bytes, std::uint64_t events) {
  RunOptions on = with_states("double", events);
  on.trace = scratch("changed.ndjson");
  write_bytes(on.trace, bytes);
  try {
    resume_run(on.trace, on);
    return true;
  } catch (const InputError&) {
    EXPECT_EQ(read_bytes(on.trace), bytes) << "a state that is refused costs the file nothing";
    return false;
  }
}

/// The bytes with the last full state damaged somewhere.
std::string with_damage(std::string bytes, std::mt19937& random, bool heavy) {
  const std::size_t start = bytes.rfind("\n{\"state\":") + 1;
  const std::size_t end = bytes.find('\n', start);
  const std::size_t at = start + 10 + random() % (end - start - 10);
  if (heavy) return bytes.erase(at, 1 + random() % 40);
  bytes[at] = "0123456789abcdef\"[]{},:-+.pxn"[random() % 29];
  return bytes;
}

TEST(Resume, ADamagedStateIsRefusedOrGoesOnAsIfItWereWhole) {
  const Whole w{busy_scene(.01), "double", 60};
  const std::string whole = whole_trace(w);
  ASSERT_TRUE(resumes(whole, 80));
  const std::string right = read_bytes(scratch("changed.ndjson"));
  const std::size_t kept = whole.rfind("\n{\"state\":") + 1;
  std::mt19937 random(7);
  int refused = 0;
  constexpr int kTries = 600;
  for (int n = 0; n < kTries; ++n) {
    const std::string bytes = with_damage(whole, random, n % 3 == 0);
    if (!resumes(bytes, 80)) {
      ++refused;
    } else {
      EXPECT_EQ(read_bytes(scratch("changed.ndjson")).substr(kept), right.substr(kept)) << bytes.substr(kept);
    }
  }
  EXPECT_GT(refused, kTries * 9 / 10);
}

TEST(Resume, AStateWithoutAChecksumMayGoOnDifferentlyButNeverCrashes) {
  const Whole w{busy_scene(.01), "double", 60};
  std::string whole = whole_trace(w);
  const std::size_t checksum = whole.find(",\"checksum\"", whole.rfind("\n{\"state\":"));
  whole.erase(checksum, whole.find('}', checksum) - checksum);
  ASSERT_TRUE(resumes(whole, 80)) << "older files have none";
  std::mt19937 random(8);
  int refused = 0;
  constexpr int kTries = 600;
  for (int n = 0; n < kTries; ++n) refused += resumes(with_damage(whole, random, n % 3 == 0), 80) ? 0 : 1;
  EXPECT_GT(refused, kTries / 2);
}

TEST(Resume, NamesWhatDoesNotFit) {
  const Whole w{busy_scene(.01), "double", 60};
  const std::string whole = whole_trace(w);
  const std::size_t start = whole.rfind("\n{\"state\":") + 1;
  const auto with = [&](const std::string& old_text, const std::string& new_text) {
    std::string bytes = whole;
    const std::size_t at = bytes.find(old_text, start);
    EXPECT_NE(at, std::string::npos) << old_text;
    if (at == std::string::npos) return bytes;
    return bytes.replace(at, old_text.size(), new_text);
  };
  EXPECT_TRUE(resumes(whole, 80));
  for (const char* effect : {"phases", "scheduled_impulses"}) {
    std::string bytes = whole;
    const std::size_t at = bytes.find("\"progress\":{", start) + 12;
    bytes.replace(at, bytes.find('}', at) - at, std::string("\"") + effect + "\":99");
    EXPECT_FALSE(resumes(bytes, 80)) << effect;
  }
  EXPECT_FALSE(resumes(with("\"position\":[\"", "\"position\":[\"inf\",\""), 80));
  EXPECT_FALSE(resumes(with("\"observations\":[[\"", "\"observations\":[[\"x\",\"y\",\""), 80));
  EXPECT_FALSE(resumes(with("\"id\":3,", "\"id\":-77,"), 80));
  EXPECT_FALSE(resumes(with("\"now\":[\"", "\"now\":[\"nan"), 80));
  EXPECT_FALSE(resumes(with("\"checksum\":\"crc64:", "\"checksum\":\"crc64:0"), 80));
}

TEST(Resume, AHeadThatIsNotOursIsRefused) {
  const std::string whole = whole_trace({heavy_scene(), "double", 20});
  const auto with = [&](const std::string& old_text, const std::string& new_text) {
    std::string bytes = whole;
    return bytes.replace(bytes.find(old_text), old_text.size(), new_text);
  };
  EXPECT_FALSE(resumes(with("{\"trace\":1", "{\"trace\":2"), 30));
  EXPECT_FALSE(resumes(with("{\"trace\":1", "{\"trace\":1,\"trace\":1"), 30));
  EXPECT_FALSE(resumes(with("\"semantics\":", "\"semantics\":9"), 30));
  EXPECT_FALSE(resumes(with("\"state_every\":7", "\"state_every\":8"), 30)) << "the checksum of the head";
  EXPECT_FALSE(resumes(with("\"mass\":1,", "\"mass\":2,"), 30)) << "the checksum of the head";
  EXPECT_FALSE(resumes(with("\"options\"", "\"optoins\""), 30));
  EXPECT_TRUE(resumes(with(",\"version\":\"", ",\"version\":\"of another program "), 30));
}

}  // namespace
}  // namespace tps

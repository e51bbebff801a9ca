// The one-pass reader of our own spelling reads what the reader of any JSON reads, and refuses no less. The
// latter is asked by a space, which the former leaves to it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/run/traced_run.hpp"
#include "tests/trace_check/scenes.hpp"
#include "verify/scenes/cradle.hpp"
#include "verify/trace_check/read_line.hpp"

namespace tps::check {
namespace {

std::string spelt(const std::optional<Vec<double>>& v) {
  return v ? fmt::format("({:a}, {:a}, {:a})", (*v)[0], (*v)[1], (*v)[2]) : "none";
}

/// Everything that an event says.
std::string spelt(const EventLine<double>& e) {
  std::string text = fmt::format("{} {:a} {:a} '{}' {:a} {} {} {} ", e.k.value_or(0), e.t.hi, e.t.lo,
                                 e.t_text, e.dt.value_or(-1), name(e.kind), e.i, e.j);
  text += fmt::format("{} {} {} ", e.phase.value_or(-1), e.wall.value_or(-1), e.face.value_or(-1));
  for (const InvolvedParticle<double>& p : e.involved) {
    text += fmt::format("{}: {} {} {} {} {} {}; ", p.particle, spelt(p.position_before),
                        spelt(p.velocity_before), spelt(p.position_after), spelt(p.velocity_after),
                        spelt(p.spin_before), spelt(p.spin_after));
  }
  text += fmt::format("{} {} {} ", spelt(e.dp), spelt(e.dp_stored), spelt(e.dv));
  text +=
      fmt::format("{} {} {:a}", e.sticks ? *e.sticks : -1, e.formed ? *e.formed : -1, e.draw.value_or(-1));
  for (const int member : e.members) text += fmt::format(" {}", member);
  return text;
}

/// The event of a line, or what is wrong with it.
std::string outcome(LineReading<double>& reading, const std::string& line) {
  try {
    const Line<double> read = reading.read(line);
    const auto* event = std::get_if<EventLine<double>>(&read);
    return event == nullptr ? "no event" : spelt(*event);
  } catch (const LineProblem& problem) {
    return problem.pointer + " " + problem.what();
  }
}

std::string with_a_space(const std::string& line) {
  return "{ " + line.substr(1);
}

class OwnSpellings : public ::testing::TestWithParam<const char*> {};

TEST_P(OwnSpellings, AreReadAsAnyJson) {
  const mutation::NamedScene named = mutation::scene_named(GetParam());
  const testing::TracedRun run = testing::traced(named.scene, "double", 60);
  LineReading<double> reading(named.scene, false, 53);
  std::mt19937_64 random(4);
  const std::string bytes = "0123456789abcdefpx+-.,:\"{}[] \\kz";
  int events = 0, refused = 0;
  for (std::string line : run.lines) {
    if (!line.starts_with("{\"k\":")) continue;
    ++events;
    ASSERT_EQ(outcome(reading, line), outcome(reading, with_a_space(line))) << line;
    for (int n = 0; n < 100; ++n) {
      std::string other = line;
      const std::size_t at = 6 + random() % (line.size() - 6);
      const char byte = bytes[random() % bytes.size()];
      if (n % 3 == 0) {
        other[at] = byte;
      } else if (n % 3 == 1) {
        other.insert(at, 1, byte);
      } else {
        other.erase(at, 1 + random() % 3);
      }
      const std::string of_json = outcome(reading, with_a_space(other));
      ASSERT_EQ(outcome(reading, other), of_json) << other;
      refused += of_json.starts_with("/") || of_json.starts_with(" ") ? 1 : 0;
    }
  }
  EXPECT_GT(events, 10);
  EXPECT_GT(refused, 10 * events);
}

INSTANTIATE_TEST_SUITE_P(Of, OwnSpellings,
                         ::testing::Values("gas", "grouped", "terminal", "dicing", "granular"));

/// A row of balls that becomes one body pair by pair: lines of many particles.
std::vector<std::string> lines_of_a_large_body(const Scene& scene) {
  std::vector<std::string> large;
  for (const std::string& line : testing::traced(scene, "double", 1000).lines) {
    if (line.starts_with("{\"k\":") && line.size() > 4000) large.push_back(line);
  }
  return large;
}

Scene row_of_balls() {
  Scene scene = build_cradle({.particles = 24});
  scene.grouping = Grouping{1.0};
  return scene;
}

std::string with(std::string text, const std::string& part, const std::string& other) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + other.size()))
    text.replace(at, part.size(), other);
  return text;
}

TEST(OwnSpelling, ParticlesOfALargeBodyStandThereOnce) {
  const Scene scene = row_of_balls();
  LineReading<double> reading(scene, false, 53);
  const std::vector<std::string> lines = lines_of_a_large_body(scene);
  ASSERT_FALSE(lines.empty());
  for (const std::string& line : lines) {
    EXPECT_EQ(outcome(reading, line), outcome(reading, with_a_space(line)));
    const std::string twice = with(line, "\"7\":{", "\"3\":{");
    ASSERT_NE(twice, line);
    EXPECT_NE(outcome(reading, twice).find("stands twice"), std::string::npos) << outcome(reading, twice);
    EXPECT_EQ(outcome(reading, twice), outcome(reading, with_a_space(twice)));
  }
}

TEST(EventLine, FindsWhoIsInvolvedInWhateverOrder) {
  std::mt19937_64 random(5);
  for (const int count : {0, 1, 2, 8, 9, 100}) {
    std::vector<int> ids(static_cast<std::size_t>(count));
    for (int n = 0; n < count; ++n) ids[static_cast<std::size_t>(n)] = 3 * n + 1;
    std::shuffle(ids.begin(), ids.end(), random);
    EventLine<double> event;
    for (const int id : ids) event.involved.push_back({id, {}, {}, {}, {}});
    EXPECT_TRUE(event.index_involved());
    for (int id = 0; id <= 3 * count; ++id) {
      const InvolvedParticle<double>* found = event.of(id);
      ASSERT_EQ(found != nullptr, id % 3 == 1) << id << " of " << count;
      if (found != nullptr) {
        EXPECT_EQ(found->particle, id);
      }
    }
    if (count < 2) continue;
    event.involved.back().particle = event.involved.front().particle;
    EXPECT_FALSE(event.index_involved()) << count;
    event.restart();
    EXPECT_EQ(event.of(1), nullptr);
  }
}

}  // namespace
}  // namespace tps::check

// The mutations by themselves: what they do to a trace is what they say, before any checker looks.
#include <gtest/gtest.h>

#include <set>

#include "tests/trace_check/edits.hpp"
#include "tests/trace_check/scenes.hpp"

namespace tps::mutation {
namespace {

constexpr std::uint64_t kTries = 2;

class Mutations : public ::testing::TestWithParam<std::string> {};

std::string file_of(const std::string& name, const std::string& scalar = "double") {
  const NamedScene named = scene_named(name);
  return trace_bytes(named.scene, scalar, Timing::stable, std::min<std::uint64_t>(named.events, 80));
}

std::vector<std::string> short_scenes() {
  std::vector<std::string> names = scene_names();
  std::erase_if(names, stands_still);
  return names;
}

/// The lines behind the header, whose scene may spell its decimals in more than one way, without the
/// checksums of states, which a mutation does not keep.
std::string body_of(const std::string& bytes) {
  const std::string member = ",\"checksum\":\"crc64:0123456789abcdef\"";
  std::string body = bytes.substr(bytes.find('\n'));
  for (std::size_t at = 0; (at = body.find(",\"checksum\":", at)) != std::string::npos;)
    body.erase(at, member.size());
  return body;
}

TEST_P(Mutations, AGoodTraceIsReadAndSettledToItself) {
  for (const char* scalar : {"double", "float"}) {
    const std::string bytes = file_of(GetParam(), scalar);
    Trace trace = trace_of(bytes);
    EXPECT_EQ(body_of(text_of(trace)), body_of(bytes));
    settle(trace);
    EXPECT_EQ(body_of(text_of(trace)), body_of(bytes));
    EXPECT_EQ(trace.scene, scene_named(GetParam()).scene);
  }
}

/// What rule `order` demands, of a trace whose lines are sound.
bool is_in_order(const Trace& trace) {
  Trace settled = trace;
  settle(settled);
  const std::vector<std::size_t> events = event_lines(trace);
  for (std::size_t n = 0; n < events.size(); ++n) {
    const Json& event = trace.lines[events[n]];
    if (event.at("k") != n + 1 || event.at("dt") != settled.lines[events[n]].at("dt")) return false;
    if (n > 0 && elapsed(trace.lines[events[n - 1]].at("t"), event.at("t")) < 0) return false;
  }
  return true;
}

TEST_P(Mutations, DifferFromTheOriginalAndKeepTheOrderUnlessTheyBreakIt) {
  const Trace good = trace_of(file_of(GetParam()));
  const std::string bytes = text_of(good);
  for (const Mutation& m : mutations()) {
    for (std::uint64_t number = 0; number < kTries; ++number) {
      Trace trace = good;
      const Broken broken = m.apply(trace, number);
      EXPECT_EQ(text_of(trace) != bytes, broken.has_value()) << m.name;
      if (!broken) continue;
      const std::uint64_t events = good.lines.back().at("events");
      EXPECT_LE(*broken, events + 1) << m.name;
      const bool may_break_order =
          m.owner == check::Rule::order || m.owner == check::Rule::schema || m.name == "event_behind_the_end";
      if (!may_break_order) {
        EXPECT_TRUE(is_in_order(trace)) << m.name << ' ' << number;
      }
      if (m.owner == check::Rule::order && m.name != "ties_exchanged") {
        EXPECT_FALSE(is_in_order(trace)) << m.name << ' ' << number;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scene, Mutations, ::testing::ValuesIn(short_scenes()), [](const auto& scene) {
  std::string name = scene.param;
  std::erase(name, '-');
  return name;
});

TEST(MutationList, HasEveryRuleAndNoNameTwice) {
  std::set<std::string_view> names;
  std::set<check::Rule> owners;
  for (const Mutation& m : mutations()) {
    EXPECT_TRUE(names.insert(m.name).second) << m.name;
    EXPECT_FALSE(m.sentence.empty()) << m.name;
    owners.insert(m.owner);
  }
  EXPECT_GE(names.size(), 36U);
  for (const check::RuleFacts& rule : check::kRuleFacts) {
    if (rule.rule != check::Rule::bias) {
      EXPECT_TRUE(owners.contains(rule.rule)) << rule.name;
    }
  }
}

}  // namespace
}  // namespace tps::mutation

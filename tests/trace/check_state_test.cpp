// A full state that cannot be one of its scene is told from those that runs leave behind.
#include "reference/trace/check_state.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "reference/run/run.hpp"
#include "reference/text/hexfloat.hpp"
#include "reference/text/input_error.hpp"
#include "tests/run/busy_scene.hpp"

namespace tps {
namespace {

/// The full states of a run, as they are read.
std::vector<StateData> states_of(const Scene& scene, ScalarKind scalar, std::uint64_t events) {
  RunOptions options;
  options.scalar = scalar;
  options.max_events = events;
  options.state_every = 5;
  const std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  options.trace =
      (std::filesystem::path(::testing::TempDir()) / ("check_state_" + test + ".ndjson")).string();
  run_scene(scene, options);
  std::vector<StateData> states;
  std::ifstream in(options.trace);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("{\"state\":")) states.push_back(read_state(line));
  }
  return states;
}

std::string words_of(const std::vector<StateProblem>& problems) {
  std::string text;
  for (const StateProblem& problem : problems) text += problem.pointer + " " + problem.message + "\n";
  return text;
}

TEST(CheckState, StatesOfRunsHaveNothingWrong) {
  const Scene scene = busy_scene(.05);
  const std::vector<std::pair<ScalarKind, int>> scalars = {
      {ScalarKind::double_, 53}, {ScalarKind::float_, 24}, {ScalarKind::mp50, 168}};
  for (const auto& [scalar, digits] : scalars) {
    std::size_t with_groups = 0;
    for (const StateData& state : states_of(scene, scalar, scalar == ScalarKind::double_ ? 600 : 150)) {
      EXPECT_EQ(words_of(state_problems(scene, state, digits)), "");
      EXPECT_EQ(state.checksum, StateData::Checksum::right);
      if (!state.groups.empty()) ++with_groups;
    }
    EXPECT_GT(with_groups, 3U);
  }
}

/// A space before a key is another spelling of the same state, which the reader of all JSON reads.
TEST(ReadState, IsOneStateInEverySpelling) {
  for (const ScalarKind scalar : {ScalarKind::double_, ScalarKind::float_, ScalarKind::mp100}) {
    int with_pairs = 0;
    for (const StateData& state : states_of(busy_scene(.05), scalar, 60)) {
      const std::string line = write_state(state, state.t);
      const std::string spaced = "{ " + line.substr(1);
      const StateData own = read_state(line), other = read_state(spaced);
      EXPECT_EQ(write_state(own, own.t), line);
      EXPECT_EQ(write_state(other, other.t), line);
      EXPECT_EQ(own.checksum, StateData::Checksum::right);
      EXPECT_EQ(other.checksum, StateData::Checksum::right);
      with_pairs += own.responded.empty() ? 0 : 1;
    }
    EXPECT_GT(with_pairs, 3);
  }
}

/// A change that leaves a state which no run of the scene has; nothing where there is nothing to change.
struct Lie {
  const char* name;
  std::function<bool(StateData&)> tell;
};

template <typename List>
bool change_first(List& list, const std::function<void(typename List::value_type&)>& change) {
  if (list.empty()) return false;
  change(list.front());
  return true;
}

std::vector<Lie> lies() {
  using S = StateData;
  return {
      {"another number of events", [](S& s) { return ++s.k > 0; }},
      {"progress ahead", [](S& s) { return (s.progress_event = s.k + 1) > 0; }},
      {"now before the last event",
       [](S& s) {
         return s.k > 0 && (s.now = {"0x0p+0", "0x0p+0"}, true);
       }},
      {"lo as large as hi", [](S& s) { return (s.now[1] = s.now[0]) != "0x0p+0"; }},
      {"negative time", [](S& s) { return (s.last_event[0] = "-0x1p+0", true); }},
      {"clock ahead",
       [](S& s) {
         return change_first<decltype(s.particles)>(s.particles, [](auto& p) { p.clock[0] = "0x1p+40"; });
       }},
      {"particle twice", [](S& s) { return (s.particles[0].id = s.particles[1].id, true); }},
      {"particle missing", [](S& s) { return (s.particles.pop_back(), true); }},
      {"particle unknown", [](S& s) { return (s.particles[0].id = 123456, true); }},
      {"component missing", [](S& s) { return (s.particles[0].position.pop_back(), true); }},
      {"self-tether",
       [](S& s) { return change_first<decltype(s.tethers)>(s.tethers, [](auto& t) { t[1] = t[0]; }); }},
      {"tether backwards",
       [](S& s) {
         return change_first<decltype(s.tethers)>(s.tethers, [](auto& t) { std::swap(t[0], t[1]); });
       }},
      {"tether twice", [](S& s) { return !s.tethers.empty() && (s.tethers.push_back(s.tethers[0]), true); }},
      {"tether to the unknown",
       [](S& s) { return change_first<decltype(s.tethers)>(s.tethers, [](auto& t) { t[1] = 123456; }); }},
      {"responded to itself",
       [](S& s) {
         return (s.responded.push_back({s.particles[0].id, s.particles[0].id, false}), true);
       }},
      {"responded twice",
       [](S& s) { return !s.responded.empty() && (s.responded.push_back(s.responded[0]), true); }},
      {"member twice",
       [](S& s) {
         return change_first<decltype(s.groups)>(s.groups,
                                                 [](auto& g) { g.members.push_back(g.members.back()); });
       }},
      {"member missing",
       [](S& s) {
         return change_first<decltype(s.groups)>(s.groups, [](auto& g) { g.members.pop_back(); });
       }},
      {"mass doubled",
       [](S& s) { return change_first<decltype(s.groups)>(s.groups, [](auto& g) { g.mass = "0x1.8p+9"; }); }},
      {"mass off by rounding thrice",
       [](S& s) {
         return change_first<decltype(s.groups)>(s.groups, [](auto& g) {
           const double m = from_hex<double>(g.mass).value();
           g.mass = to_hex(m * (1 + 0x1p-45));
         });
       }},
      {"expired",
       [](S& s) {
         return s.k > 0 && change_first<decltype(s.groups)>(s.groups, [](auto& g) {
                  g.expiry = {"0x0p+0", "0x0p+0"};
                });
       }},
      {"expires after ages",
       [](S& s) {
         return change_first<decltype(s.groups)>(s.groups, [](auto& g) {
           g.expiry = {"0x1p+900", "0x0p+0"};
         });
       }},
      {"never expires",
       [](S& s) {
         return change_first<decltype(s.groups)>(s.groups, [](auto& g) { g.expiry = {"inf", "0x0p+0"}; });
       }},
      {"expires too late",
       [](S& s) {
         const double now = from_hex<double>(s.now[0]).value();
         return change_first<decltype(s.groups)>(s.groups, [&](auto& g) {
           g.expiry = {to_hex(static_cast<float>(now + 0.5)), "0x0p+0"};
         });
       }},
      {"born ahead",
       [](S& s) {
         return change_first<decltype(s.groups)>(s.groups, [](auto& g) { g.birth = {"0x1p+40", "0x0p+0"}; });
       }},
      {"sides exchanged",
       [](S& s) {
         return change_first<decltype(s.groups)>(
             s.groups, [](auto& g) { std::swap(g.nodes[0].sides[0], g.nodes[0].sides[1]); });
       }},
      {"node of itself",
       [](S& s) {
         return change_first<decltype(s.groups)>(s.groups, [](auto& g) {
           g.nodes[0].sides[0] = {0, std::nullopt};
         });
       }},
      {"side of nobody",
       [](S& s) {
         return change_first<decltype(s.groups)>(s.groups, [](auto& g) { g.nodes[0].sides[0] = {}; });
       }},
      {"no nodes",
       [](S& s) { return change_first<decltype(s.groups)>(s.groups, [](auto& g) { g.nodes.clear(); }); }},
      {"node twice",
       [](S& s) {
         return change_first<decltype(s.groups)>(s.groups,
                                                 [](auto& g) { g.nodes.push_back(g.nodes.back()); });
       }},
      {"velocities of a body differ",
       [](S& s) {
         if (s.groups.empty() || s.groups[0].members.size() < 2) return false;
         for (auto& p : s.particles) {
           if (p.id == s.groups[0].members[0]) p.velocity[0] = "0x1.2345p+0";
         }
         return true;
       }},
      {"body twice", [](S& s) { return !s.groups.empty() && (s.groups.push_back(s.groups[0]), true); }},
      {"draw for nothing",
       [](S& s) { return change_first<decltype(s.draws)>(s.draws, [](auto& d) { d.purpose = 9; }); }},
      {"draw of one",
       [](S& s) { return change_first<decltype(s.draws)>(s.draws, [](auto& d) { d.second = d.first; }); }},
      {"effect unknown", [](S& s) { return (s.progress["nothing"] = 1, true); }},
      {"too many phases", [](S& s) { return (s.progress["phases"] = 9, true); }},
      {"too many impulses", [](S& s) { return (s.progress["scheduled_impulses"] = 99, true); }},
      {"kind unknown", [](S& s) { return (s.counts["collide"] = 0, true); }},
      {"kind uncounted", [](S& s) { return s.counts["rebound"] > 0 && (s.counts["rebound"] -= 1, true); }},
      {"counter missing", [](S& s) { return s.counts.erase("#noise") > 0; }},
      {"quantity missing", [](S& s) { return s.quantities.erase("work") > 0; }},
      {"quantity unknown", [](S& s) { return (s.quantities["joy"] = {"0x1p+0"}, true); }},
      {"quantity too short", [](S& s) { return (s.quantities["lost"].pop_back(), true); }},
      {"observation cut",
       [](S& s) {
         return (s.observations.push_back({"sample", "0x1p+0"}), true);
       }},
  };
}

TEST(CheckState, EveryLieIsFoundInEveryStateThatHasRoomForIt) {
  const Scene scene = busy_scene(.05);
  const std::vector<StateData> states = states_of(scene, ScalarKind::double_, 400);
  for (const Lie& lie : lies()) {
    std::size_t told = 0;
    for (const StateData& state : states) {
      StateData changed = state;
      changed.t.clear();  // "t" would betray a change of now
      if (!lie.tell(changed)) continue;
      if (write_state(changed, state.t) == write_state(state, state.t)) continue;  // true already
      ++told;
      EXPECT_NE(words_of(state_problems(scene, changed, 53)), "") << lie.name << ", state " << state.k;
    }
    EXPECT_GT(told, 2U) << lie.name;
  }
}

TEST(ReadState, IsStrict) {
  const std::string line = [] {
    const std::vector<StateData> states = states_of(busy_scene(.05), ScalarKind::double_, 60);
    return write_state(states.back(), states.back().t);
  }();
  const auto refusal = [&](const std::string& from, const std::string& to) {
    std::string changed = line;
    const std::size_t at = changed.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    changed.replace(at, from.size(), to);
    try {
      return std::string(read_state(changed).checksum == StateData::Checksum::wrong ? "checksum"
                                                                                    : "accepted");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_NE(refusal("\"state\":", "\"state\":-").find("/state: is -"), std::string::npos);
  EXPECT_NE(refusal("\"progress_event\"", "\"progres_event\"").find("did you mean progress_event?"),
            std::string::npos);
  EXPECT_NE(refusal("\"clock\":[", "\"clock\":[\"0x1p+0\",").find("a list of 2 entries stands here"),
            std::string::npos);
  EXPECT_NE(refusal("\"now\":[", "\"now\":[],\"now\":[").find("stands twice"), std::string::npos);
  EXPECT_NE(refusal("\"limit\":\"inner\"", "\"limit\":\"middle\"").find("allowed are"), std::string::npos);
  EXPECT_NE(refusal("\"now\":[\"0x", "\"now\":[\"0y").find("not a hexadecimal float"), std::string::npos);
  EXPECT_NE(refusal("\"now\":[", "\"now\":[\"0x1p-1000000000\",\"0x0p+0\"],\"later\":[").find("/"),
            std::string::npos);
  EXPECT_EQ(refusal("{\"state\":", " { \"state\" : "), "accepted") << "spaces are not content";
  EXPECT_EQ(refusal("\"#zero_impulse\":0", "\"#zero_impulse\":1"), "checksum");
  EXPECT_EQ(refusal("\"particles\":[{\"id\":0", "\"particles\":[{\"id\":7"), "checksum");
  EXPECT_NE(refusal("\"particles\":[{\"id\":0", "\"particles\":[{\"id\":00").find("state:1"),
            std::string::npos);
  EXPECT_NE(refusal("\"velocity\":[\"", "\"velocity\":[\"0y").find("is not a hexadecimal float"),
            std::string::npos);
  for (const char* sum : {"lost", "stored", "work", "kinetic_at_start", "from_outside_0"}) {
    const std::string beginning = fmt::format("\"{}\":[\"", sum);
    EXPECT_NE(refusal(beginning, beginning + "inf\",\"").find("is not a hexadecimal float"),
              std::string::npos)
        << sum;
  }
}

TEST(CheckState, KicksAtRandomTimesAreNoMoreThanEvents) {
  Scene scene = busy_scene(.05);
  scene.grouping.reset();
  for (Species& species : scene.species) species.thermostat = Thermostat{scene.duration / 20, 1};
  const std::vector<StateData> states = states_of(scene, ScalarKind::double_, 60);
  ASSERT_FALSE(states.empty());
  StateData state = states.back();
  EXPECT_EQ(words_of(state_problems(scene, state, 53)), "");
  const auto kicked = std::find_if(state.draws.begin(), state.draws.end(),
                                   [](const StateData::Draws& d) { return d.first == d.second; });
  ASSERT_NE(kicked, state.draws.end());
  kicked->used = 1U << 31U;  // so many waits would be drawn again
  state.t.clear();
  EXPECT_NE(words_of(state_problems(scene, state, 53)).find("counts 2147483648 impulses"), std::string::npos);
}

}  // namespace
}  // namespace tps

// Laws that cannot judge minimal traces have the check judge them.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "properties/runs/trace_check_instead.hpp"
#include "reference/scene/read_scene.hpp"
#include "reference/text/hexfloat.hpp"
#include "reference/text/number_text.hpp"

namespace tps::properties::runs {
namespace {

using Json = nlohmann::ordered_json;

/// The reference's run as another program may write it: time, kind, pair and velocities after each event.
/// With a fault, every collision adds a quarter to a velocity of i.
class MinimalSimulator final : public Simulator {
 public:
  explicit MinimalSimulator(bool faulty) : faulty_(faulty) {}
  std::string name() const override { return "minimal"; }
  std::string scalar() const override { return "double"; }
  std::string timing() const override { return "stable"; }
  std::optional<std::string> go_on(const std::string&, const Extent&) override { return std::nullopt; }

  std::string simulate(const Scene& scene, const Extent& extent) override {
    std::istringstream full(reference_->simulate(scene, extent));
    std::string minimal;
    for (std::string line; std::getline(full, line);) {
      Json json = Json::parse(line);
      if (json.contains("state")) continue;
      if (json.contains("trace")) {
        json = {{"trace", 1}, {"form", "minimal"}, {"scalar", "double"}, {"scene", json["scene"]}};
      } else if (json.contains("kind")) {
        json = event(json);
      }
      minimal += json.dump() + "\n";
    }
    return minimal;
  }

 private:
  Json event(const Json& full) {
    Json minimal{{"t", full["t"]}, {"kind", full["kind"]}};
    for (const char* key : {"i", "j", "tether", "draw", "phase", "members"})
      if (full.contains(key)) minimal[key] = full[key];
    const Json post = full.value("post", Json::object());
    for (const auto& [id, state] : post.items()) minimal["post"][id] = {{"velocity", state["velocity"]}};
    if (faulty_ && full.contains("dp")) {
      Json& v = minimal["post"][std::to_string(full["i"].get<int>())]["velocity"][0];
      v = to_hex<double>(parse_hex_float(v.get<std::string>()).value + 0.25);
      ++faults;
    }
    return minimal;
  }

  bool faulty_;
  std::unique_ptr<Simulator> reference_ = reference_simulator("double", "stable");

 public:
  int faults = 0;
};

/// What the latest failure said.
std::string why;

bool fails(const RunLaw& law, MinimalSimulator& simulator, Instead* instead) {
  rc::detail::TestParams params;
  params.seed = 5;
  params.maxSuccess = 40;
  params.disableShrinking = true;
  const rc::detail::TestResult result =
      rc::detail::checkTestable([&] { check_law(law, simulator, 0, instead); },
                                rc::detail::TestMetadata{law.name, law.sentence}, params);
  if (!result.is<rc::detail::FailureResult>()) return false;
  why = result.get<rc::detail::FailureResult>().description;
  return true;
}

const RunLaw& momentum() {
  return run_laws().front();
}

/// The law, asked of one scene.
RunLaw momentum_of(const Scene& scene) {
  RunLaw law = momentum();
  law.judge = [scene](const Scene&, Simulator& simulator) { return momentum().judge(scene, simulator); };
  return law;
}

TEST(MinimalRuns, AreJudgedByTheCheckInstead) {
  MinimalSimulator honest(false);
  Instead instead = check_instead();
  const Scene scene = read_scene_file(TPS_SOURCE_DIR "/data/scenes/three-body.json");
  EXPECT_FALSE(fails(momentum_of(scene), honest, &instead)) << why;
  EXPECT_GE(instead.traces, 40U);
}

TEST(MinimalRuns, ABrokenMomentumIsFound) {
  MinimalSimulator faulty(true);
  Instead instead = check_instead();
  EXPECT_TRUE(fails(momentum(), faulty, &instead));
  EXPECT_NE(why.find("which the check judges instead"), std::string::npos) << why;
  EXPECT_GT(faulty.faults, 0);
}

TEST(MinimalRuns, WithoutTheCheckNoLawHolds) {
  MinimalSimulator honest(false);
  for (const RunLaw& law : run_laws()) {
    if (law.name == std::string("Detectors")) continue;  // compares runs of the reference, not this one
    EXPECT_TRUE(fails(law, honest, nullptr)) << law.name;
  }
}

TEST(MinimalRuns, LinesThatAreNoneAreNotPassedOver) {
  EXPECT_THROW(read_trace("{\"trace\":1}\n{\"t\":\"0x1p+0\"}\n"), std::runtime_error);
}

}  // namespace
}  // namespace tps::properties::runs

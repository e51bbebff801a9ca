// What `next_event` says of a scene is the first event of its run, whatever effects it calls for: what is not
// certified is simulated, and what is certified leaves nothing of the scene out.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "properties/runs/outlook_scenes.hpp"
#include "properties/runs/scenes.hpp"
#include "reference/run/next_event.hpp"
#include "reference/scene/write_scene.hpp"
#include "reference/text/hexfloat.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/json_document.hpp"
#include "verify/certified/exact_timing.hpp"
#include "verify/protocol/answer.hpp"

namespace tps::protocol {
namespace {

using nlohmann::json;
using properties::runs::SmallScene;

json asked(const Scene& scene) {
  const std::string in = "{\"scene\":" + write_scene(scene) + "}";
  const std::string source = "it";
  return json::parse(answer_text(operations::Op::next_event, parse_json(in, source).root, {source, ""}));
}

double largest_speed(const NextEvent& event) {
  double most = 0;
  for (const NextEvent::State& s : event.state) {
    for (const double v : s.velocity) most = std::max(most, std::abs(v));
  }
  return most;
}

/// How many of the scenes have a next event that is certified.
int judge(const rc::Gen<SmallScene>& scenes, std::uint64_t purpose, std::uint64_t count) {
  int certified = 0;
  for (std::uint64_t n = 0; n < count; ++n) {
    Scene scene = scenes(rc::Random(rc::Random::Key{n, purpose, 0, 0}), 100).value().scene;
    scene.grouping.reset();
    certified::ExactTiming certifier;
    const NextEvent simulated = next_event(scene, {Timing::certified, &certifier});
    const json answered = asked(scene);
    EXPECT_EQ(answered["kind"], simulated.kind) << write_scene(scene);
    if (answered.value("tied", false) || answered["kind"] != simulated.kind) continue;
    certified += answered.contains("simulated") || simulated.kind == "none" ? 0 : 1;
    EXPECT_EQ(answered.value("i", -1), simulated.i.value_or(-1)) << write_scene(scene);
    EXPECT_EQ(answered.value("j", -1), simulated.j.value_or(-1)) << write_scene(scene);
    for (std::size_t p = 0; p < simulated.state.size(); ++p) {
      for (std::size_t k = 0; k < simulated.state[p].velocity.size(); ++k)
        EXPECT_NEAR(from_hex<double>(answered["state"][p]["velocity"][k].get<std::string>()).value(),
                    simulated.state[p].velocity[k], 1e-9 * largest_speed(simulated))
            << write_scene(scene);
    }
  }
  return certified;
}

TEST(NextEventOfEffects, IsThatOfTheRun) {
  for (const properties::runs::Outlook effect : properties::runs::kOutlook) {
    SCOPED_TRACE(properties::runs::name_of(effect));
    judge(properties::runs::outlook_scene(effect), static_cast<std::uint64_t>(effect), 25);
  }
  EXPECT_GE(judge(properties::runs::small_scene(), 99, 100), 10);
}

}  // namespace
}  // namespace tps::protocol

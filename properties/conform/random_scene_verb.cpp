#include "properties/conform/random_scene_verb.hpp"

#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "properties/conform/random_scene.hpp"
#include "verify/cli/named_files.hpp"
#include "verify/cli/numbers.hpp"
#include "verify/cli/write_result.hpp"

namespace tps::cli {
namespace {

using namespace tps::properties::conform;

struct RandomSceneArguments {
  std::vector<std::string> features;
  std::uint64_t seed = 1, number = 0;
  std::string output = "-";
};

void write_random_scene(const RandomSceneArguments& a) {
  NamedFiles().writes("-o", a.output).require_distinct();
  try {
    check_features(a.features);
  } catch (const std::invalid_argument& error) {
    throw CLI::ValidationError("--features", error.what());
  }
  const auto scene = random_scene(a.features, a.seed, a.number);
  if (!scene) {
    throw CLI::ValidationError(
        "--number",
        fmt::format("scene {} of seed {} collapses or leaves the range of double; take another number",
                    a.number, a.seed));
  }
  write_result(a.output, text_of_random(*scene));
}

}  // namespace

void add_random_scene(CLI::App& scene_verb) {
  const auto a = std::make_shared<RandomSceneArguments>();
  CLI::App* verb =
      scene_verb.add_subcommand("random", "A small scene at random, as `tps conform --simulator` asks them");
  std::string features;
  for (const FeatureFacts& facts : scene_features())
    features += fmt::format("\n  {:<20}{}", facts.name, facts.meaning);
  verb->add_option("--features", a->features, "What scenes have, and have not; see below")
      ->delimiter(',')
      ->allow_extra_args(false);
  verb->add_option("--seed", a->seed, "Which scenes")
      ->check(integer_from(0, "a seed"))
      ->capture_default_str();
  verb->add_option("--number", a->number, "Which of them")
      ->check(integer_from(0, "a number"))
      ->capture_default_str();
  verb->add_option("-o,--output", a->output, "Write the scene here")->capture_default_str();
  verb->footer("Features:" + features +
               "\nExample: tps scene random --number 7 --features no-groups,2d -o scene.json");
  verb->callback([a] { write_random_scene(*a); });
}

}  // namespace tps::cli

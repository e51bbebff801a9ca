// tps scene
#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "reference/scene/read_scene.hpp"
#include "reference/scene/write_scene.hpp"
#include "verify/cli/named_files.hpp"
#include "verify/cli/verbs.hpp"
#include "verify/cli/when_called.hpp"
#include "verify/cli/write_result.hpp"
#include "verify/scenes/registry.hpp"

namespace tps::cli {
namespace {

struct SceneArguments {
  OptionValues values;
  std::string output = "-";
};

/// One subcommand a scene, its options and their help taken from the builder.
void add_builder(CLI::App& verb, const SceneBuilder& builder) {
  const auto a = std::make_shared<SceneArguments>();
  CLI::App* named = verb.add_subcommand(builder.name, builder.summary);
  named->add_option("-o,--output", a->output, "Write the scene here")->capture_default_str();
  for (const BuilderOption& option : builder.options) {
    const std::string name = option.name;
    named->add_option_function<std::string>(
        "--" + name, [a, name](const std::string& text) { a->values[name] = text; },
        fmt::format("{}; {}; default {}", option.meaning, option.range, option.default_value));
  }
  named->footer(fmt::format("Example: tps scene {} -o {}.json && tps run {}.json", builder.name, builder.name,
                            builder.name));
  named->callback([a, builder] {
    NamedFiles().writes("-o", a->output).require_distinct();
    try {
      const std::string text = write_scene(builder.build(a->values), SceneStyle::pretty);
      static_cast<void>(read_scene_text(text, fmt::format("the scene of these options ({})", builder.name)));
      write_result(a->output, text);
    } catch (const std::invalid_argument& error) {
      throw CLI::ValidationError(error.what());
    }
  });
}

}  // namespace

void add_scene(CLI::App& app, int&) {
  CLI::App* verb = app.add_subcommand("scene", "Writes a parametrised scene.");
  verb->require_subcommand(1);
  verb->footer("Example: tps scene terminal --seed 7 -o terminal.json");
  make_when_called(verb, [](CLI::App* called) {
    for (const SceneBuilder& builder : scene_builders()) add_builder(*called, builder);
  });
}

}  // namespace tps::cli

// tps import
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "reference/scene/write_scene.hpp"
#include "reference/text/file_kind.hpp"
#include "reference/text/printable.hpp"
#include "verify/cli/named_files.hpp"
#include "verify/cli/say.hpp"
#include "verify/cli/verbs.hpp"
#include "verify/cli/write_result.hpp"
#include "verify/import/arslab_tps.hpp"
#include "verify/scenes/builder.hpp"

namespace tps::cli {
namespace {

/// An option whose text becomes `target` when the command line is parsed.
void add_real(CLI::App& verb, const std::string& name, std::optional<double>& target, Range range,
              const std::string& meaning) {
  verb.add_option_function<std::string>(
      "--" + name,
      [&target, name, range](const std::string& text) {
        try {
          target = parse_real(name, text, range);
        } catch (const std::invalid_argument& error) {
          throw CLI::ValidationError(error.what());
        }
      },
      fmt::format("{}; {}", meaning, describe(range, false)));
}

}  // namespace

void add_import(CLI::App& app, int&) {
  struct Arguments {
    std::string file;
    std::string output = "-";
    arslab::ImportOptions options;
  };
  const auto a = std::make_shared<Arguments>();
  CLI::App* verb = app.add_subcommand("import", "Turns a scenario of the program ARSLab_TPS into a scene.");
  verb->add_option("file", a->file, "Scenario file (JSON), - for standard input")->required();
  verb->add_option("-o,--output", a->output, "Write the scene here")->capture_default_str();
  add_real(*verb, "c-rebound", a->options.c_rebound, from_to(0, 1),
           "Coefficient of restitution of every pair (default: 1, elastic)");
  add_real(*verb, "dt-restitute", a->options.dt_restitute, above(0, 1e100),
           "Group nearly simultaneous collisions, with this delay (default: no grouping)");
  add_real(*verb, "duration", a->options.duration, above(0),
           "Time simulated (default: config.runtime, or 25 where the file has none)");
  verb->add_flag("--without-random-impulses", a->options.without_random_impulses,
                 "Import a file whose config.ri is true, and drop its random impulses");
  verb->footer(
      "What is assumed or dropped is said on standard error.\n"
      "Example: tps import config.json -o scene.json && tps run scene.json --scalar float");
  verb->callback([a] {
    NamedFiles().reads("file", a->file).writes("-o", a->output).require_distinct();
    refuse_other_kinds_of_file(a->file, "a scenario of the program ARSLab_TPS", {FileKind::arslab_tps});
    JsonDocument document =
        parse_json_file(a->file, "a scenario of this size has too many particles for one run: use fewer",
                        arslab::import_limits);
    const arslab::ImportedScene imported = arslab::import_scenario(std::move(document), a->options);
    write_result(a->output, write_scene(imported.scene, SceneStyle::pretty));
    for (const std::string& note : imported.notes) say("tps: note: {}\n", printable(note));
  });
}

}  // namespace tps::cli

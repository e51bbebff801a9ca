// tps explain
#include <fmt/format.h>

#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

#include "reference/run/explain.hpp"
#include "reference/scene/read_scene.hpp"
#include "reference/text/json_pointer.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"
#include "verify/cli/named_files.hpp"
#include "verify/cli/verbs.hpp"
#include "verify/cli/write_result.hpp"

namespace tps::cli {
namespace {

/// Where in the file a place of the scene is.
std::size_t line_of(const CallingPlace& place, const JsonValue& document) {
  return resolve_pointer(document, place.pointer).line;
}

std::string with_line(const CallingPlace& place, const JsonValue& document) {
  return fmt::format("{} (line {})", place.what, line_of(place, document));
}

std::string explain_text(const SceneExplanation& e, const JsonValue& document) {
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "scene      {}\n", e.title.empty() ? "untitled" : printable(e.title));
  fmt::format_to(out, "particles  {} in {}-D", e.particles, e.dimension);
  for (const SceneExplanation::Count& s : e.species)
    fmt::format_to(out, ", {} {}", s.count, printable(s.name));
  fmt::format_to(out, "\npairs      {} of {} interact\n", e.interacting_pairs, e.all_pairs);
  for (const EffectCall& effect : e.effects) {
    if (effect.because.empty()) continue;
    fmt::format_to(out, "\n{}: {}\n", effect.name, effect.what);
    std::vector<std::string> places;
    for (const CallingPlace& place : effect.because) places.push_back(with_line(place, document));
    fmt::format_to(out, "  because  {}\n", printable(fmt::format("{}", fmt::join(places, ", "))));
    fmt::format_to(out, "  cost     {}\n", effect.cost);
  }
  fmt::format_to(out, "\nnot simulated (no state, no event):\n");
  for (const EffectCall& effect : e.effects) {
    std::string_view what = effect.called_by;
    if (what.starts_with("a ")) what.remove_prefix(2);
    if (effect.because.empty()) fmt::format_to(out, "  {}: the scene has no {}\n", effect.name, what);
  }
  return text;
}

std::string explain_json(const SceneExplanation& e, const JsonValue& document) {
  nlohmann::ordered_json result{{"title", e.title},
                                {"dimension", e.dimension},
                                {"particles", e.particles},
                                {"all_pairs", e.all_pairs},
                                {"interacting_pairs", e.interacting_pairs}};
  for (const SceneExplanation::Count& s : e.species) result["species"][s.name] = s.count;
  for (const EffectCall& effect : e.effects) {
    nlohmann::ordered_json because = nlohmann::ordered_json::array(), places = because;
    for (const CallingPlace& place : effect.because) {
      because.push_back(place.what);
      places.push_back({{"pointer", place.pointer}, {"line", line_of(place, document)}});
    }
    result["effects"].push_back({{"name", effect.name},
                                 {"simulated", !effect.because.empty()},
                                 {"what", effect.what},
                                 {"called_by", effect.called_by},
                                 {"because", because},
                                 {"places", places},
                                 {"cost", effect.cost}});
  }
  return json_text(result, 2) + "\n";
}

}  // namespace

void add_explain(CLI::App& app, int&) {
  struct Arguments {
    std::string scene;
    std::string format = "text";
  };
  const auto a = std::make_shared<Arguments>();
  CLI::App* verb =
      app.add_subcommand("explain", "Says which effects a scene calls for, why, which not, and their cost.");
  verb->add_option("scene", a->scene, "Scene file, - for standard input")->required();
  verb->add_option("--format", a->format)->check(CLI::IsMember({"text", "json"}))->capture_default_str();
  verb->footer("Example: tps explain data/scenes/terminal.json");
  verb->callback([a] {
    NamedFiles().reads("scene", a->scene).require_distinct();
    const SceneFile file = read_scene_with_places(a->scene);
    const SceneExplanation explanation = explain(file.scene);
    write_result("-", a->format == "json" ? explain_json(explanation, file.document)
                                          : explain_text(explanation, file.document));
  });
}

}  // namespace tps::cli

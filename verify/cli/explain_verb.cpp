// tps explain
#include <fmt/format.h>

#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

#include "reference/run/explain.hpp"
#include "reference/scene/read_scene.hpp"
#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"
#include "verify/cli/named_files.hpp"
#include "verify/cli/verbs.hpp"
#include "verify/cli/write_result.hpp"

namespace tps::cli {
namespace {

std::string explain_text(const SceneExplanation& e) {
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
    fmt::format_to(out, "  because  {}\n", printable(fmt::format("{}", fmt::join(effect.because, ", "))));
    fmt::format_to(out, "  cost     {}\n", effect.cost);
  }
  fmt::format_to(out, "\nnot simulated (no state, no event):\n");
  for (const EffectCall& effect : e.effects) {
    if (effect.because.empty())
      fmt::format_to(out, "  {}: the scene has no {}\n", effect.name, effect.called_by);
  }
  return text;
}

std::string explain_json(const SceneExplanation& e) {
  nlohmann::ordered_json result{{"title", e.title},
                                {"dimension", e.dimension},
                                {"particles", e.particles},
                                {"all_pairs", e.all_pairs},
                                {"interacting_pairs", e.interacting_pairs}};
  for (const SceneExplanation::Count& s : e.species) result["species"][s.name] = s.count;
  for (const EffectCall& effect : e.effects) {
    result["effects"].push_back({{"name", effect.name},
                                 {"simulated", !effect.because.empty()},
                                 {"what", effect.what},
                                 {"called_by", effect.called_by},
                                 {"because", effect.because},
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
    const SceneExplanation explanation = explain(read_scene_file(a->scene));
    write_result("-", a->format == "json" ? explain_json(explanation) : explain_text(explanation));
  });
}

}  // namespace tps::cli

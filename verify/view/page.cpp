#include "verify/view/page.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "reference/text/plain_json.hpp"
#include "reference/text/printable.hpp"
#include "verify/draw/palette.hpp"
#include "verify/view/base64.hpp"
#include "verify/view/columns.hpp"
#include "verify/view/safe_page.hpp"
#include "verify/view/viewer_files.hpp"

namespace tps::view {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLongestLabel = 500;  // of a title or a name: what no page shows

Json or_infinite(double x) {
  return std::isinf(x) ? Json("inf") : Json(x);
}

Json species_json(const Scene& scene) {
  Json list = Json::array();
  for (std::size_t n = 0; n < scene.species.size(); ++n) {
    const Species& s = scene.species[n];
    list.push_back({{"name", printable(s.name, kLongestLabel)},
                    {"mass", or_infinite(s.mass)},
                    {"radius", s.radius},
                    {"colour", hex(cyclic(kSpeciesColours, static_cast<int>(n)))}});
  }
  return list;
}

Json pairs_json(const Scene& scene) {
  Json list = Json::array();
  for (const PairLaw& law : scene.pairs) {
    Json pair{{"species", {law.species_a, law.species_b}}};
    if (law.blocking) pair["inner"] = law.blocking->distance;
    if (law.tethering) {
      pair["outer"] = law.tethering->distance;
      pair["permanent"] = law.tethering->form.when == FormRule::When::permanent;
    }
    list.push_back(pair);
  }
  return list;
}

Json walls_json(const Scene& scene) {
  static constexpr std::string_view kShapes[] = {"plane", "sphere", "box"};
  Json list = Json::array();
  for (const Wall& wall : scene.walls) {
    list.push_back({{"shape", kShapes[static_cast<int>(wall.shape)]},
                    {"point", wall.point},
                    {"normal", wall.normal},
                    {"high", wall.high},
                    {"radius", wall.radius},
                    {"velocity", wall.velocity}});
  }
  return list;
}

Json findings_json(const std::vector<ShownFinding>& findings) {
  Json list = Json::array();
  for (const auto& [finding, expected] : findings) {
    Json entry{{"rule", check::name(finding.rule)},
               {"outcome", finding.outcome == check::Outcome::violated ? "violated" : "undecided"},
               {"line", finding.line},
               {"event", finding.event},
               {"particles", finding.particles},
               {"message", printable(finding.message)},
               {"equation", finding.equation},
               {"reading", printable(finding.reading)}};
    if (finding.off) entry["off"] = or_infinite(*finding.off);
    if (finding.allowed) entry["allowed"] = or_infinite(*finding.allowed);
    for (const Expected& e : expected)
      entry["expected"].push_back({{"particle", e.particle}, {"of", e.of}, {"value", e.value}});
    list.push_back(entry);
  }
  return list;
}

Json description(const Playback& playback, const std::vector<ShownFinding>& findings) {
  const Scene& scene = playback.scene;
  Json notes = Json::array();
  for (const std::string& note : playback.notes) notes.push_back(printable(note));
  if (playback.one_of > 1) {
    notes.push_back(fmt::format(
        "of {} events one in {} is here, and those beside findings; between them particles are drawn on "
        "straight lines from one change to the next",
        playback.all_events, playback.one_of));
  }
  Json kinds = Json::array();
  for (const check::KindRow& kind : check::kinds()) kinds.push_back(kind.name);
  return {{"title", printable(scene.title, kLongestLabel)},
          {"dimension", scene.dimension},
          {"scalar", playback.scalar},
          {"timing", playback.timing},
          {"end", playback.end},
          {"t_end", playback.t_end},
          {"start_time", scene.start_time},
          {"one_of", playback.one_of},
          {"all_events", playback.all_events},
          {"notes", notes},
          {"kinds", kinds},
          {"species", species_json(scene)},
          {"pairs", pairs_json(scene)},
          {"walls", walls_json(scene)},
          {"findings", findings_json(findings)}};
}

}  // namespace

void require_viewer() {
  if (has_viewer()) return;
  throw std::runtime_error(
      "this program was built without three.js, which a page carries: install libjs-three (Debian) or give "
      "its "
      "three.min.js as -DTPS_THREE_JS=FILE, configure again (cmake --preset release) and build");
}

std::string page(const Playback& playback, const std::vector<ShownFinding>& findings) {
  std::string scripts, script_sources, styles, style_sources;
  for (const ViewerFile& file : viewer_files()) {
    const bool style = file.name.ends_with(".css");
    (style ? style_sources : script_sources) += source_hash(file.sha256);
    const std::string_view element = style ? "style" : "script";
    (style ? styles : scripts) += fmt::format("<{0}>{1}</{0}>\n", element, file.text);
  }
  Columns columns(playback);
  Json what = description(playback, findings);
  what["columns"] = columns.places();
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data: blob:; "
      "script-src{}; style-src{}; base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, "
      "initial-scale=1\">\n<title>{}</title>\n{}</head>\n"
      "<body>\n{}\n<script type=\"application/json\" id=\"what\">{}</script>\n"
      "<script type=\"application/octet-stream\" id=\"numbers\">{}</script>\n{}</body>\n</html>\n",
      script_sources, style_sources, xml_text(printable(playback.scene.title, kLongestLabel)), styles,
      viewer_markup(), embedded(what), base64(columns.bytes()), scripts);
}

}  // namespace tps::view

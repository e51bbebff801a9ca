#include "verify/view/findings.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "reference/text/json_document.hpp"
#include "reference/text/number_text.hpp"
#include "verify/protocol/answer.hpp"

namespace tps::view {
namespace {

Coordinates vector_of(const nlohmann::ordered_json& value) {
  Coordinates v{};
  std::size_t k = 0;
  for (const auto& component : value)
    v.at(k++) = parse_hex_float(component.get_ref<const std::string&>()).value;
  return v;
}

int index_of(const Scene& scene, std::int32_t id) {
  const auto place = std::lower_bound(scene.particles.begin(), scene.particles.end(), id,
                                      [](const Particle& p, std::int32_t i) { return p.id < i; });
  return place != scene.particles.end() && place->id == id ? static_cast<int>(place - scene.particles.begin())
                                                           : -1;
}

struct Answered {
  operations::Op op;
  std::string_view key, of;
};
/// Which number of which operation can be drawn: it belongs to the first particle of the finding, which asks
/// about it as A (rules/impulse.hpp).
constexpr Answered kDrawn[] = {{operations::Op::collision_impulse, "dp", "dp"},
                               {operations::Op::tether_response, "dp", "dp"},
                               {operations::Op::apply_impulse, "v_A", "velocity"},
                               {operations::Op::load, "v_load", "velocity"}};

std::vector<Expected> expected_of(const check::Finding& finding, const Scene& scene) {
  static const std::string source = "a finding";
  const int particle = finding.particles.empty() ? -1 : index_of(scene, finding.particles.front());
  std::vector<Expected> expected;
  for (const Answered& drawn : kDrawn) {
    if (finding.replay->op != drawn.op || particle < 0) continue;
    const JsonDocument in = parse_json(finding.replay->in, source);
    const nlohmann::ordered_json out = protocol::answer(drawn.op, in.root, {source, ""});
    if (out.contains(drawn.key))
      expected.push_back({particle, drawn.of, vector_of(out.at(std::string(drawn.key)))});
  }
  return expected;
}

}  // namespace

std::vector<ShownFinding> shown_findings(const check::CheckReport& report, const Scene& scene) {
  std::vector<ShownFinding> shown;
  for (const check::Finding& finding : report.findings) {
    if (shown.size() == kMostShown) break;
    shown.push_back({finding, {}});
    if (!finding.replay) continue;
    try {
      shown.back().expected = expected_of(finding, scene);
    } catch (const InputError&) {
      // Numbers of a wide scalar that no double holds: the text of the finding has them.
    }
  }
  return shown;
}

std::vector<std::uint64_t> lines_of(const check::CheckReport& report) {
  std::vector<std::uint64_t> lines;
  for (const check::Finding& finding : report.findings) {
    if (lines.size() == kMostShown) break;
    lines.push_back(finding.line);
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

}  // namespace tps::view

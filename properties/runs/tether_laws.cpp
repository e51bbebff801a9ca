// Tethers follow their rules: who may form one, what breaks it, and what is drawn for it.
#include <cmath>
#include <set>

#include "properties/runs/collision.hpp"
#include "properties/runs/laws.hpp"

namespace tps::properties::runs {
namespace {

bool has_room(const Scene& scene, const ImpliedState& implied, int i) {
  const auto& capacity =
      scene.species[static_cast<std::size_t>(scene.particles[static_cast<std::size_t>(i)].species)]
          .max_tethers;
  return !capacity || implied.tether_count(i) < *capacity;
}

/// Whether a rebound draws and forms a tether, by semantics §3.
std::optional<std::string> forms_wrongly(const Scene& scene, const ImpliedState& before,
                                         const TracedEvent& event) {
  const int i = before.index_of(*event.i), j = before.index_of(*event.j);
  const PairLaw* law = before.law(i, j);
  using When = FormRule::When;
  const FormRule rule = law != nullptr && law->tethering ? law->tethering->form : FormRule{When::never, 1};
  const bool possible = (rule.when == When::always || rule.when == When::probability) &&
                        !before.tethered(i, j) && has_room(scene, before, i) && has_room(scene, before, j);
  const bool draws = possible && rule.when == When::probability;
  if (draws != event.draw.has_value()) return draws ? "nothing was drawn" : "a number was drawn for nothing";
  const bool forms = possible && (!draws || *event.draw < Real(rule.probability));
  if (forms != (event.tether == "formed"))
    return forms ? "no tether forms, though the rule has it"
                 : "a tether forms against its rule or a capacity";
  return std::nullopt;
}

std::optional<std::string> breaks_wrongly(const ImpliedState& before, const TracedEvent& event, Real u) {
  const Collided c = collided(before, event);
  const PairLaw* law = before.law(c.i, c.j);
  if (law == nullptr || !law->tethering) return "a pull of a pair without tethering";
  if (!before.tethered(c.i, c.j)) return "a pull of a pair that is not tethered";
  using When = BreakRule::When;
  const BreakRule& rule = law->tethering->breaks;
  const bool broke = event.kind == "break";
  if (broke != (event.tether == "broken")) return "the event's kind and its tether disagree";
  if (event.draw.has_value() != (rule.when == When::probability))
    return "what was drawn is not what the rule draws";
  bool breaks = rule.when == When::always;
  if (rule.when == When::probability) breaks = *event.draw < Real(rule.probability);
  if (rule.when == When::impulse_above) {
    const Real impulse = event.dp ? event.dp->norm() : tether_impulse(before, c);
    const Real threshold = before.stored(rule.threshold);
    // |Δp| errs by what docs/ledger.md counts; near the boundary between (4) and (5) either may have been
    // meant.
    if (std::abs(impulse - threshold) <= 64 * u * c.mu * c.v_AB.norm()) return std::nullopt;
    if (broke && c.v_n <= 32 * u * c.v_AB.norm()) return std::nullopt;
    breaks = impulse > threshold;
  }
  if (breaks != broke) return broke ? "a tether breaks against its rule" : "a tether holds against its rule";
  return std::nullopt;
}

RunVerdict follows_rules(const Scene& scene, Simulator& simulator) {
  const Real u = simulator.roundoff();
  return RunVerdict::of(
      first_fault(scene, simulator,
                  [&](const ImpliedState& before, const TracedEvent& event) -> std::optional<std::string> {
                    if (event.kind == "rebound") return forms_wrongly(scene, before, event);
                    if (event.kind == "retract" || event.kind == "revolve" || event.kind == "break")
                      return breaks_wrongly(before, event, u);
                    return event.tether.empty() && !event.draw
                               ? std::nullopt
                               : std::optional<std::string>("a tether changes without a collision");
                  }));
}

/// Two draws agree by chance once in 2^53.
RunVerdict draws_anew(const Scene& scene, Simulator& simulator) {
  std::set<Real> drawn;
  return RunVerdict::of(first_fault(
      scene, simulator, [&](const ImpliedState&, const TracedEvent& event) -> std::optional<std::string> {
        if (!event.draw) return std::nullopt;
        if (*event.draw < 0 || *event.draw >= 1) return "a draw outside [0, 1)";
        return drawn.insert(*event.draw).second ? std::nullopt
                                                : std::optional<std::string>("a draw is used twice");
      }));
}

}  // namespace

std::vector<RunLaw> tether_laws() {
  Wanted ungrouped;
  ungrouped.grouping = Wanted::Choice::never;
  return {
      {9, "Tethers",
       "A tether forms at a rebound only and breaks at a pull only, by the rules in force, within "
       "capacities; a full particle draws nothing.",
       "docs/scene.md", of({}), follows_rules},
      {10, "Draws", "Every random number is used once.", "docs/decisions.md", of(ungrouped), draws_anew},
  };
}

}  // namespace tps::properties::runs

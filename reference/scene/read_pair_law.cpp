#include "reference/scene/read_pair_law.hpp"

#include <cmath>

#include "reference/scene/scene_values.hpp"

namespace tps {

FormRule read_form(const JsonValue& value) {
  if (value.object() != nullptr) return {FormRule::When::probability, number_at(value, "probability")};
  if (*value.string() == "never") return {FormRule::When::never, 1};
  if (*value.string() == "permanent") return {FormRule::When::permanent, 1};
  return {FormRule::When::always, 1};
}

BreakRule read_break(const JsonValue& value) {
  if (value.find("probability") != nullptr) {
    return {BreakRule::When::probability, number_at(value, "probability"), 0};
  }
  if (value.find("impulse_above") != nullptr) {
    return {BreakRule::When::impulse_above, 0, number_at(value, "impulse_above")};
  }
  return {*value.string() == "always" ? BreakRule::When::always : BreakRule::When::never, 0, 0};
}

PairLaw read_pair_law(const JsonValue& entry, const std::vector<Species>& species, std::pair<int, int> pair) {
  const auto radius = [&](int n) { return species[static_cast<std::size_t>(n)].radius; };
  const double r_a = radius(pair.first);
  const double r_b = radius(pair.second);
  PairLaw law;
  law.species_a = pair.first;
  law.species_b = pair.second;
  // One addition or subtraction of doubles is correctly rounded: the defaults that the format promises.
  if (const JsonValue* blocking = entry.find("blocking")) {
    law.blocking =
        BlockingLaw{number_or(*blocking, "distance", r_a + r_b), number_at(*blocking, "c_rebound")};
  }
  if (const JsonValue* tethering = entry.find("tethering")) {
    TetheringLaw outer;
    outer.c_retract = number_at(*tethering, "c_retract");
    outer.c_revolve = number_at(*tethering, "c_revolve");
    outer.theta_revolve_deg = number_at(*tethering, "theta_revolve_deg");
    if (const JsonValue* form = tethering->find("form")) outer.form = read_form(*form);
    if (const JsonValue* breaks = tethering->find("break")) outer.breaks = read_break(*breaks);
    outer.distance = number_or(*tethering, "distance", std::fabs(r_a - r_b));
    law.tethering = outer;
  }
  if (const JsonValue* friction = entry.find("friction"))
    law.friction = FrictionLaw{number_at(*friction, "mu"), number_at(*friction, "beta0")};
  return law;
}

}  // namespace tps

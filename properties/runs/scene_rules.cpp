#include "properties/runs/scene_rules.hpp"

#include "properties/runs/choices.hpp"

namespace tps::properties::runs {
namespace {

double thousandth() {
  return *rc::gen::inRange(0, 1001) / 1000.0;
}

}  // namespace

double coefficient_of(const Wanted& wanted) {
  if (!wanted.dissipation) return 1;
  const double edge = pick({1.0, 0.0, 0.5, 0.9, 0.05, 2.0});
  return edge == 2.0 ? thousandth() : edge;
}

FormRule form_rule(const Wanted& wanted) {
  using When = FormRule::When;
  if (!wanted.changing_tethers) return {When::never, 1};
  const When when =
      wanted.draws ? pick({When::never, When::always, When::probability}) : pick({When::never, When::always});
  return {when, when == When::probability ? thousandth() : 1};
}

BreakRule break_rule(const Wanted& wanted, double unit) {
  using When = BreakRule::When;
  BreakRule rule;
  if (!wanted.changing_tethers) return rule;
  rule.when = wanted.draws
                  ? pick({When::never, When::never, When::always, When::probability, When::impulse_above})
                  : pick({When::never, When::never, When::always, When::impulse_above});
  if (rule.when == When::probability) rule.probability = thousandth();
  if (rule.when == When::impulse_above) rule.threshold = unit * *rc::gen::inRange(0, 4);
  return rule;
}

TetheringLaw tethering_law(const Wanted& wanted, double distance, double unit) {
  TetheringLaw law;
  law.distance = distance;
  law.c_retract = coefficient_of(wanted);
  law.c_revolve = coefficient_of(wanted);
  law.theta_revolve_deg = wanted.dissipation ? pick({45.0, 30.0, 60.0, 1.0, 89.0, 1e-6, 89.999999}) : 1e-6;
  law.form = form_rule(wanted);
  law.breaks = break_rule(wanted, unit);
  return law;
}

}  // namespace tps::properties::runs

// Coefficients and tether rules of generated scenes.
#pragma once

#include "properties/runs/scenes.hpp"

namespace tps::properties::runs {

/// In [0, 1]: its ends, round numbers, 0.05 (which collapses), thousandths; 1 where nothing may be lost.
double coefficient_of(const Wanted& wanted);

FormRule form_rule(const Wanted& wanted);

/// Thresholds of the size that impulses have where masses and speeds are small whole numbers of `unit`.
BreakRule break_rule(const Wanted& wanted, double unit);

TetheringLaw tethering_law(const Wanted& wanted, double distance, double unit);

}  // namespace tps::properties::runs

// What one effect has done to the energy of a run, added up for the summary.
#pragma once

#include <string>
#include <string_view>

#include "reference/engine/ledger.hpp"
#include "reference/engine/range.hpp"

namespace tps {

/// A part of one of the ledger's sums: `work` and `heat` of its work from outside, `lost` of what collisions
/// lost (docs/ledger.md, "Effect by effect").
template <typename Scalar>
struct EnergyShare {
  std::string_view what;
  Sum<Scalar> sum;

  /// Throws OutOfRange.
  void add(const Scalar& energy, std::string_view effect) {
    sum += energy;
    if (!is_finite(sum.value())) throw OutOfRange("the " + std::string(what) + " of " + std::string(effect));
  }
};

}  // namespace tps

// The reference in one scalar as an implementation.
#pragma once

#include <memory>
#include <string>

#include "properties/implementation.hpp"
#include "reference/run/run.hpp"

namespace tps::properties {

/// Equations as `tps eval` computes them, groups by the engine's grouping.
std::unique_ptr<Implementation> equations_in(ScalarKind scalar);

}  // namespace tps::properties

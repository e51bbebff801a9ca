// The reference as an implementation, in process.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "properties/implementation.hpp"

namespace tps::properties {

/// float, double, long-double, quad, mp50, mp100: the equations in that scalar. `certified`: the answers of
/// `tps serve`, correctly rounded doubles.
std::vector<std::string> reference_names();

/// REQUIRES one of reference_names().
std::unique_ptr<Implementation> reference(const std::string& name);

}  // namespace tps::properties

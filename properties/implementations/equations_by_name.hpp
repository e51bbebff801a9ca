// One source for the scalars of the machine, one for those of Boost: each builds for itself.
#pragma once

#include <memory>
#include <string>

#include "properties/implementation.hpp"

namespace tps::properties {

std::unique_ptr<Implementation> equations_in_built_in(const std::string& name);
std::unique_ptr<Implementation> equations_in_wide(const std::string& name);

}  // namespace tps::properties

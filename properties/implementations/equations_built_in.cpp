#include "properties/implementations/equations.hpp"
#include "properties/implementations/equations_by_name.hpp"

namespace tps::properties {

std::unique_ptr<Implementation> equations_in_built_in(const std::string& name) {
  if (name == "float") return std::make_unique<EquationsIn<float>>(name);
  if (name == "long-double") return std::make_unique<EquationsIn<long double>>(name);
  return std::make_unique<EquationsIn<double>>(name);
}

}  // namespace tps::properties

#include "properties/implementations/equations.hpp"
#include "properties/implementations/equations_by_name.hpp"
#include "reference/scalars.hpp"

namespace tps::properties {

std::unique_ptr<Implementation> equations_in_wide(const std::string& name) {
  if (name == "quad") return std::make_unique<EquationsIn<Quad>>(name);
  if (name == "mp50") return std::make_unique<EquationsIn<Mp50>>(name);
  return std::make_unique<EquationsIn<Mp100>>(name);
}

}  // namespace tps::properties

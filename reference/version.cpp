#include "reference/version.hpp"

namespace tps {

std::string_view version() {
  return TPS_VERSION;
}

}  // namespace tps

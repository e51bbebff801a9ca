// Where a study was made: what its times are times of.
#pragma once

#include <string>

namespace tps::cost {

struct Machine {
  std::string processor, compiler, flags, version;
};

Machine this_machine();

}  // namespace tps::cost

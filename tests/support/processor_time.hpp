// Time as tests may compare it.
#pragma once

#include <ctime>

namespace tps {

/// Seconds of processor time of this process since some moment: what others do on the machine is not in it.
inline double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace tps

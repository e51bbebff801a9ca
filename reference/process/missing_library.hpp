// A library that is loaded when it is needed, and is not there.
#pragma once

#include <stdexcept>

namespace tps {

class MissingLibrary : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace tps

// What the program of the first build lacks.
#pragma once

#include <stdexcept>
#include <string>

namespace tps::cli {

/// Something that only the whole program can do. The message says how to build it.
class NotBuilt : public std::runtime_error {
 public:
  explicit NotBuilt(const std::string& what)
      : std::runtime_error(what +
                           " needs the whole program, and only what the first result needs has been built; "
                           "./run build builds the rest") {}
};

}  // namespace tps::cli

// What every law says about itself, whether it is one of single operations (law.hpp) or of whole runs
// (runs/).
#pragma once

#include <string>

namespace tps::properties {

/// A law in words.
struct LawText {
  std::string id;        ///< "Eq4Laws.Law2TheImpulseIsOppositeForTheOther"; the test's name, never reused
  std::string number;    ///< where it is numbered: "(4) law 2" is the second in the docstring of eq. (4)
  std::string sentence;  ///< what always holds
  std::string page;      ///< where it is explained: "docs/eq4.md"
};

}  // namespace tps::properties

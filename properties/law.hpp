// Laws of single operations: functions of an implementation and a case. docs/properties.md lists them.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "properties/case.hpp"
#include "properties/format.hpp"
#include "properties/implementation.hpp"
#include "properties/law_text.hpp"
#include "properties/outcome.hpp"

namespace rc {
template <typename T>
class Gen;
}

namespace tps::properties {

class Interview;

/// A law that any implementation can be asked about.
struct Law {
  LawText text;
  std::vector<Op> operations;                         ///< those that it asks
  std::function<rc::Gen<Case>(const Format&)> cases;  ///< generated with shrinking
  std::function<Outcome(Interview&, const Case&)> check;
  bool is_of_each = false;  ///< says the same of each operation: it is asked of those that are offered
};

constexpr bool kOfEach = true;

/// Whether what is offered suffices.
bool can_be_asked(const Law& law, const std::function<bool(Op)>& is_offered);

/// All of them, in the order of the paper.
const std::vector<Law>& laws();

/// Null for an unknown id.
const Law* find_law(std::string_view id);

/// Each source of laws/ adds its own.
namespace eq1 {
void add_laws(std::vector<Law>& laws);
}
namespace timing {
void add_laws(std::vector<Law>& laws);
}
namespace invariance {
void add_laws(std::vector<Law>& laws);
}
namespace order {
void add_laws(std::vector<Law>& laws);
}
namespace eq3 {
void add_laws(std::vector<Law>& laws);
}
namespace eq4 {
void add_laws(std::vector<Law>& laws);
}
namespace eq5 {
void add_laws(std::vector<Law>& laws);
}
namespace orbit {
void add_laws(std::vector<Law>& laws);
}
namespace tether_response {
void add_laws(std::vector<Law>& laws);
}
namespace eq6 {
void add_laws(std::vector<Law>& laws);
}
namespace eq7 {
void add_laws(std::vector<Law>& laws);
}
namespace group {
void add_laws(std::vector<Law>& laws);
}
namespace wall {
void add_laws(std::vector<Law>& laws);
}
namespace drag {
void add_laws(std::vector<Law>& laws);
}
namespace rough {
void add_laws(std::vector<Law>& laws);
}

}  // namespace tps::properties

#include "verify/protocol/catalogue.hpp"

#include <algorithm>

#include "verify/eval/operations.hpp"
#include "verify/protocol/compound.hpp"

namespace tps::protocol {

const std::vector<Entry>& catalogue() {
  static const std::vector<Entry> entries = [] {
    std::vector<Entry> all;
    for (const eval::Operation& o : eval::operations())
      all.push_back({o.name, o.part, o.page, o.is_certified});
    for (const Compound& c : compounds()) all.push_back({c.name, c.part, c.page, true});
    return all;
  }();
  return entries;
}

const Entry* find_entry(std::string_view name) {
  const auto& all = catalogue();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Entry& e) { return e.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace tps::protocol

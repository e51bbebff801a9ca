#include <algorithm>

#include <rapidcheck.h>

#include "properties/law.hpp"

namespace tps::properties {
namespace {

/// Within an equation by the law's number; equations as they were added.
void sort_by_number(std::vector<Law>& table) {
  const auto equation = [](const Law& law) {
    return law.text.number.substr(0, law.text.number.find(" law "));
  };
  const auto number = [](const Law& law) { return law.text.number.substr(law.text.number.rfind(' ')); };
  for (auto begin = table.begin(); begin != table.end();) {
    const auto end =
        std::find_if(begin, table.end(), [&](const Law& law) { return equation(law) != equation(*begin); });
    std::sort(begin, end, [&](const Law& one, const Law& other) { return number(one) < number(other); });
    begin = end;
  }
}

}  // namespace

const std::vector<Law>& laws() {
  static const std::vector<Law> table = [] {
    std::vector<Law> made;
    eq1::add_laws(made);
    invariance::add_laws(made);
    timing::add_laws(made);
    order::add_laws(made);
    eq3::add_laws(made);
    eq4::add_laws(made);
    eq5::add_laws(made);
    orbit::add_laws(made);
    tether_response::add_laws(made);
    eq6::add_laws(made);
    eq7::add_laws(made);
    group::add_laws(made);
    wall::add_laws(made);
    drag::add_laws(made);
    rough::add_laws(made);
    sort_by_number(made);
    return made;
  }();
  return table;
}

bool can_be_asked(const Law& law, const std::function<bool(Op)>& is_offered) {
  return law.is_of_each ? std::any_of(law.operations.begin(), law.operations.end(), is_offered)
                        : std::all_of(law.operations.begin(), law.operations.end(), is_offered);
}

const Law* find_law(std::string_view id) {
  const auto& table = laws();
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const Law& law) { return law.text.id == id; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace tps::properties

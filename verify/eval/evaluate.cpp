#include "verify/eval/evaluate.hpp"

#include <algorithm>
#include <array>

#include "reference/scalars.hpp"

namespace tps::eval {
namespace {

struct Precision {
  std::string_view name;
  Report (*evaluate)(const Operation&, const Input&, std::string_view, Detail);
};

constexpr std::array<Precision, 6> precisions{{{"float", evaluate_in<float>},
                                               {"double", evaluate_in<double>},
                                               {"long-double", evaluate_in<long double>},
                                               {"quad", evaluate_in<Quad>},
                                               {"mp50", evaluate_in<Mp50>},
                                               {"mp100", evaluate_in<Mp100>}}};

}  // namespace

std::vector<std::string> scalars() {
  std::vector<std::string> names;
  for (const Precision& p : precisions) names.emplace_back(p.name);
  return names;
}

Report evaluate(const Operation& operation, const Input& input, std::string_view scalar, Detail detail) {
  const auto* found = std::find_if(precisions.begin(), precisions.end(),
                                   [&](const Precision& p) { return p.name == scalar; });
  return found->evaluate(operation, input, scalar, detail);
}

}  // namespace tps::eval

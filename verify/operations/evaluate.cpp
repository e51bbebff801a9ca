#include "verify/operations/evaluate.hpp"

#include "reference/scalars.hpp"

namespace tps::operations {

Report evaluate(const Operation& operation, const Input& input, std::string_view scalar, Detail detail) {
  return AllScalars::with<Report>(scalar_kind(scalar).value(), [&]<typename Scalar>() {
    return evaluate_in<Scalar>(operation, input, scalar, detail);
  });
}

}  // namespace tps::operations

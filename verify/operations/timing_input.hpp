// A timing query as it was given: in two or three dimensions, as numbers by key.
#pragma once

#include <array>
#include <vector>

#include "verify/operations/catalogue.hpp"
#include "verify/operations/input.hpp"

namespace tps::operations {

/// A vector of the plane or of space; a planar one has z = 0.
inline std::array<double, 3> in_space(const std::vector<double>& x) {
  return {x[0], x[1], x.size() > 2 ? x[2] : 0.0};
}

struct TimingInput {
  TimingKind kind;
  Input numbers;  ///< of timing_of(kind)

  TimingQuery query() const {
    const auto vector = [this](const char* key) { return in_space(numbers.values.at(key)); };
    TimingQuery query{kind,          vector("u_A"), vector("u_B"),
                      vector("v_A"), vector("v_B"), numbers.values.at("L")[0]};
    if (kind == TimingKind::plane) query.normal = vector("normal");
    return query;
  }

  const Operation& operation() const { return operations::operation(timing_of(kind)); }
};

}  // namespace tps::operations

// A timing query as it was given: in two or three dimensions, as numbers by key.
#pragma once

#include <vector>

#include "verify/eval/input.hpp"
#include "verify/exact/timing_query.hpp"

namespace tps::certified {

/// A vector of the plane or of space; a planar one has z = 0.
inline exact::Vec3 in_space(const std::vector<double>& x) {
  return {x[0], x[1], x.size() > 2 ? x[2] : 0.0};
}

struct TimingInput {
  exact::Kind kind;
  eval::Input numbers;  ///< of block_time or tether_time

  exact::TimingQuery query() const {
    const auto vector = [this](const char* key) { return in_space(numbers.values.at(key)); };
    return {kind, vector("u_A"), vector("u_B"), vector("v_A"), vector("v_B"), numbers.values.at("L")[0]};
  }

  const eval::Operation& operation() const {
    return *eval::find_operation(kind == exact::Kind::block ? "block_time" : "tether_time");
  }
};

}  // namespace tps::certified

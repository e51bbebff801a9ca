// A timing query as it was given: in two or three dimensions, as numbers by key.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "verify/eval/input.hpp"
#include "verify/exact/timing_query.hpp"

namespace tps::certified {

/// A vector of the plane or of space; a planar one has z = 0.
inline exact::Vec3 in_space(const std::vector<double>& x) {
  return {x[0], x[1], x.size() > 2 ? x[2] : 0.0};
}

/// The operation that asks a kind of timing query.
constexpr std::string_view operation_of(exact::Kind kind) {
  return kind == exact::Kind::block    ? "block_time"
         : kind == exact::Kind::tether ? "tether_time"
                                       : "wall_time";
}

/// The kind of timing query that an operation asks; none for the others, drag_time among them.
constexpr std::optional<exact::Kind> timing_kind(std::string_view operation) {
  for (const exact::Kind kind : {exact::Kind::block, exact::Kind::tether, exact::Kind::plane}) {
    if (operation == operation_of(kind)) return kind;
  }
  return std::nullopt;
}

struct TimingInput {
  exact::Kind kind;
  eval::Input numbers;  ///< of operation_of(kind)

  exact::TimingQuery query() const {
    const auto vector = [this](const char* key) { return in_space(numbers.values.at(key)); };
    exact::TimingQuery query{kind,          vector("u_A"), vector("u_B"),
                             vector("v_A"), vector("v_B"), numbers.values.at("L")[0]};
    if (kind == exact::Kind::plane) query.normal = vector("normal");
    return query;
  }

  const eval::Operation& operation() const { return *eval::find_operation(operation_of(kind)); }
};

}  // namespace tps::certified

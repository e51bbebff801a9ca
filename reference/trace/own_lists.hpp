// The two long lists of a full state, read in one pass where they are spelt as write_state spells them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/engine/state_data.hpp"

namespace tps {

/// A full state with its particles and the pairs that have responded taken out.
struct StateWithoutLists {
  std::vector<StateData::Particle> particles;
  std::vector<StateData::Responded> responded;
  std::string rest;  ///< the line with both lists empty
};

/// Nothing where either is spelt otherwise, or has something in it that a state cannot have: the reader of
/// all JSON says what. Law: what is taken out is what that reader reads.
std::optional<StateWithoutLists> without_own_lists(std::string_view line);

}  // namespace tps

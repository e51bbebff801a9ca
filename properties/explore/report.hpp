// What an exploration says.
#pragma once

#include <string>

#include "properties/explore/explore.hpp"

namespace tps::properties {

/// The laws: number, id, operations, sentence and page of each.
std::string list_text(const std::vector<const Law*>& laws);
std::string list_json(const std::vector<const Law*>& laws);

/// A finding for people: the law and its page, the shrunk case, each question as a command of ours.
std::string finding_text(const Finding& finding, const Plan& plan);

std::string exploration_text(const Exploration& exploration);
std::string exploration_json(const Exploration& exploration);

/// What became of cases that were kept.
struct Replayed {
  std::string subject;
  std::size_t held = 0, not_asked = 0;
  std::vector<Finding> findings;
};
std::string replay_text(const Replayed& replay);
std::string replay_json(const Replayed& replay);

/// `tps eval …` for a question; what has parts of its own (group, order, a scene) goes by --in.
std::string command_of(const Question& question);

}  // namespace tps::properties

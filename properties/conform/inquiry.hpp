// The inquiry: everything that is asked of an implementation, in order, with what it may cost.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "properties/conform/verdict.hpp"

namespace tps::properties::conform {

struct Plan {
  int level = 2;                  ///< known answers: 1 ten a stratum, 2 those of data/vectors
  std::uint64_t law_cases = 100;  ///< of each law
  std::uint64_t seed = 20260101;  ///< of the laws' cases
  std::vector<std::string> ops;   ///< only these; all where empty
  std::vector<std::string>
      strata;  ///< patterns of "op.stratum"; all where empty. With them no laws are asked
  std::vector<std::string> features;            ///< of scenes (random_scene.hpp)
  std::uint64_t scenes = 100, first_scene = 0;  ///< whole runs: so many, from this number on
  double shrink_seconds = 2;                    ///< for all laws together
  std::string command = {};  ///< that starts the subject, for a shell; empty where it is no command
  std::function<bool()> stops = [] { return false; };
  std::function<void(const std::string& doing)> progress = [](const std::string&) {};

  /// What shows the right answer to a question, and what asks the subject again.
  std::vector<std::string> commands_of(const Question& question) const;
};

/// Known answers and laws of everything that the subject offers. Adds to the verdict's rows, failures and
/// notes; sets its environment.
void ask_known_answers(Implementation& subject, const Plan& plan, Verdict& verdict);
void ask_laws(Implementation& subject, const Plan& plan, Verdict& verdict);

/// Whether a name is in a list.
bool has(const std::vector<std::string>& list, const std::string& name);

/// Whether the subject has said that it answers an operation; of one that has not said what it answers,
/// whether it has refused none of its questions so far.
bool is_offered(const Implementation& subject, const Verdict& verdict, Op op);

/// A row of the table for one hazard of an operation, "block_time.graze".
Row row_of(Op op, const std::string& hazard);

/// Whether a list of patterns has one that fits the name; all are wanted where it is empty.
bool wanted(const std::vector<std::string>& list, const std::string& name);

}  // namespace tps::properties::conform

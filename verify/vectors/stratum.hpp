// Families of questions: one known-answer file each.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "verify/vectors/known_answer.hpp"
#include "verify/vectors/random.hpp"

namespace tps::vectors {

/// What is asked, before it is answered.
struct Problem {
  Json in;
  std::vector<std::string> tags = {};  ///< hazards
};

/// One file: cases number 0, 1, 2, … of one operation that aim at one thing.
struct Stratum {
  Op op;
  std::string name;
  std::string why;
  int committed;  ///< cases of levels 1 and 2, those in data/vectors
  std::function<Problem(Random&, std::uint64_t number)> problem;
  int together = 1;  ///< so many neighbouring cases come from one stream (twins: 2)

  /// "block_time.graze".
  std::string full_name() const { return std::string(operations::name(op)) + "." + name; }
  std::string file_name() const { return full_name() + ".jsonl"; }
};

/// Strata in space go on in the plane for so many cases, then in space again.
constexpr int kInThePlane = 6;

inline int dimension_of_case(std::uint64_t number, int in_space) {
  return number % static_cast<std::uint64_t>(in_space + kInThePlane) < static_cast<std::uint64_t>(in_space)
             ? 3
             : 2;
}

/// Every stratum, in the order of the files' listing. Append; a change of a case is a new `rev`.
const std::vector<Stratum>& strata();

void add_timing_strata(std::vector<Stratum>& strata);
void add_order_strata(std::vector<Stratum>& strata);
void add_response_strata(std::vector<Stratum>& strata);
void add_group_strata(std::vector<Stratum>& strata);
void add_next_event_strata(std::vector<Stratum>& strata);
void add_wall_strata(std::vector<Stratum>& strata);
void add_drag_strata(std::vector<Stratum>& strata);
void add_rough_strata(std::vector<Stratum>& strata);

}  // namespace tps::vectors

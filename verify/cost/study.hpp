// What the study measures, as numbers; study_json.cpp says how they are written.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "verify/cost/statistics.hpp"

namespace tps::cost {

/// Errors of times as log2 |t̂ − t| / t, over the questions where variant and exact answer both have a time
/// t > 0 in the range of a double.
struct Errors {
  std::uint64_t compared = 0;
  double p50 = 0, p99 = 0,
         max = 0;  ///< meaningful for compared > 0; max is a lower bound of what is possible
};

/// Wrong answers by what became of the event.
struct WrongVerdicts {
  std::uint64_t asked = 0;
  std::uint64_t missed = 0;    ///< an event, and the variant says none
  std::uint64_t invented = 0;  ///< none, and the variant has one
  std::uint64_t moved =
      0;  ///< an event in both, but another: at once, at the limit, at the turning; or at infinity

  std::uint64_t all() const { return missed + invented + moved; }
};

/// Nanoseconds a question of this thread's CPU time, over the repetitions.
struct Times {
  Quantiles throughput, latency;
  double ratio = 1;         ///< of the median throughput to the baseline's
  Interval ratio_interval;  ///< 95 %, bootstrap
};

/// How far a filtered variant's questions went, and what each path costs.
struct Path {
  std::string name;  ///< first, double-words, integers
  std::uint64_t questions = 0;
  double ns = 0;  ///< the median; 0 without questions
};

/// A variant on a stratum.
struct Cell {
  std::string variant, stratum;
  WrongVerdicts verdicts;
  Errors errors;
  std::optional<Times> times;
  std::vector<Path> paths;
};

/// What a curve has between 2^exponent and 2^(exponent + 1).
struct Bin {
  std::string variant;
  int exponent = 0;
  WrongVerdicts verdicts;  ///< of a curve over the distance from tangency
  Errors errors;           ///< of a curve over the condition number
};

struct StudyOptions {
  std::uint64_t seed = 1;
  int questions = 2000;  ///< a stratum, for verdicts and errors
  int timed = 256;       ///< a stratum, for times
  int repetitions = 9;
};

/// One stratum measured in full.
struct StratumResult {
  std::string stratum, what;
  std::vector<Cell> cells;
  std::vector<Bin> by_tangency;   ///< of the questions whose verdict rests on D
  std::vector<Bin> by_condition;  ///< of the questions with a condition number and a right verdict
};

}  // namespace tps::cost

// A known answer as words that must be met and numbers that may be missed by so much; and an answer beside
// it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "properties/conform/known_question.hpp"

namespace tps::properties::conform {

/// Enclosures of one result: `cond` of docs/vectors.md is that of the whole of it.
struct ExpectedNumbers {
  struct End {
    double lo, hi, nearest;
  };
  std::string key;
  std::vector<End> ends;  ///< components, flattened
  std::optional<double> cond;
};

struct ExpectedWord {
  std::string key;
  Json word;  ///< a verdict, a kind, an order; an id
};

/// One accepted answer.
struct Expected {
  std::vector<ExpectedWord> words;
  std::vector<ExpectedNumbers> numbers;
  bool is_timing = false;  ///< a verdict, and "t" as one number or null
  bool occurs = true;      ///< of a timing query: whether there is a time
};

/// The answer of a case, and others that it accepts ("also"), the former first.
std::vector<Expected> expected_of(const KnownQuestion& known);

/// The numbers of a result, flattened: JSON numbers, hexadecimal floats of any length (rounded to the nearest
/// double), "inf", "-inf". Nothing where one is no number, nan included.
std::optional<std::vector<double>> numbers_of(const Json& value);

/// How an answer compares.
struct Comparison {
  bool words = true;     ///< as expected
  bool nearest = true;   ///< every number is the correctly rounded one of the format
  bool within = true;    ///< every result is within K(k) of docs/vectors.md, in the format's unit
  bool numbers = true;   ///< every result is there and consists of numbers
  bool occurs = true;    ///< a timing query has an event where it should, and none where it should not
  double units = 0;      ///< the largest error of a result, in units 2^-bits of its size
  double cond = 0;       ///< of that result
  std::string problem;   ///< the first thing that is not as expected, in words
  bool is_minor = true;  ///< it is a number within K(k)
};

/// REQUIRES an object. `k` is the factor of the class K(k) that the case accepts.
Comparison compare(const Expected& expected, const Question& question, Json out, const Format& format,
                   double k);

/// The factor of the widest class that a case accepts: 8 of K(8), 0 of R.
double accepted_factor(const Json& accept);

}  // namespace tps::properties::conform

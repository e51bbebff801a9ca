// What an evaluation shows: every intermediate value by its name in the paper, then the results.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tps::operations {

/// How much of an evaluation a report has.
enum class Detail {
  everything,
  bare_results,  ///< no steps, and numbers in hexadecimal only
};

/// A number in both spellings, independent of the scalar it was computed in.
struct Number {
  std::string decimal;  ///< enough digits to read it back
  std::string hex;      ///< exact
};

/// A named value: one number, the components of a vector, a word, or nothing (an absent time).
struct Quantity {
  std::string key;     ///< in JSON
  std::string symbol;  ///< as in the paper
  std::string formula;
  std::vector<Number> numbers;
  bool is_vector = false;
  std::string word;
};

struct Report {
  std::vector<Quantity> steps, results;
};

/// For people, under a heading; and as the JSON of `tps eval`.
std::string report_text(std::string_view heading, const Report& report);
std::string report_json(std::string_view operation, std::string_view scalar, const Report& report);

}  // namespace tps::operations

// Operations whose input is more than a list of numbers, as `tps eval` has them: order, group, next_event and
// simulate.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "verify/eval/report.hpp"
#include "verify/protocol/read_input.hpp"

namespace tps::protocol {

/// Not evaluated in a chosen scalar: `precision` says how.
struct Compound {
  std::string_view name;
  std::string_view what;
  std::string_view input;  ///< the shape of the object, for people
  std::string_view precision;
  std::string_view part;  ///< of the system: "order", "grouping", "engine", "whole runs"
  std::string_view page;  ///< of docs/
};

const std::vector<Compound>& compounds();

/// Null for any other name.
const Compound* find_compound(std::string_view name);

/// The result, as the text of a JSON object, on the content of a file: the object "in", or a whole request
/// that has it; "-" is standard input. Throws InputError.
std::string answer_file(const Compound& operation, const std::string& path);
/// The same as report_of() has it.
eval::Report report_file(const Compound& operation, const std::string& path);

/// The input of an order from such a file. Throws InputError.
OrderInput read_order_file(const std::string& path);

/// A result as a report for people: a line for each number, vector and word in it.
eval::Report report_of(const nlohmann::ordered_json& out);

}  // namespace tps::protocol

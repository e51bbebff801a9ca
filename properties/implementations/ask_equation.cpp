#include "properties/implementations/ask_equation.hpp"

#include <string>
#include <vector>

#include "verify/operations/domain.hpp"
#include "verify/operations/evaluate.hpp"
#include "verify/operations/no_answer.hpp"

namespace tps::properties {
namespace {

operations::Input input_of(const Json& in) {
  operations::Input input;
  for (const auto& [key, value] : in.items()) {
    std::vector<double>& numbers = input.values[key];
    if (!value.is_array()) {
      numbers = {number_of(value)};
      continue;
    }
    for (const Json& component : value) numbers.push_back(number_of(component));
    if (operations::domain_of(key) == operations::Domain::vector)
      input.dimension = static_cast<int>(numbers.size());
  }
  return input;
}

Json json_of(const operations::Quantity& quantity) {
  if (!quantity.word.empty()) return quantity.word;
  if (!quantity.is_vector) return quantity.numbers.at(0).hex;
  Json list = Json::array();
  for (const operations::Number& number : quantity.numbers) list.push_back(number.hex);
  return list;
}

}  // namespace

Answer ask_equation(const Question& question, std::string_view scalar) {
  const operations::Operation& operation = operations::operation(question.op);
  if (!operations::is_of_numbers(operation) || question.op == Op::paper_time)
    return {Answer::Status::skipped, {}, "not among the equations"};
  try {
    const operations::Report report =
        operations::evaluate(operation, input_of(question.in), scalar, operations::Detail::bare_results);
    Json out = Json::object();
    for (const operations::Quantity& quantity : report.results) {
      if (quantity.word.empty() && quantity.numbers.empty()) continue;  // no time
      out[quantity.key] = json_of(quantity);
    }
    if (out.value("t", "") == "inf") return {Answer::Status::refused, {}, "beyond the range of the scalar"};
    return {Answer::Status::answered, std::move(out)};
  } catch (const operations::NoAnswer& why) {
    return {Answer::Status::refused, {}, why.what()};
  }
}

}  // namespace tps::properties

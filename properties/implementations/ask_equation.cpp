#include "properties/implementations/ask_equation.hpp"

#include <string>
#include <vector>

#include "verify/eval/evaluate.hpp"
#include "verify/eval/no_answer.hpp"

namespace tps::properties {
namespace {

eval::Input input_of(const Json& in) {
  eval::Input input;
  for (const auto& [key, value] : in.items()) {
    std::vector<double>& numbers = input.values[key];
    if (!value.is_array()) {
      numbers = {number_of(value)};
      continue;
    }
    for (const Json& component : value) numbers.push_back(number_of(component));
    if (eval::domain_of(key) == eval::Domain::vector) input.dimension = static_cast<int>(numbers.size());
  }
  return input;
}

Json json_of(const eval::Quantity& quantity) {
  if (!quantity.word.empty()) return quantity.word;
  if (!quantity.is_vector) return quantity.numbers.at(0).hex;
  Json list = Json::array();
  for (const eval::Number& number : quantity.numbers) list.push_back(number.hex);
  return list;
}

}  // namespace

Answer ask_equation(const Question& question, std::string_view scalar) {
  const eval::Operation* operation = eval::find_operation(question.op);
  if (operation == nullptr || operation->op == eval::Op::paper_time)
    return {Answer::Status::skipped, {}, "not among the equations"};
  try {
    const eval::Report report =
        eval::evaluate(*operation, input_of(question.in), scalar, eval::Detail::bare_results);
    Json out = Json::object();
    for (const eval::Quantity& quantity : report.results) {
      if (quantity.word.empty() && quantity.numbers.empty()) continue;  // no time
      out[quantity.key] = json_of(quantity);
    }
    if (out.value("t", "") == "inf") return {Answer::Status::refused, {}, "beyond the range of the scalar"};
    return {Answer::Status::answered, std::move(out)};
  } catch (const eval::NoAnswer& why) {
    return {Answer::Status::refused, {}, why.what()};
  }
}

}  // namespace tps::properties

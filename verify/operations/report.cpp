#include "verify/operations/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "reference/text/plain_json.hpp"

namespace tps::operations {
namespace {

std::string spelled(const Quantity& q, std::string Number::*spelling) {
  if (!q.word.empty()) return q.word;
  if (q.numbers.empty()) return "none";
  if (!q.is_vector) return q.numbers[0].*spelling;
  std::string text;
  for (const Number& n : q.numbers) text += (text.empty() ? "(" : ", ") + n.*spelling;
  return text + ")";
}

/// Characters on a line, of UTF-8 without combining marks.
std::size_t width(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t columns) {
  return text + std::string(columns - std::min(columns, width(text)), ' ');
}

nlohmann::ordered_json to_json(const std::vector<Quantity>& quantities) {
  auto object = nlohmann::ordered_json::object();
  for (const Quantity& q : quantities) {
    if (!q.word.empty()) {
      object[q.key] = q.word;
    } else if (q.is_vector) {
      for (const Number& n : q.numbers) object[q.key].push_back(n.hex);
    } else {
      object[q.key] = q.numbers.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(q.numbers[0].hex);
    }
  }
  return object;
}

}  // namespace

std::string report_text(std::string_view heading, const Report& report) {
  const auto head = [](const Quantity& q) {
    return q.formula.empty() ? q.symbol : fmt::format("{} = {}", q.symbol, q.formula);
  };
  std::size_t heads = 0;
  std::size_t decimals = 0;
  for (const auto* part : {&report.steps, &report.results}) {
    for (const Quantity& q : *part) {
      heads = std::max(heads, width(head(q)));
      decimals = std::max(decimals, width(spelled(q, &Number::decimal)));
    }
  }
  std::string text = fmt::format("{}\n", heading);
  const auto add = [&](const Quantity& q, std::string_view mark) {
    const std::string decimal = spelled(q, &Number::decimal);
    text += fmt::format("{}{} = ", mark, padded(head(q), heads));
    text += q.numbers.empty() ? decimal : padded(decimal, decimals) + "  " + spelled(q, &Number::hex);
    text += "\n";
  };
  for (const Quantity& q : report.steps) add(q, "  ");
  for (const Quantity& q : report.results) add(q, "> ");
  return text;
}

std::string report_json(std::string_view operation, std::string_view scalar, const Report& report) {
  const nlohmann::ordered_json document{{"op", operation},
                                        {"scalar", scalar},
                                        {"steps", to_json(report.steps)},
                                        {"out", to_json(report.results)}};
  return json_text(document) + "\n";
}

}  // namespace tps::operations

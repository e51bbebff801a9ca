#include "properties/cost/foreign_variant.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <optional>

#include "properties/implementations/program.hpp"
#include "reference/text/plain_json.hpp"
#include "verify/vectors/known_answer.hpp"

namespace tps::properties {
namespace {

using cost::TimingQuery;

Question question_of(const TimingQuery& query) {
  return {query.kind == exact::Kind::block ? "block_time" : "tether_time", vectors::timing_input(query, 3)};
}

std::optional<TimingVerdict> verdict_named(const std::string& word) {
  for (int k = 0; k <= static_cast<int>(TimingVerdict::turning); ++k) {
    const auto verdict = static_cast<TimingVerdict>(k);
    if (name(verdict) == word) return verdict;
  }
  return std::nullopt;
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const char lower = static_cast<char>(c | 0x20);
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

[[noreturn]] void refuse(const Json& number) {
  throw ProgramError("t is " + json_text(number) +
                     "; allowed is a finite number: JSON's, or a hexadecimal float in a string");
}

/// "0x1.8p+1": parts of thirteen digits, the first in [0, 1).
cost::ExactNumber hexadecimal(const Json& number, const std::string& text) {
  constexpr std::size_t kDigits = 13;  // 52 bits: exact in a double
  cost::ExactNumber result;
  std::size_t count = 0, before_point = 0, at = 2;
  bool point = false;
  for (; at < text.size(); ++at) {
    if (text[at] == '.' && !point) {
      point = true;
      continue;
    }
    const int digit = hex_digit(text[at]);
    if (digit < 0) break;
    if (!point) ++before_point;
    if (count / kDigits < result.parts.size()) {
      result.parts[count / kDigits] += std::ldexp(digit, -4 * static_cast<int>(count + 1));
    }
    ++count;
  }
  if (count == 0) refuse(number);
  constexpr long kMostPower = 1L << 24;  // far beyond every format
  const char* const rest = text.c_str() + at;
  long power = 0;
  if (*rest == 'p' || *rest == 'P') {
    char* end = nullptr;
    power = std::strtol(rest + 1, &end, 10);
    if (end == rest + 1 || *end != '\0' || std::labs(power) > kMostPower) refuse(number);
  } else if (*rest != '\0') {
    refuse(number);
  }
  result.exponent = static_cast<int>(power) + 4 * static_cast<int>(before_point);
  return result;
}

}  // namespace

cost::ExactNumber exact_number_of(const Json& number) {
  if (number.is_string()) {
    const std::string text = number.get<std::string>();
    if (!text.starts_with("0x") && !text.starts_with("0X")) refuse(number);
    return hexadecimal(number, text);
  }
  if (!number.is_number()) refuse(number);
  cost::ExactNumber result;
  result.parts[0] = std::frexp(number.get<double>(), &result.exponent);
  return result;
}

cost::Answer answer_of(const Answer& reply) {
  if (reply.status == Answer::Status::refused) return {};
  if (reply.status != Answer::Status::answered) throw ProgramError(reply.reason);
  const auto verdict = reply.out.find("verdict");
  const auto t = reply.out.find("t");
  if (t == reply.out.end()) throw ProgramError("the reply has no t: " + json_text(reply.out));
  cost::Answer answer;
  answer.occurs = !t->is_null();
  if (verdict != reply.out.end() && verdict->is_string())
    answer.verdict = verdict_named(verdict->get<std::string>());
  if (!answer.occurs) return answer;
  if (*t == "inf") return answer;  // an event at infinity has no number
  const cost::ExactNumber number = exact_number_of(*t);
  answer.at_once =
      std::all_of(number.parts.begin(), number.parts.end(), [](double part) { return part == 0; });
  if (!answer.at_once) answer.t = number;
  return answer;
}

cost::Variant foreign_variant(const std::vector<std::string>& words) {
  const std::shared_ptr<Implementation> program = command(words, {});
  const auto offered = program->offered();
  for (const char* op : {"block_time", "tether_time"}) {
    if (offered && std::find(offered->begin(), offered->end(), op) == offered->end()) {
      throw ProgramError(program->name() + " does not offer " + op +
                         ", which a study of timing queries needs");
    }
  }
  cost::Variant variant;
  variant.name = variant.formula = kForeignName;
  variant.what = fmt::format("your program: {}", fmt::join(words, " "));
  variant.arithmetic = cost::kForeignArithmetic;
  variant.bits = program->format().bits;
  variant.has_time = true;
  variant.elsewhere = true;
  variant.answer = [program](const TimingQuery& query) {
    return answer_of(program->ask(question_of(query)));
  };
  variant.throughput = [program](std::span<const TimingQuery> queries) {
    std::vector<Question> questions;
    for (const TimingQuery& query : queries) questions.push_back(question_of(query));
    for (const Answer& reply : program->ask_all(questions)) answer_of(reply);
  };
  variant.latency = [program](std::span<const TimingQuery> queries) {
    for (const TimingQuery& query : queries) answer_of(program->ask(question_of(query)));
  };
  return variant;
}

}  // namespace tps::properties

#include "properties/cost/foreign_variant.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string_view>

#include "properties/implementations/program.hpp"
#include "reference/text/hexfloat.hpp"
#include "reference/text/plain_json.hpp"
#include "verify/vectors/known_answer.hpp"

namespace tps::properties {
namespace {

using cost::TimingQuery;

Question question_of(const TimingQuery& query) {
  return {operations::timing_of(query.kind), vectors::timing_input(query, 3)};
}

std::optional<TimingVerdict> verdict_named(const std::string& word) {
  for (int k = 0; k <= static_cast<int>(TimingVerdict::turning); ++k) {
    const auto verdict = static_cast<TimingVerdict>(k);
    if (name(verdict) == word) return verdict;
  }
  return std::nullopt;
}

[[noreturn]] void refuse(const Json& number) {
  throw ProgramError("t is " + json_text(number) +
                     "; allowed is a finite number: JSON's, or a hexadecimal float in a string");
}

/// Parts of thirteen digits, the first in (−1, 1).
cost::ExactNumber exact_number_of(const Json& number, const HexSpelling& spelling) {
  constexpr std::size_t kDigits = 13;           // 52 bits: exact in a double
  constexpr std::int64_t kMostPower = 1 << 24;  // far beyond every format
  if (std::abs(spelling.exponent) > kMostPower) refuse(number);
  cost::ExactNumber result;
  std::size_t count = 0;
  for (const std::string_view digits : {spelling.whole, spelling.fraction}) {
    for (const char c : digits) {
      if (count / kDigits == result.parts.size()) break;
      const double part = std::ldexp(hex_digit(c), -4 * static_cast<int>(++count));
      result.parts[(count - 1) / kDigits] += spelling.negative ? -part : part;
    }
  }
  result.exponent = static_cast<int>(spelling.exponent) + 4 * static_cast<int>(spelling.whole.size());
  return result;
}

}  // namespace

cost::ExactNumber exact_number_of(const Json& number) {
  if (number.is_string()) {
    const std::string& text = number.get_ref<const std::string&>();
    const std::optional<HexSpelling> spelling = hex_spelling(text);
    if (!spelling) refuse(number);
    return exact_number_of(number, *spelling);
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
  for (const Op op : {Op::block_time, Op::tether_time}) {
    if (program->may_offer(op)) continue;
    throw ProgramError(program->name() + " does not offer " + std::string(operations::name(op)) +
                       ", which a study of timing queries needs");
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

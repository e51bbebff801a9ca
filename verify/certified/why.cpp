#include "verify/certified/why.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <optional>

#include "reference/text/hexfloat.hpp"
#include "verify/exact/double_filter.hpp"
#include "verify/exact/double_word_filter.hpp"
#include "verify/exact/double_word_values.hpp"
#include "verify/exact/exact_verdict.hpp"
#include "verify/exact/lifted_query.hpp"
#include "verify/exact/rounded_time.hpp"
#include "verify/exact/time_order.hpp"
#include "verify/operations/evaluate.hpp"
#include "verify/operations/no_answer.hpp"

namespace tps::certified {
namespace {

using operations::Quantity;
using operations::Report;

Quantity word(const std::string& key, const std::string& symbol, std::string_view value) {
  return {key, symbol, "", {}, false, std::string(value)};
}

Quantity number(const std::string& key, const std::string& symbol, const std::string& formula, double x) {
  return {key, symbol, formula, {{fmt::format("{}", x), to_hex(x)}}, false, ""};
}

Quantity time(const std::string& key, const std::string& symbol, const std::optional<double>& t) {
  if (t) return number(key, symbol, "", *t);
  return {key, symbol, "", {}, false, ""};
}

constexpr const char* kBeyond = "beyond its range";

/// What double arithmetic says, by the reference's own equations; kBeyond where they have no answer in
/// double.
struct Computed {
  std::string verdict;
  std::optional<double> t;
};

Computed computed(const operations::TimingInput& input) {
  Computed result;
  try {
    for (const Quantity& q : operations::evaluate(input.operation(), input.numbers, "double").results) {
      if (q.key == "verdict") result.verdict = q.word;
      if (q.key == "t" && !q.numbers.empty()) result.t = from_hex<double>(q.numbers[0].hex);
    }
  } catch (const operations::NoAnswer&) {
    result.verdict = kBeyond;
  }
  return result;
}

/// `words`: of a stage that knows more than doubles hold, what is to be added to them.
void add_stage(Report& report, const std::string& prefix, const std::string& stage, const std::string& title,
               const exact::Coefficients& q,
               const std::optional<exact::DoubleWordValues>& words = std::nullopt) {
  const std::string key = prefix + stage;
  if (!q.in_range) {
    report.steps.push_back(word(key, prefix + title, "out of range"));
    return;
  }
  const auto add = [&](const char* name, const char* formula, double x,
                       exact::DoubleWord exact::DoubleWordValues::*member, double bound) {
    report.steps.push_back(
        number(fmt::format("{}_{}", key, name), fmt::format("{}{} in {}", prefix, name, title), formula, x));
    if (words) {
      report.steps.push_back(number(fmt::format("{}_{}_lower", key, name),
                                    fmt::format("{}{} in {}, and added to it", prefix, name, title), "",
                                    ((*words).*member).lo));
    }
    report.steps.push_back(number(fmt::format("{}_{}_bound", key, name),
                                  fmt::format("{}{} in {}, at most off by", prefix, name, title), "", bound));
  };
  add("a", "v·v", q.a, &exact::DoubleWordValues::a, 6 * exact::unit_roundoff * q.a);
  add("h", "r·v", q.h, &exact::DoubleWordValues::h, q.h_error);
  add("c", "r·r - L²", q.c, &exact::DoubleWordValues::c, q.c_error);
  add("D", "h² - ac", q.D, &exact::DoubleWordValues::D, q.D_error);
}

std::string_view spelled(exact::Sign sign) {
  return sign == exact::Sign::negative ? "negative" : sign == exact::Sign::positive ? "positive" : "zero";
}

/// The coefficients of every stage that the verdict needed. @return the name of the last one.
std::string_view add_stages(Report& report, const std::string& prefix, const exact::TimingQuery& query) {
  exact::Counters counters;
  exact::exact_verdict(query, counters);
  add_stage(report, prefix, "doubles", "doubles", exact::double_coefficients(query));
  if (exact::is_static(query)) return "equal velocities";
  if (counters.verdict.uncertain == 0) return "doubles";
  add_stage(report, prefix, "double_words", "double words", exact::double_word_coefficients(query),
            exact::double_word_values(query));
  if (counters.verdict.exact == 0) return "double words";
  const exact::LiftedQuadratic q = exact::lifted_quadratic(query, exact::units_of(query));
  report.steps.push_back(word(prefix + "integers", prefix + "integers",
                              fmt::format("h {}, c {}, D {}", spelled(exact::sign_of(q.h)),
                                          spelled(exact::sign_of(q.c)), spelled(exact::sign_of(q.D)))));
  return "integers";
}

void add_counts(Report& report, const char* key, const exact::StageCounts& counts) {
  report.results.push_back(
      word(fmt::format("{}_counts", key), fmt::format("{} questions", key),
           fmt::format("calls {}, uncertain {}, exact {}", counts.calls, counts.uncertain, counts.exact)));
}

void add_counters(Report& report, const exact::Counters& counters) {
  add_counts(report, "verdict", counters.verdict);
  add_counts(report, "time", counters.time);
  add_counts(report, "order", counters.order);
  report.results.push_back(
      word("largest_bits", "bits of the largest integer", fmt::format("{}", counters.largest_bits)));
}

std::string_view time_decider(const exact::TimingAnswer& answer, const exact::Counters& counters) {
  if (!answer.t) return "the verdict: no event";
  if (exact::at_once(answer.verdict)) return "the verdict: at once";
  if (counters.time.exact > 0) return "integers";
  return counters.time.uncertain > 0 ? "a second Newton step in double words"
                                     : "one Newton step in double words";
}

/// Doubles between the two, with a sign; both are ≥ 0, where bit patterns count upward.
std::string ulps_off(const std::optional<double>& found, const std::optional<double>& certified) {
  if (!found && !certified) return "no time in either";
  if (!found) return "no time in double";
  if (!certified) return "a time in double only";
  const auto position = [](double t) { return std::bit_cast<std::int64_t>(t + 0.0); };
  const std::int64_t distance = position(*found) - position(*certified);
  return distance == 0 ? "0, the correctly rounded one" : fmt::format("{:+}", distance);
}

std::string_view order_in_double(const Computed& first, const Computed& second) {
  if (first.verdict == kBeyond || second.verdict == kBeyond) return kBeyond;
  if (!first.t && !second.t) return "none";
  if (!second.t) return "before";
  if (!first.t) return "after";
  return *first.t < *second.t ? "before" : *first.t > *second.t ? "after" : "equal";
}

}  // namespace

Report why_time(const operations::TimingInput& input) {
  const exact::TimingQuery query = input.query();
  exact::Counters counters;
  const exact::TimingAnswer answer = exact::rounded_time(query, counters);
  const Computed in_double = computed(input);
  Report report;
  const std::string_view decider = add_stages(report, "", query);
  auto& results = report.results;
  results.push_back(word("verdict", "verdict", name(answer.verdict)));
  results.push_back(word("verdict_by", "verdict settled by", decider));
  results.push_back(time("t", "Δt, correctly rounded", answer.t));
  results.push_back(word("t_by", "Δt settled by", time_decider(answer, counters)));
  results.push_back(word("verdict_in_double", "verdict in double", in_double.verdict));
  results.push_back(time("t_in_double", "Δt in double", in_double.t));
  results.push_back(word("ulps", "ulps off", ulps_off(in_double.t, answer.t)));
  add_counters(report, counters);
  return report;
}

Report why_order(const operations::TimingInput& first, const operations::TimingInput& second) {
  exact::Counters counters;
  const exact::Order order = exact::time_order(first.query(), second.query(), counters);
  Report report;
  auto& results = report.results;
  results.push_back(word("order", "order", exact::name(order)));
  const char* decider = counters.order.exact > 0       ? "integers"
                        : counters.order.uncertain > 0 ? "double words"
                                                       : "the verdicts, or doubles with bounds";
  results.push_back(word("order_by", "order settled by", decider));
  for (const bool is_first : {true, false}) {
    const std::string prefix = is_first ? "first." : "second.";
    const exact::TimingQuery query = (is_first ? first : second).query();
    exact::Counters uncounted;
    const std::string_view verdict_by = add_stages(report, prefix, query);
    results.push_back(
        time(prefix + "t", prefix + "Δt, correctly rounded", exact::rounded_time(query, uncounted).t));
    results.push_back(word(prefix + "verdict_by", prefix + "verdict settled by", verdict_by));
  }
  results.push_back(
      word("order_in_double", "order in double", order_in_double(computed(first), computed(second))));
  add_counters(report, counters);
  return report;
}

}  // namespace tps::certified

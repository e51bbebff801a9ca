// Variants that reach further than their scalar: double words, GSL's solver, and the certified answers.
#include "verify/cost/double_word_time.hpp"
#include "verify/cost/rational_verdict.hpp"
#include "verify/cost/variant_lists.hpp"
#include "verify/cost/variant_of.hpp"
#include "verify/exact/exact_verdict.hpp"
#include "verify/exact/rounded_time.hpp"
#include "verify/oracles/oracle.hpp"

namespace tps::cost {
namespace {

constexpr int kDouble = 53;
constexpr int kDoubleWord = 106;

/// One for all questions: what the stages count does not change an answer.
exact::Counters& counters() {
  static exact::Counters counts;
  return counts;
}

exact::Verdict certified_verdict(const TimingQuery& query) {
  return exact::exact_verdict(query, counters());
}
exact::TimingAnswer certified_time(const TimingQuery& query) {
  return exact::rounded_time(query, counters());
}
exact::TimingAnswer time_by_integers(const TimingQuery& query) {
  return exact::rounded_time_by_integers(query, counters());
}

template <auto ask>
exact::Counters counted(std::span<const TimingQuery> queries) {
  counters() = {};
  throughput<ask>(queries);
  return counters();
}

template <auto ask>
Variant filtered(const std::string& formula) {
  Variant variant = variant_of<ask>(formula, "", kDouble);
  variant.counted = counted<ask>;
  return variant;
}

Answer double_word_answer(const TimingQuery& query) {
  const CollisionTime<DoubleWord> answer = double_word_time(query);
  if (!answer.t) return {};
  Answer result = answer_of(std::optional<double>(answer.t->hi));
  if (result.t) result.t->parts[1] = std::ldexp(answer.t->lo, -result.t->exponent);
  result.verdict = answer.verdict;
  return result;
}

std::optional<double> high_word(const TimingQuery& query) {
  const CollisionTime<DoubleWord> answer = double_word_time(query);
  return answer.t ? std::optional<double>(answer.t->hi + answer.t->lo) : std::nullopt;
}

}  // namespace

void add_exact_variants(std::vector<Variant>& to) {
  to.push_back(variant_of<oracles::time_by_gsl_quadratic>("gsl", "double", kDouble));
  to.push_back(variant_of<high_word>("root", "double-word", kDoubleWord));
  to.back().answer = double_word_answer;
  to.push_back(filtered<certified_verdict>("certified-verdict"));
  to.push_back(filtered<certified_time>("certified-time"));
  to.push_back(variant_of<rational_verdict>("rational-verdict", "", kDouble));
  to.push_back(variant_of<time_by_integers>("integers", "", kDouble));
}

}  // namespace tps::cost

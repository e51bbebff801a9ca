#include <algorithm>
#include <cmath>
#include <map>

#include "verify/cost/exact_answer.hpp"
#include "verify/cost/measure.hpp"
#include "verify/cost/questions.hpp"

namespace tps::cost {
namespace {

struct Judged {
  std::optional<double> log2_error;
  WrongVerdicts verdicts;
};

/// Whether both mean the same event: at once, at the limit, or at the turning of a stretched pair.
bool same_event(const Answer& answer, const ExactAnswer& exact) {
  if (answer.at_once != exact.at_once()) return false;
  if (exact.at_once() || !answer.verdict) return true;
  return (*answer.verdict == exact::Verdict::turning) == (exact.verdict() == exact::Verdict::turning);
}

Judged judge(const Answer& answer, const ExactAnswer& exact, bool has_time) {
  Judged judged;
  WrongVerdicts& v = judged.verdicts;
  v.asked = 1;
  if (answer.occurs != exact.occurs()) {
    ++(answer.occurs ? v.invented : v.missed);
    return judged;
  }
  // Beyond the normal doubles 0 and infinity are right.
  if (!exact.occurs() || (!exact.at_once() && !exact.in_range())) return judged;
  const bool infinite = has_time && !answer.at_once && !answer.t;
  if (infinite || !same_event(answer, exact)) ++v.moved;
  if (answer.t && !exact.at_once()) judged.log2_error = exact.log2_error(*answer.t);
  return judged;
}

void operator+=(WrongVerdicts& sum, const WrongVerdicts& one) {
  sum.asked += one.asked;
  sum.missed += one.missed;
  sum.invented += one.invented;
  sum.moved += one.moved;
}

/// Verdicts and errors as they come in.
struct Tally {
  WrongVerdicts verdicts;
  std::vector<double> errors;

  void add(const Judged& judged) {
    verdicts += judged.verdicts;
    if (judged.log2_error) errors.push_back(*judged.log2_error);
  }
  Errors summary() {
    if (errors.empty()) return {};
    std::sort(errors.begin(), errors.end());
    return {errors.size(), quantile(errors, 0.5), quantile(errors, 0.99), errors.back()};
  }
};

using Tallies = std::map<int, Tally>;

std::vector<Bin> bins_of(const std::string& variant, Tallies& tallies) {
  std::vector<Bin> bins;
  for (auto& [exponent, tally] : tallies)
    bins.push_back({variant, exponent, tally.verdicts, tally.summary()});
  return bins;
}

int bin_of(double log2) {
  return static_cast<int>(std::floor(log2));
}

void append(std::vector<Bin>& to, const std::vector<Bin>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

}  // namespace

StratumResult measure_accuracy(const Hazard& stratum, const StudyOptions& options,
                               const std::vector<Variant>& variants) {
  StratumResult result;
  result.stratum = stratum.name;
  result.what = stratum.what;
  const std::vector<TimingQuery> queries = questions(stratum.name, options.seed, options.questions);
  std::vector<ExactAnswer> exact;
  for (const TimingQuery& query : queries) exact.emplace_back(query);
  for (const Variant& variant : variants) {
    Tally all;
    Tallies by_tangency, by_condition;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const Judged judged = judge(variant.answer(queries[i]), exact[i], variant.has_time);
      all.add(judged);
      if (const auto distance = exact[i].log2_from_tangency()) by_tangency[bin_of(*distance)].add(judged);
      const auto condition = exact[i].condition();
      if (condition && std::isfinite(*condition) && judged.verdicts.all() == 0)
        by_condition[bin_of(std::log2(*condition))].add(judged);
    }
    result.cells.push_back({variant.name, stratum.name, all.verdicts, all.summary(), std::nullopt, {}});
    append(result.by_tangency, bins_of(variant.name, by_tangency));
    append(result.by_condition, bins_of(variant.name, by_condition));
  }
  return result;
}

}  // namespace tps::cost

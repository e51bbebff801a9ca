#include "verify/cost/response_level.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "reference/process/thread_time.hpp"
#include "verify/certified/certified_response.hpp"
#include "verify/cost/statistics.hpp"
#include "verify/cost/wanted.hpp"
#include "verify/vectors/stratum.hpp"

namespace tps::cost {
namespace {

struct Judge {
  std::array<certified::Enclosure, 3> impulse;
  std::string kind;
  bool boundary;
};

/// Questions of one stratum with their certified answers.
struct Sample {
  std::vector<ResponseQuestion> questions;
  std::vector<Judge> judges;
};

operations::Input input_of(const vectors::Json& in) {
  operations::Input input;
  for (const auto& [key, value] : in.items()) {
    input.values[key] =
        value.is_array() ? vectors::read_vector(value) : std::vector<double>{vectors::read_number(value)};
  }
  input.dimension = static_cast<int>(input.values.at("v_A").size());
  return input;
}

ResponseQuestion question_of(const operations::Input& input) {
  ResponseQuestion question{};
  const auto copy = [&](const char* key, double* to, std::size_t most) {
    const auto found = input.values.find(key);
    if (found == input.values.end()) return;
    std::copy_n(found->second.begin(), std::min(most, found->second.size()), to);
  };
  copy("u_A", question.u_A, 3);
  copy("u_B", question.u_B, 3);
  copy("v_A", question.v_A, 3);
  copy("v_B", question.v_B, 3);
  copy("dp", question.dp, 3);
  copy("m_A", &question.m_A, 1);
  copy("m_B", &question.m_B, 1);
  copy("c", &question.c, 1);
  copy("c_retract", &question.c_retract, 1);
  copy("c_revolve", &question.c_revolve, 1);
  copy("theta_revolve_deg", &question.theta_revolve_deg, 1);
  return question;
}

Judge judge_of(operations::Op op, const operations::Input& input) {
  const certified::Response response = certified::certified_response(op, input);
  Judge judge{{}, response.kind, response.boundary};
  const certified::EnclosedVector& dp =
      response.values.at(op == operations::Op::restitution_impulse ? "dp_AB" : "dp");
  std::copy(dp.begin(), dp.end(), judge.impulse.begin());
  return judge;
}

Sample sample_of(const vectors::Stratum& stratum, const ResponseLevelOptions& options) {
  Sample sample;
  for (std::uint64_t number = 0; number < static_cast<std::uint64_t>(options.questions); ++number) {
    vectors::Random random(options.seed, stratum.file_name(),
                           number / static_cast<std::uint64_t>(stratum.together));
    const operations::Input input = input_of(stratum.problem(random, number).in);
    sample.questions.push_back(question_of(input));
    sample.judges.push_back(judge_of(stratum.op, input));
  }
  return sample;
}

double norm(double x, double y, double z) {
  return std::hypot(x, y, z);
}

/// |Δp̂ − Δp| / |Δp|; absent where Δp is zero.
std::optional<double> relative_error(const ResponseAnswer& answer, const Judge& judge) {
  const auto& p = judge.impulse;
  const double size = norm(p[0].nearest, p[1].nearest, p[2].nearest);
  if (size == 0) return std::nullopt;
  return norm(answer.impulse[0] - p[0].nearest, answer.impulse[1] - p[1].nearest,
              answer.impulse[2] - p[2].nearest) /
         size;
}

bool is_finite(const ResponseAnswer& answer) {
  return std::all_of(std::begin(answer.impulse), std::end(answer.impulse),
                     [](double x) { return std::isfinite(x); });
}

bool is_off(const ResponseAnswer& answer, const Judge& judge) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(judge.impulse[k].lo <= answer.impulse[k] && answer.impulse[k] <= judge.impulse[k].hi)) return true;
  }
  return false;
}

double cpu_ns() {
  return 1e9 * thread_seconds();
}

/// Of short loops the clock is a part: each is repeated for 50 microseconds at least.
double median_ns(const ResponseVariant& variant, const std::vector<ResponseQuestion>& questions,
                 int repetitions) {
  constexpr double kShortest = 50'000;
  const auto count = static_cast<double>(questions.size());
  const double start = cpu_ns();
  variant.throughput(questions);
  const int passes = std::max(1, static_cast<int>(kShortest / std::max(cpu_ns() - start, 1.0)));
  std::vector<double> samples;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    const double from = cpu_ns();
    for (int pass = 0; pass < passes; ++pass) variant.throughput(questions);
    samples.push_back((cpu_ns() - from) / (passes * count));
  }
  return quantiles(samples).median;
}

ResponseRow row_of(const vectors::Stratum& stratum, const Sample& sample, const ResponseVariant& variant,
                   int repetitions) {
  constexpr int kSeen = 53;           // bits: what a double holds of the truth
  constexpr double kNothing = -1000;  // log2 of no error at all
  ResponseRow row;
  row.op = operations::name(stratum.op);
  row.stratum = stratum.name;
  row.scalar = variant.scalar;
  row.bits = variant.bits;
  row.asked = sample.questions.size();
  std::vector<double> errors;
  for (std::size_t k = 0; k < sample.questions.size(); ++k) {
    const ResponseAnswer answer = variant.answer(sample.questions[k]);
    const Judge& judge = sample.judges[k];
    if (!judge.kind.empty() && answer.revolves != (judge.kind == "revolve")) {
      if (!judge.boundary) ++row.other_kind;
      continue;
    }
    if (!is_finite(answer)) {
      ++row.lost;
      continue;
    }
    if (is_off(answer, judge)) ++row.off;
    const std::optional<double> error = relative_error(answer, judge);
    if (error) errors.push_back(*error > 0 ? std::log2(*error) : kNothing);
  }
  if (!errors.empty() && variant.bits <= kSeen) {
    std::sort(errors.begin(), errors.end());
    row.log2_p50 = quantile(errors, 0.5);
    row.log2_p99 = quantile(errors, 0.99);
    row.log2_max = errors.back();
  }
  row.ns = median_ns(variant, sample.questions, repetitions);
  return row;
}

std::string part_name(const vectors::Stratum& stratum) {
  return std::string(operations::name(stratum.op)) + ", " + stratum.name;
}

std::vector<vectors::Stratum> asked_strata() {
  std::set<operations::Op> ops;
  for (const ResponseVariant& variant : response_variants()) ops.insert(variant.op);
  std::vector<vectors::Stratum> result;
  for (const vectors::Stratum& stratum : vectors::strata()) {
    if (ops.contains(stratum.op)) result.push_back(stratum);
  }
  return result;
}

}  // namespace

std::vector<std::string> response_parts() {
  std::vector<std::string> names;
  for (const vectors::Stratum& stratum : asked_strata()) names.push_back(part_name(stratum));
  return names;
}

ResponseLevel measure_responses(const ResponseLevelOptions& options) {
  ResponseLevel level;
  level.seed = options.seed;
  level.questions = options.questions;
  const std::vector<ResponseVariant> variants = response_variants();
  for (const vectors::Stratum& stratum : asked_strata()) {
    if (!is_wanted(options.parts, part_name(stratum))) continue;
    options.announce(part_name(stratum));
    const Sample sample = sample_of(stratum, options);
    for (const ResponseVariant& variant : variants) {
      if (variant.op == stratum.op)
        level.rows.push_back(row_of(stratum, sample, variant, options.repetitions));
    }
  }
  return level;
}

}  // namespace tps::cost

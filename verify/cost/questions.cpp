#include "verify/cost/questions.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "verify/vectors/known_answer.hpp"
#include "verify/vectors/stratum.hpp"

namespace tps::cost {
namespace {

constexpr const char* kTwins = "twins";

const vectors::Stratum& stratum_of(operations::Op op, const std::string& name) {
  const auto& all = vectors::strata();
  return *std::find_if(all.begin(), all.end(),
                       [&](const vectors::Stratum& s) { return s.op == op && s.name == name; });
}

}  // namespace

const std::vector<Hazard>& hazards() {
  static const std::vector<Hazard> all = [] {
    std::vector<Hazard> result;
    for (const vectors::Stratum& stratum : vectors::strata()) {
      if (stratum.op == operations::Op::block_time) result.push_back({stratum.name, stratum.why});
    }
    return result;
  }();
  return all;
}

std::vector<exact::TimingQuery> questions(const std::string& name, std::uint64_t seed, int count) {
  const vectors::Stratum& block = stratum_of(operations::Op::block_time, name);
  const vectors::Stratum& tether = stratum_of(operations::Op::tether_time, name);
  std::vector<exact::TimingQuery> queries;
  for (int number = 0; number < count; ++number) {
    // The kind changes behind each pair of twins.
    const bool blocks = number / 2 % 2 == 0;
    const vectors::Stratum& stratum = blocks ? block : tether;
    // A twin is a question of its own; the second spelling of a planar case is not.
    const auto which = static_cast<std::uint64_t>(name == kTwins ? number : 2 * number);
    vectors::Random random(seed, stratum.file_name(), which / static_cast<std::uint64_t>(stratum.together));
    const auto kind = blocks ? exact::Kind::block : exact::Kind::tether;
    queries.push_back(vectors::read_timing_input(kind, stratum.problem(random, which).in));
  }
  return queries;
}

exact::TimingQuery in_single_precision(exact::TimingQuery query) {
  for (auto* vector : {&query.u_A, &query.u_B, &query.v_A, &query.v_B}) {
    for (double& x : *vector) x = static_cast<float>(x);
  }
  query.L = static_cast<float>(query.L);
  return query;
}

}  // namespace tps::cost

#include "verify/vectors/generate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "reference/text/plain_json.hpp"
#include "reference/version.hpp"

namespace tps::vectors {

using namespace std::string_view_literals;

namespace {

/// Committed cases whose answer has changed since they were first written. 2: the condition is that of the
/// exact time, where √D had cancelled in a t + h or the time underflows; some by a unit in the third digit.
constexpr std::array kSecondRevision{
    "block_time.subnormal.00121"sv,  "block_time.twins.00115"sv,      "block_time.twins.00165"sv,
    "tether_time.subnormal.00079"sv, "tether_time.subnormal.00101"sv, "tether_time.subnormal.00108"sv,
    "tether_time.subnormal.00109"sv, "tether_time.subnormal.00126"sv, "tether_time.subnormal.00130"sv,
    "tether_time.twins.00027"sv,     "tether_time.twins.00149"sv,     "tether_time.wide.00047"sv,
    "tether_time.wide.00102"sv};

int revision_of(std::string_view id, std::uint64_t seed) {
  const bool is_second = seed == kCommittedSeed && std::find(kSecondRevision.begin(), kSecondRevision.end(),
                                                             id) != kSecondRevision.end();
  return is_second ? 2 : 1;
}

}  // namespace

const std::vector<Stratum>& strata() {
  static const std::vector<Stratum> table = [] {
    std::vector<Stratum> made;
    add_timing_strata(made);
    add_order_strata(made);
    add_response_strata(made);
    add_group_strata(made);
    add_next_event_strata(made);
    add_wall_strata(made);
    add_drag_strata(made);
    add_rough_strata(made);
    return made;
  }();
  return table;
}

Extent extent_of(const Stratum& stratum, int level, std::uint64_t count_at_level_3) {
  const auto committed = static_cast<std::uint64_t>(stratum.committed);
  if (level == 1) return {0, std::min<std::uint64_t>(committed, kSmokeCases)};
  if (level == 2) return {0, committed};
  return {committed, count_at_level_3};
}

std::string header_line(const Stratum& stratum, std::uint64_t seed, const Extent& extent) {
  const Json header{{"schema", "vectors"},
                    {"version", kVectorsVersion},
                    {"semantics", kSemanticsVersion},
                    {"op", operations::name(stratum.op)},
                    {"stratum", stratum.name},
                    {"why", stratum.why},
                    {"generator", "tps vectors"},
                    {"seed", seed},
                    {"first", extent.first},
                    {"count", extent.count}};
  return json_text(header) + "\n";
}

Json case_object(const Stratum& stratum, std::uint64_t seed, std::uint64_t number) {
  const auto together = static_cast<std::uint64_t>(stratum.together);
  Random random(seed, stratum.file_name(), number / together);
  const Problem problem = stratum.problem(random, number);
  const auto id = [&](std::uint64_t n) { return fmt::format("{}.{:05}", stratum.full_name(), n); };
  Json line{{"id", id(number)}, {"rev", revision_of(id(number), seed)}, {"in", problem.in}};
  line.update(known_answer(stratum.op, problem.in));
  line["tags"] = problem.tags;
  if (together == 2) line["twin"] = id(number ^ 1U);
  line["level"] = number < kSmokeCases ? 1 : number < static_cast<std::uint64_t>(stratum.committed) ? 2 : 3;
  line["accept"] = accepted_by(stratum.op);
  return line;
}

std::string case_line(const Stratum& stratum, std::uint64_t seed, std::uint64_t number) {
  return json_text(case_object(stratum, seed, number)) + "\n";
}

void write_stratum(const Stratum& stratum, std::uint64_t seed, const Extent& extent,
                   const std::function<void(std::string_view)>& write) {
  write(header_line(stratum, seed, extent));
  for (std::uint64_t n = extent.first; n < extent.first + extent.count; ++n)
    write(case_line(stratum, seed, n));
}

}  // namespace tps::vectors

#include "verify/cost/hard_cases.hpp"

#include <algorithm>

#include "reference/text/input_error.hpp"
#include "verify/cost/enclosed_run.hpp"
#include "verify/cost/traced_run.hpp"

namespace tps::cost {
namespace {

struct Arithmetic {
  const char* scalar;
  Timing timing;
};

/// From the cheapest on (docs/accuracy-cost.md, whole runs).
constexpr Arithmetic kLadder[] = {{"float", Timing::stable},       {"double", Timing::paper},
                                  {"double", Timing::stable},      {"double", Timing::certified},
                                  {"long-double", Timing::stable}, {"quad", Timing::stable},
                                  {"mp50", Timing::stable}};

TracedRun run(const Scene& scene, std::uint64_t events, const Arithmetic& arithmetic) {
  RunOptions options;
  options.scalar = *scalar_kind(arithmetic.scalar);
  options.timing = arithmetic.timing;
  options.max_events = events;
  return traced_run(scene, options);
}

CaseOutcome outcome(const HardCase& one, const Scene& scene, const Arithmetic& arithmetic,
                    const TracedRun& truth) {
  CaseOutcome result;
  result.scalar = arithmetic.scalar;
  result.timing = timing_names()[static_cast<std::size_t>(arithmetic.timing)];
  try {
    const TracedRun run_here = run(scene, one.events, arithmetic);
    const RunSummary& s = run_here.summary;
    result.end = s.end;
    result.events = s.events;
    const bool ends_alike = s.end == truth.summary.end;
    if (one.right_by != RightBy::end || !ends_alike) result.horizon = horizon(run_here.events, truth.events);
    if (!result.horizon && !ends_alike) result.horizon = s.events;
    result.worst_excess =
        std::max({s.worst_inner_excess, s.worst_outer_excess, s.audit_inner_excess, s.audit_outer_excess});
  } catch (const InputError&) {
    result.end = "refused";
    result.horizon = 0;
  }
  return result;
}

/// Whether affine arithmetic of so many bits proves all that the case has; else why not.
std::string failure_of(const HardCase& one, const Scene& scene, long bits, const TracedRun& truth) {
  const EnclosedRun run = enclosed_run(scene, {Starts::stored, bits, one.events});
  const bool all =
      run.events == truth.events && (run.ends_by == "end") == (truth.summary.end != "max_events");
  return all ? "" : run.ends_by;
}

/// More digits prove more, so the first that are enough are found by bisection.
void prove(CaseResult& result, const HardCase& one, const Scene& scene, const TracedRun& truth) {
  result.unproven = one.right_by == RightBy::events ? why_not_enclosed(scene) : "ties or no end";
  if (!result.unproven.empty()) return;
  const std::vector<long>& digits = proof_digits();
  result.unproven = failure_of(one, scene, digits.back(), truth);
  if (!result.unproven.empty()) return;
  const auto enough = std::partition_point(digits.begin(), digits.end() - 1, [&](long bits) {
    return !failure_of(one, scene, bits, truth).empty();
  });
  result.proven_bits = *enough;
}

}  // namespace

const std::vector<long>& proof_digits() {
  static const std::vector<long> digits = {24, 53, 64, 113, 200, 400};
  return digits;
}

const CaseOutcome* CaseResult::good_enough() const {
  if (right_by == RightBy::nothing) return nullptr;
  const auto found =
      std::find_if(outcomes.begin(), outcomes.end(), [](const CaseOutcome& o) { return !o.horizon; });
  return found == outcomes.end() ? nullptr : &*found;
}

CaseResult measure_case(const HardCase& one) {
  const Scene scene = one.scene();
  const TracedRun truth = run(scene, one.events, {"mp100", Timing::stable});
  CaseResult result{one.name, one.what, truth.summary.events, truth.summary.end, one.right_by, {}, {}, {}};
  for (const Arithmetic& arithmetic : kLadder)
    result.outcomes.push_back(outcome(one, scene, arithmetic, truth));
  prove(result, one, scene, truth);
  return result;
}

}  // namespace tps::cost

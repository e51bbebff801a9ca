// For the program of the first build: what only the whole one can do.
#include "reference/run/run_scalar.hpp"
#include "reference/scalars.hpp"
#include "verify/cli/not_built.hpp"
#include "verify/trace_check/judge_lines.hpp"
#include "verify/trace_check/witness.hpp"
#include "verify/view/checked_page.hpp"
#include "verify/view/page.hpp"

namespace tps {

template <>
RunSummary run_in<float>(const Scene&, const RunOptions&, const ResumePoint*) {
  throw cli::NotBuilt("a run in float");
}
template <>
RunSummary run_in<long double>(const Scene&, const RunOptions&, const ResumePoint*) {
  throw cli::NotBuilt("a run in long-double");
}
template <>
RunSummary run_in<Quad>(const Scene&, const RunOptions&, const ResumePoint*) {
  throw cli::NotBuilt("a run in quad");
}
template <>
RunSummary run_in<Mp50>(const Scene&, const RunOptions&, const ResumePoint*) {
  throw cli::NotBuilt("a run in mp50");
}
template <>
RunSummary run_in<Mp100>(const Scene&, const RunOptions&, const ResumePoint*) {
  throw cli::NotBuilt("a run in mp100");
}

std::unique_ptr<check::LineJudge> check::judge_of_wide(const JudgeParts&, std::string_view scalar,
                                                       std::string_view, std::uint64_t) {
  throw cli::NotBuilt("the check of a trace in " + std::string(scalar));
}

std::string check::witness_cases(const CheckReport&) {
  throw cli::NotBuilt("--witness");
}

void view::require_viewer() {
  throw cli::NotBuilt("--view");
}

std::string view::checked_page(const std::string&, const std::string&, const check::CheckReport&) {
  throw cli::NotBuilt("--view");
}

}  // namespace tps

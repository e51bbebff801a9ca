// For the program of the first build: what only the whole one can do.
#include "reference/run/run_scalar.hpp"
#include "reference/scalars.hpp"
#include "verify/cli/not_built.hpp"
#include "verify/trace_check/witness.hpp"
#include "verify/view/checked_page.hpp"
#include "verify/view/page.hpp"

namespace tps {

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

// For the program of the first build: runs in wide scalars are part of the whole one only.
#include "reference/run/run_scalar.hpp"
#include "verify/cli/not_built.hpp"

namespace tps {

RunSummary run_quad(const Scene&, const RunOptions&, const ResumePoint*) {
  throw cli::NotBuilt("a run in quad");
}
RunSummary run_mp50(const Scene&, const RunOptions&, const ResumePoint*) {
  throw cli::NotBuilt("a run in mp50");
}
RunSummary run_mp100(const Scene&, const RunOptions&, const ResumePoint*) {
  throw cli::NotBuilt("a run in mp100");
}

}  // namespace tps

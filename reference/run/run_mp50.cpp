#include "reference/run/run_in.hpp"
#include "reference/run/run_scalar.hpp"
#include "reference/scalars.hpp"

namespace tps {

RunSummary run_mp50(const Scene& scene, const RunOptions& options, const ResumePoint* resume) {
  return run_in<Mp50>(scene, options, resume);
}

}  // namespace tps

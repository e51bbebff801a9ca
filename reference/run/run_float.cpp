#include "reference/run/run_in.hpp"
#include "reference/run/run_scalar.hpp"

namespace tps {

RunSummary run_float(const Scene& scene, const RunOptions& options, const ResumePoint* resume) {
  return run_in<float>(scene, options, resume);
}

}  // namespace tps

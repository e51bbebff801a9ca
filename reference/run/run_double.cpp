#include "reference/run/run_in.hpp"
#include "reference/run/run_scalar.hpp"

namespace tps {

RunSummary run_double(const Scene& scene, const RunOptions& options, const ResumePoint* resume) {
  return run_in<double>(scene, options, resume);
}

}  // namespace tps

#include "reference/run/run_in.hpp"
#include "reference/run/run_scalar.hpp"
#include "reference/scalars.hpp"

namespace tps {

RunSummary run_quad(const Scene& scene, const RunOptions& options, const ResumePoint* resume) {
  return run_in<Quad>(scene, options, resume);
}

}  // namespace tps

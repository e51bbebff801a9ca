#include "reference/run/grouped_bodies_in.hpp"
#include "reference/run/run_in.hpp"
#include "reference/run/run_scalar.hpp"

namespace tps {

static_assert(std::numeric_limits<float>::digits == significant_bits(ScalarKind::float_));

RunSummary run_float(const Scene& scene, const RunOptions& options, const ResumePoint* resume) {
  return run_in<float>(scene, options, resume);
}

GroupedVelocities group_float(const GroupedBodies& question) {
  return group_in<float>(question);
}

}  // namespace tps

#include "reference/run/grouped_bodies_in.hpp"
#include "reference/run/run_in.hpp"
#include "reference/run/run_scalar.hpp"

namespace tps {

static_assert(std::numeric_limits<double>::digits == significant_bits(ScalarKind::double_));

RunSummary run_double(const Scene& scene, const RunOptions& options, const ResumePoint* resume) {
  return run_in<double>(scene, options, resume);
}

GroupedVelocities group_double(const GroupedBodies& question) {
  return group_in<double>(question);
}

}  // namespace tps

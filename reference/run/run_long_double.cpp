#include "reference/run/grouped_bodies_in.hpp"
#include "reference/run/run_in.hpp"
#include "reference/run/run_scalar.hpp"

namespace tps {

static_assert(std::numeric_limits<long double>::digits == significant_bits(ScalarKind::long_double));

RunSummary run_long_double(const Scene& scene, const RunOptions& options, const ResumePoint* resume) {
  return run_in<long double>(scene, options, resume);
}

GroupedVelocities group_long_double(const GroupedBodies& question) {
  return group_in<long double>(question);
}

}  // namespace tps

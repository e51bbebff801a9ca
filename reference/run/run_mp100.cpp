#include "reference/run/grouped_bodies_in.hpp"
#include "reference/run/run_in.hpp"
#include "reference/run/run_scalar.hpp"
#include "reference/scalars.hpp"

namespace tps {

static_assert(std::numeric_limits<Mp100>::digits == significant_bits(ScalarKind::mp100));

RunSummary run_mp100(const Scene& scene, const RunOptions& options, const ResumePoint* resume) {
  return run_in<Mp100>(scene, options, resume);
}

GroupedVelocities group_mp100(const GroupedBodies& question) {
  return group_in<Mp100>(question);
}

}  // namespace tps

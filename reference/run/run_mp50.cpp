#include "reference/run/grouped_bodies_in.hpp"
#include "reference/run/run_in.hpp"
#include "reference/run/run_scalar.hpp"
#include "reference/scalars.hpp"

namespace tps {

static_assert(std::numeric_limits<Mp50>::digits == significant_bits(ScalarKind::mp50));

RunSummary run_mp50(const Scene& scene, const RunOptions& options, const ResumePoint* resume) {
  return run_in<Mp50>(scene, options, resume);
}

GroupedVelocities group_mp50(const GroupedBodies& question) {
  return group_in<Mp50>(question);
}

}  // namespace tps

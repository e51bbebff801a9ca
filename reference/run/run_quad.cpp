#include "reference/run/grouped_bodies_in.hpp"
#include "reference/run/run_in.hpp"
#include "reference/run/run_scalar.hpp"
#include "reference/scalars.hpp"

namespace tps {

static_assert(std::numeric_limits<Quad>::digits == significant_bits(ScalarKind::quad));

RunSummary run_quad(const Scene& scene, const RunOptions& options, const ResumePoint* resume) {
  return run_in<Quad>(scene, options, resume);
}

GroupedVelocities group_quad(const GroupedBodies& question) {
  return group_in<Quad>(question);
}

}  // namespace tps

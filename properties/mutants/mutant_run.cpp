// Stands for reference/run/run_double.cpp in the program of a mutant: the plane alone, which compiles in half
// the time.
#include <stdexcept>

#include "reference/run/grouped_bodies_in.hpp"
#include "reference/run/run_in.hpp"
#include "reference/run/run_scalar.hpp"

namespace tps {

RunSummary run_double(const Scene& scene, const RunOptions& options, const ResumePoint* resume) {
  if (scene.dimension != 2) throw std::invalid_argument("a mutant runs scenes in the plane");
  return RecordedRun<double, 2>(scene, options, resume).run();
}

GroupedVelocities group_double(const GroupedBodies& question) {
  return group_in<double>(question);
}

}  // namespace tps

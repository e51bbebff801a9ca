// Stands for reference/run/run_double.cpp in the program of a mutant: the plane alone, which compiles in half
// the time.
#include <stdexcept>

#include "reference/run/grouped_bodies_in.hpp"
#include "reference/run/run_in.hpp"

namespace tps {

template <>
RunSummary run_in<double>(const Scene& scene, const RunOptions& options, const ResumePoint* resume) {
  if (scene.dimension != 2) throw std::invalid_argument("a mutant runs scenes in the plane");
  return RecordedRun<double, 2>(scene, options, resume).run();
}

template GroupedVelocities group_in<double>(const GroupedBodies&);

}  // namespace tps

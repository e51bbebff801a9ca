#include "reference/run/grouped_bodies_in.hpp"
#include "reference/run/run_in.hpp"

namespace tps {

template RunSummary run_in<float>(const Scene&, const RunOptions&, const ResumePoint*);
template GroupedVelocities group_in<float>(const GroupedBodies&);

}  // namespace tps

#include "reference/run/grouped_bodies_in.hpp"
#include "reference/run/run_in.hpp"
#include "reference/scalars.hpp"

namespace tps {

template RunSummary run_in<Mp50>(const Scene&, const RunOptions&, const ResumePoint*);
template GroupedVelocities group_in<Mp50>(const GroupedBodies&);

}  // namespace tps

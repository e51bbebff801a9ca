#include "reference/run/grouped_bodies_in.hpp"
#include "reference/run/run_in.hpp"
#include "reference/scalars.hpp"

namespace tps {

template RunSummary run_in<Quad>(const Scene&, const RunOptions&, const ResumePoint*);
template GroupedVelocities group_in<Quad>(const GroupedBodies&);

}  // namespace tps

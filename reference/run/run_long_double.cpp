#include "reference/run/grouped_bodies_in.hpp"
#include "reference/run/run_in.hpp"

namespace tps {

template RunSummary run_in<long double>(const Scene&, const RunOptions&, const ResumePoint*);
template GroupedVelocities group_in<long double>(const GroupedBodies&);

}  // namespace tps

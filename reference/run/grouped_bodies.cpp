#include "reference/run/grouped_bodies.hpp"

#include "reference/run/run_scalar.hpp"
#include "reference/scalars.hpp"

namespace tps {

GroupedVelocities group_bodies(const GroupedBodies& question, ScalarKind scalar) {
  return AllScalars::with<GroupedVelocities>(scalar,
                                             [&]<typename Scalar>() { return group_in<Scalar>(question); });
}

}  // namespace tps

#include "reference/run/grouped_bodies.hpp"

#include <stdexcept>

#include "reference/run/run_scalar.hpp"

namespace tps {

GroupedVelocities group_bodies(const GroupedBodies& question, ScalarKind scalar) {
  switch (scalar) {
    case ScalarKind::float_:
      return group_float(question);
    case ScalarKind::double_:
      return group_double(question);
    case ScalarKind::long_double:
      return group_long_double(question);
    case ScalarKind::quad:
      return group_quad(question);
    case ScalarKind::mp50:
      return group_mp50(question);
    case ScalarKind::mp100:
      return group_mp100(question);
  }
  throw std::logic_error("unknown scalar kind");
}

}  // namespace tps

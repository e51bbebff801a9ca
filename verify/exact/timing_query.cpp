#include "verify/exact/timing_query.hpp"

#include <algorithm>
#include <cmath>

namespace tps::exact {

bool valid(const TimingQuery& query) {
  const auto finite = [](const Vec3& x) {
    return std::all_of(x.begin(), x.end(), [](double component) { return std::isfinite(component); });
  };
  return finite(query.u_A) && finite(query.u_B) && finite(query.v_A) && finite(query.v_B) &&
         std::isfinite(query.L) && query.L > 0;
}

}  // namespace tps::exact

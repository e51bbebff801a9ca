#include "verify/oracles/oracle.hpp"

namespace tps::oracles {

const std::vector<Oracle>& all_oracles() {
  static const std::vector<Oracle> oracles = {{"50 digits", time_in_50_digits},
                                              {"100 digits", time_in_100_digits},
                                              {"GSL quadratic", time_by_gsl_quadratic},
                                              {"Brent", time_by_brent}};
  return oracles;
}

}  // namespace tps::oracles

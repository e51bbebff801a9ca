// Independent answers to timing queries. Each oracle goes its own way from the stored numbers to a time; none
// shares a formula with verify/exact/, and none is trusted: docs/oracles.md records where each is wrong.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "verify/exact/timing_query.hpp"

namespace tps::oracles {

using exact::Kind;
using exact::TimingQuery;

/// One oracle: the time of the next event, absent where the oracle sees none. REQUIRES a valid query.
struct Oracle {
  std::string_view name;
  std::optional<double> (*time)(const TimingQuery&);
};

/// Eq. (2) as printed, in 50 and 100 digits, rounded to double at the end.
std::optional<double> time_in_50_digits(const TimingQuery& query);
std::optional<double> time_in_100_digits(const TimingQuery& query);

/// GSL's gsl_poly_solve_quadratic on coefficients in double.
std::optional<double> time_by_gsl_quadratic(const TimingQuery& query);

/// Brent's method (gsl_root_fsolver_brent) on eq. (1) itself: the distance as a function of time minus the
/// limit. It knows no quadratic; it finds a bracket by walking.
std::optional<double> time_by_brent(const TimingQuery& query);

const std::vector<Oracle>& all_oracles();

}  // namespace tps::oracles

// Brent's method on eq. (1): no coefficients, no discriminant, only the distance at a time.
#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include <cmath>
#include <cstddef>
#include <memory>

#include "verify/oracles/oracle.hpp"

namespace tps::oracles {
namespace {

/// Eq. (1) minus the limit.
double clearance(double t, void* data) {
  const auto& query = *static_cast<const TimingQuery*>(data);
  double separation[3];
  for (std::size_t k = 0; k < 3; ++k) {
    separation[k] = (query.u_B[k] + query.v_B[k] * t) - (query.u_A[k] + query.v_A[k] * t);
  }
  return std::sqrt(separation[0] * separation[0] + separation[1] * separation[1] +
                   separation[2] * separation[2]) -
         query.L;
}

/// The root between two times where the clearance differs in sign, to the last bits that Brent's method
/// gives.
std::optional<double> root_between(TimingQuery query, double low, double high) {
  gsl_function function{&clearance, &query};
  const std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent), &gsl_root_fsolver_free);
  if (gsl_root_fsolver_set(solver.get(), &function, low, high) != GSL_SUCCESS) return std::nullopt;
  for (int step = 0; step < 200; ++step) {
    if (gsl_root_fsolver_iterate(solver.get()) != GSL_SUCCESS) break;
    const double x_low = gsl_root_fsolver_x_lower(solver.get());
    const double x_high = gsl_root_fsolver_x_upper(solver.get());
    if (gsl_root_test_interval(x_low, x_high, 0, 1e-15) == GSL_SUCCESS) break;
  }
  return gsl_root_fsolver_root(solver.get());
}

/// The time ≥ 0 of closest approach, by golden section on the distance: about half of a double's digits, as a
/// minimum found from values alone must be. The walk ends where the distance has grown by more than its
/// rounding (2^-40 of it).
double closest_approach(TimingQuery& query) {
  const double start = clearance(0, &query);
  const double grown = start + 0x1p-40 * (start + 2 * query.L);
  double high = 0x1p-60;
  while (high < 0x1p60 && !(clearance(high, &query) > grown)) high *= 2;
  double low = 0;
  constexpr double kGolden = 0.6180339887498949;
  for (int step = 0; step < 300 && high - low > 1e-16 * high; ++step) {
    const double left = high - kGolden * (high - low);
    const double right = low + kGolden * (high - low);
    if (clearance(left, &query) <= clearance(right, &query)) {
      high = right;
    } else {
      low = left;
    }
  }
  return (low + high) / 2;
}

}  // namespace

std::optional<double> time_by_brent(const TimingQuery& given) {
  TimingQuery query = given;
  gsl_set_error_handler_off();  // GSL would abort the program where a bracket has no sign change
  const double closest = closest_approach(query);
  const double at_start = clearance(0, &query);
  const double at_closest = clearance(closest, &query);
  const bool approaches = at_closest < at_start;
  if (query.kind == Kind::block) {
    if (!approaches) return std::nullopt;
    if (at_start <= 0) return 0.0;
    if (at_closest >= 0) return std::nullopt;
    return root_between(query, 0, closest);
  }
  if (at_start >= 0 && !approaches)
    return clearance(0x1p60, &query) > at_start ? std::optional(0.0) : std::nullopt;
  if (at_closest >= 0) return closest;
  double outside = closest > 0 ? 2 * closest : 0x1p-60;
  while (outside < 0x1p60 && clearance(outside, &query) <= 0) outside *= 2;
  if (clearance(outside, &query) <= 0) return std::nullopt;
  return root_between(query, closest, outside);
}

}  // namespace tps::oracles

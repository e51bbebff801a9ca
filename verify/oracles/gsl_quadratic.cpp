#include "verify/oracles/gsl_quadratic.hpp"

#include <gsl/gsl_poly.h>

#include <cstddef>

#include "verify/oracles/oracle.hpp"

namespace tps::oracles {

RealRoots gsl_quadratic_roots(double A, double B, double C) {
  RealRoots roots{0, 0, 0};
  roots.count = gsl_poly_solve_quadratic(A, B, C, &roots.smaller, &roots.larger);
  return roots;
}

/// The paper's a, b, c in double; which root, and whether it counts, by the sign of the distance's slope at
/// it.
std::optional<double> time_by_gsl_quadratic(const TimingQuery& query) {
  double A = 0;
  double B = 0;
  double C = -query.L * query.L;
  for (std::size_t k = 0; k < 3; ++k) {
    const double separation = query.u_B[k] - query.u_A[k];
    const double speed = query.v_B[k] - query.v_A[k];
    A += speed * speed;
    B += 2 * separation * speed;
    C += separation * separation;
  }
  if (A == 0) return std::nullopt;
  const RealRoots roots = gsl_quadratic_roots(A, B, C);
  if (query.kind == Kind::block) {
    if (B >= 0) return std::nullopt;
    if (C <= 0) return 0.0;
    if (roots.count < 2 || roots.smaller == roots.larger) return std::nullopt;
    return roots.smaller;
  }
  if (C >= 0 && B >= 0) return 0.0;
  if (roots.count < 2) return -B / (2 * A);
  return roots.larger;
}

}  // namespace tps::oracles

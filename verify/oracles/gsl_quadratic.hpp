// GSL's quadratic solver, as such.
#pragma once

namespace tps::oracles {

/// The real roots of A x² + B x + C as gsl_poly_solve_quadratic finds them.
struct RealRoots {
  int count;
  double smaller, larger;  ///< meaningful for count = 2
};

RealRoots gsl_quadratic_roots(double A, double B, double C);

}  // namespace tps::oracles

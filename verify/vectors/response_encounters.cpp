#include "verify/vectors/response_encounters.hpp"

#include <cmath>

namespace tps::vectors::encounters {
Encounter plain(Random& random, int dimension) {
  return {.u_A = numbers_within(random, dimension, 2),
          .u_B = numbers_within(random, dimension, 2),
          .v_A = numbers_within(random, dimension, 1),
          .v_B = numbers_within(random, dimension, 1),
          .dp = numbers_within(random, dimension, 1),
          .m_A = random.uniform(0.5, 2),
          .m_B = random.uniform(0.5, 2),
          .c = random.uniform(0, 1),
          .c_retract = random.uniform(0, 1),
          .c_revolve = random.uniform(0, 1),
          .theta_revolve_deg = random.uniform(1, 89)};
}

Encounter masses(Random& random, int dimension) {
  Encounter e = plain(random, dimension);
  for (double* m : {&e.m_A, &e.m_B}) {
    const double significand = random.uniform(1, 2);
    *m = std::ldexp(significand, random.integer(-50, 49));
  }
  const int wall = random.integer(0, 5);
  if (wall == 0) e.m_A = HUGE_VAL;
  if (wall == 1) e.m_B = HUGE_VAL;
  return e;
}

Encounter coefficients(Random& random, int dimension) {
  Encounter e = plain(random, dimension);
  for (double* c : {&e.c, &e.c_retract, &e.c_revolve}) *c = random.integer(0, 1);
  const double angles[] = {1e-6, 45, 90 - 1e-6};
  e.theta_revolve_deg = angles[random.integer(0, 2)];
  return e;
}

Encounter integers(Random& random, int dimension) {
  Encounter e = plain(random, dimension);
  for (std::vector<double>* x : {&e.u_A, &e.u_B, &e.v_A, &e.v_B, &e.dp}) {
    for (double& component : *x) component = random.integer(-4, 4);
  }
  for (double* m : {&e.m_A, &e.m_B}) *m = std::ldexp(1.0, random.integer(-3, 3));
  for (double* c : {&e.c, &e.c_retract, &e.c_revolve}) *c = random.integer(0, 4) / 4.0;
  e.theta_revolve_deg = random.coin() ? 45 : 30;
  return e;
}

Encounter perpendicular(Random& random, int dimension) {
  Encounter e = plain(random, dimension);
  const double r_x = e.u_B[0] - e.u_A[0];
  const double r_y = e.u_B[1] - e.u_A[1];
  e.v_B = e.v_A;
  e.v_B[0] -= r_y;
  e.v_B[1] += r_x;
  return e;
}

Encounter near_static(Random& random, int dimension) {
  Encounter e = plain(random, dimension);
  e.v_B = e.v_A;
  double& x = e.v_B[static_cast<std::size_t>(random.integer(0, dimension - 1))];
  x = std::nextafter(x, random.coin() ? 9 : -9);
  return e;
}

Encounter offset_origin(Random& random, int dimension) {
  Encounter e = plain(random, dimension);
  const double offset = std::ldexp(1.0, random.integer(10, 45));
  for (std::vector<double>* x : {&e.u_A, &e.u_B}) {
    for (double& component : *x) component += offset;
  }
  return e;
}

Encounter any_scale(Random& random, int dimension) {
  Encounter e = plain(random, dimension);
  const auto scale = [&](std::initializer_list<std::vector<double>*> vectors, int power) {
    for (std::vector<double>* x : vectors) {
      for (double& component : *x) component = std::ldexp(component, power);
    }
  };
  scale({&e.u_A, &e.u_B}, random.integer(-400, 400));
  scale({&e.v_A, &e.v_B, &e.dp}, random.integer(-300, 300));
  return e;
}

Encounter float32(Random& random, int dimension) {
  Encounter e = plain(random, dimension);
  for (std::vector<double>* x : {&e.u_A, &e.u_B, &e.v_A, &e.v_B, &e.dp}) {
    for (double& component : *x) component = static_cast<float>(component);
  }
  for (double* x : {&e.m_A, &e.m_B, &e.c, &e.c_retract, &e.c_revolve, &e.theta_revolve_deg}) {
    *x = static_cast<float>(*x);
  }
  return e;
}

Encounter boundary(Random& random, int dimension) {
  Encounter e = integers(random, dimension);
  const double along = random.integer(1, 8);
  const double retract = random.integer(1, 4) / 4.0;
  e.u_B = e.u_A;
  e.u_B[0] += random.integer(1, 4);
  e.v_B = e.v_A;
  e.v_B[0] += along;
  e.theta_revolve_deg = 45;
  e.c_retract = random.integer(0, 3) == 0 ? 0 : retract;
  e.v_B[1] += e.c_retract * along;
  return e;
}

Encounter near_boundary(Random& random, int dimension) {
  Encounter e = boundary(random, dimension);
  double& x = random.coin() ? e.v_B[1] : e.v_B[0];
  x = std::nextafter(x, random.coin() ? 99 : -99);
  return e;
}

Encounter graded_boundary(Random& random, int dimension) {
  struct Angle {
    double degrees, tangent;
  };
  const Angle angles[] = {
      {22.5, std::sqrt(2.0) - 1}, {30, std::sqrt(1 / 3.0)}, {45, 1}, {60, std::sqrt(3.0)}};
  Encounter e = plain(random, dimension);
  const Angle angle = angles[random.integer(0, 3)];
  e.theta_revolve_deg = angle.degrees;
  e.c_retract = random.uniform(0.25, 1);
  const double along = random.uniform(0.5, 1);
  const double across = e.c_retract * along / angle.tangent * beside_one(random, 5, 45);
  const double x = e.u_B[0] - e.u_A[0], y = e.u_B[1] - e.u_A[1];
  const double in_plane = std::sqrt(x * x + y * y);  // (−y, x)/in_plane is across r in space, too
  double squared = 0;
  for (std::size_t k = 0; k < e.u_A.size(); ++k) squared += (e.u_B[k] - e.u_A[k]) * (e.u_B[k] - e.u_A[k]);
  const double r = std::sqrt(squared);
  for (std::size_t k = 0; k < e.u_A.size(); ++k) e.v_B[k] = e.v_A[k] + along * ((e.u_B[k] - e.u_A[k]) / r);
  e.v_B[0] -= across * (y / in_plane);
  e.v_B[1] += across * (x / in_plane);
  return e;
}

Encounter near_elastic(Random& random, int dimension) {
  Encounter e = plain(random, dimension);
  for (double* c : {&e.c, &e.c_retract, &e.c_revolve}) *c = 1 - std::ldexp(1.0, -random.integer(2, 45));
  return e;
}

Encounter near_plastic(Random& random, int dimension) {
  Encounter e = plain(random, dimension);
  for (double* c : {&e.c, &e.c_retract, &e.c_revolve}) *c = std::ldexp(1.0, -random.integer(2, 45));
  return e;
}

Encounter graded_angle(Random& random, int dimension) {
  Encounter e = plain(random, dimension);
  e.theta_revolve_deg = 15 * random.integer(1, 5);
  e.theta_revolve_deg *= beside_one(random, 5, 45);
  return e;
}

Encounter graded_masses(Random& random, int dimension) {
  Encounter e = plain(random, dimension);
  e.m_B = e.m_A * beside_one(random, 5, 45);
  return e;
}

Encounter any_mass(Random& random, int dimension) {
  Encounter e = plain(random, dimension);
  const int power = random.integer(-120, 120);
  for (double* m : {&e.m_A, &e.m_B}) *m = std::ldexp(*m, power);
  for (double& component : e.dp) component = std::ldexp(component, power);
  return e;
}

Encounter spread(Random& random, int dimension) {
  Encounter e = plain(random, dimension);
  for (std::vector<double>* x : {&e.u_A, &e.u_B, &e.v_A, &e.v_B, &e.dp}) {
    for (double& component : *x) component = std::ldexp(component, -random.integer(0, 45));
  }
  return e;
}

Encounter graded_across(Random& random, int dimension) {
  Encounter e = plain(random, dimension);
  e.c_retract = 0;
  const double across = std::ldexp(1.0, -random.integer(5, 45));
  const double x = e.u_B[0] - e.u_A[0], y = e.u_B[1] - e.u_A[1];
  for (std::size_t k = 0; k < e.u_A.size(); ++k) e.v_B[k] = e.v_A[k] + (e.u_B[k] - e.u_A[k]);
  e.v_B[0] -= across * y;
  e.v_B[1] += across * x;
  return e;
}

}  // namespace tps::vectors::encounters

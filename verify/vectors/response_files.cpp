// The strata of the responses: eqs. (3) to (7) and the choice between (4) and (5).
#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "verify/eval/operations.hpp"
#include "verify/vectors/stratum.hpp"

namespace tps::vectors {
namespace {

/// Every number that some response asks for.
struct Encounter {
  std::vector<double> u_A, u_B, v_A, v_B, dp;
  double m_A, m_B, c, c_retract, c_revolve, theta_revolve_deg;
};

std::vector<double> in_cube(Random& random, int dimension, double half_edge) {
  std::vector<double> x;
  for (int k = 0; k < dimension; ++k) x.push_back(random.uniform(-half_edge, half_edge));
  return x;
}

Encounter plain(Random& random, int dimension) {
  return {.u_A = in_cube(random, dimension, 2),
          .u_B = in_cube(random, dimension, 2),
          .v_A = in_cube(random, dimension, 1),
          .v_B = in_cube(random, dimension, 1),
          .dp = in_cube(random, dimension, 1),
          .m_A = random.uniform(0.5, 2),
          .m_B = random.uniform(0.5, 2),
          .c = random.uniform(0, 1),
          .c_retract = random.uniform(0, 1),
          .c_revolve = random.uniform(0, 1),
          .theta_revolve_deg = random.uniform(1, 89)};
}

/// Ratios up to 1e30, and walls.
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

/// Restitution 0 or 1 and the ends of the range of θ_revolve.
Encounter coefficients(Random& random, int dimension) {
  Encounter e = plain(random, dimension);
  for (double* c : {&e.c, &e.c_retract, &e.c_revolve}) *c = random.integer(0, 1);
  const double angles[] = {1e-6, 45, 90 - 1e-6};
  e.theta_revolve_deg = angles[random.integer(0, 2)];
  return e;
}

/// Small integers, masses that are powers of two, coefficients that are multiples of 1/4: many answers are
/// exact.
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

/// r and v almost perpendicular: v_n is what cancels.
Encounter perpendicular(Random& random, int dimension) {
  Encounter e = plain(random, dimension);
  const double r_x = e.u_B[0] - e.u_A[0];
  const double r_y = e.u_B[1] - e.u_A[1];
  e.v_B = e.v_A;
  e.v_B[0] -= r_y;
  e.v_B[1] += r_x;
  return e;
}

/// The velocities differ by one unit in the last place.
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

/// |c_retract v_n| = tan θ |v_ŵ| exactly: θ = 45°, along an axis, or v_ŵ = 0 with c_retract = 0.
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

/// The boundary with one number changed in its last bit.
Encounter near_boundary(Random& random, int dimension) {
  Encounter e = boundary(random, dimension);
  double& x = random.coin() ? e.v_B[1] : e.v_B[0];
  x = std::nextafter(x, random.coin() ? 99 : -99);
  return e;
}

/// |c_retract v_n| and tan θ |v_ŵ| differ by 2^-k of themselves, along any axis: θ where tan θ has a root at
/// most, since a library's tangent is its own in the last bit.
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

/// Almost elastic: what is lost is 2^-k of what comes back.
Encounter near_elastic(Random& random, int dimension) {
  Encounter e = plain(random, dimension);
  for (double* c : {&e.c, &e.c_retract, &e.c_revolve}) *c = 1 - std::ldexp(1.0, -random.integer(2, 45));
  return e;
}

/// Hardly any restitution: what comes back is 2^-k of what came.
Encounter near_plastic(Random& random, int dimension) {
  Encounter e = plain(random, dimension);
  for (double* c : {&e.c, &e.c_retract, &e.c_revolve}) *c = std::ldexp(1.0, -random.integer(2, 45));
  return e;
}

/// Every component times a 2^-k of its own.
Encounter spread(Random& random, int dimension) {
  Encounter e = plain(random, dimension);
  for (std::vector<double>* x : {&e.u_A, &e.u_B, &e.v_A, &e.v_B, &e.dp}) {
    for (double& component : *x) component = std::ldexp(component, -random.integer(0, 45));
  }
  return e;
}

/// Nothing comes back along r, and across it the velocity is 2^-k of that along it: a revolution still.
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

Json input_of(const eval::Operation& operation, const Encounter& e) {
  const std::map<std::string, Json> every{{"u_A", hex(e.u_A)},
                                          {"u_B", hex(e.u_B)},
                                          {"v_A", hex(e.v_A)},
                                          {"v_B", hex(e.v_B)},
                                          {"dp", hex(e.dp)},
                                          {"m_A", hex(e.m_A)},
                                          {"m_B", hex(e.m_B)},
                                          {"c", hex(e.c)},
                                          {"c_retract", hex(e.c_retract)},
                                          {"c_revolve", hex(e.c_revolve)},
                                          {"theta_revolve_deg", hex(e.theta_revolve_deg)}};
  Json in;
  for (const std::string& key : operation.keys) in[key] = every.at(key);
  return in;
}

/// û needs two points, and eq. (5) a velocity across it.
bool has_answer(const eval::Operation& operation, const Encounter& e) {
  if (!operation.needs_axis) return true;
  if (e.u_A == e.u_B) return false;
  if (operation.op != eval::Op::revolution_impulse) return true;
  double dot = 0, r = 0, v = 0;  // exact for the integers, the only stratum where v_ŵ = 0 is not by design
  for (std::size_t k = 0; k < e.u_A.size(); ++k) {
    dot += (e.u_B[k] - e.u_A[k]) * (e.v_B[k] - e.v_A[k]);
    r += (e.u_B[k] - e.u_A[k]) * (e.u_B[k] - e.u_A[k]);
    v += (e.v_B[k] - e.v_A[k]) * (e.v_B[k] - e.v_A[k]);
  }
  return dot * dot != r * v;
}

constexpr const char* kPlane = "planar";

struct Family {
  const char* name;
  const char* why;
  Encounter (*encounter)(Random&, int dimension);
};

constexpr Family response_families[] = {
    {"plain", "particles in a cube of edge 4, speeds of order 1", plain},
    {kPlane, "the same in the plane", plain},
    {"masses", "mass ratios up to 1e30, and walls", masses},
    {"coefficients", "restitution 0 and 1, the ends of the range of theta_revolve", coefficients},
    {"integers", "small integers: exact answers and zeros", integers},
    {"perpendicular", "r and v almost perpendicular", perpendicular},
    {"near_static", "the velocities differ by one unit in the last place", near_static},
    {"offset_origin", "two particles far from the origin", offset_origin},
    {"any_scale", "lengths times 2^j, velocities times 2^k", any_scale},
    {"float32", "every number exact in single precision", float32},
};
constexpr Family boundary_families[] = {
    {"boundary", "|c_retract v_n| = tan(theta) |v_w| exactly: either response passes", boundary},
    {"near_boundary", "one bit beside that boundary", near_boundary},
    {"graded_boundary", "beside that boundary by 2^-k of it, k from 5 to 45", graded_boundary},
};
constexpr Family elastic = {"near_elastic", "restitution 1 - 2^-k, k from 2 to 45", near_elastic};
constexpr Family plastic = {"near_plastic", "restitution 2^-k, k from 2 to 45", near_plastic};
constexpr Family components = {"spread", "every component times a 2^-k of its own, k from 0 to 45", spread};
constexpr Family all_but_along = {"graded_across", "c_retract = 0, |v_w| = 2^-k |v_n|, k from 5 to 45",
                                  graded_across};

constexpr int kInSpace = 60;
constexpr int kFewInSpace = 30;

bool is_planar(const Family& family, std::uint64_t number, int in_space) {
  return family.name == std::string_view(kPlane) || dimension_of_case(number, in_space) == 2;
}

void add_family(std::vector<Stratum>& strata, const eval::Operation& operation, const Family& family,
                int in_space = kInSpace) {
  const std::vector<std::string> accept{"R", "K(16)"};
  strata.push_back({std::string(operation.name), family.name, family.why, in_space + kInThePlane, accept,
                    [&operation, family, in_space](Random& random, std::uint64_t number) -> Problem {
                      const bool planar = is_planar(family, number, in_space);
                      Encounter encounter;
                      do encounter = family.encounter(random, planar ? 2 : 3);
                      while (!has_answer(operation, encounter));
                      std::vector<std::string> tags{family.name};
                      if (planar && family.name != std::string_view(kPlane)) tags.emplace_back(kPlane);
                      return {input_of(operation, encounter), tags};
                    }});
}

}  // namespace

void add_response_strata(std::vector<Stratum>& strata) {
  for (const char* name : {"apply_impulse", "collision_impulse", "revolution_impulse", "tether_response",
                           "load", "restitution_impulse"}) {
    const eval::Operation& operation = *eval::find_operation(name);
    for (const Family& family : response_families) add_family(strata, operation, family);
    if (operation.op == eval::Op::collision_impulse) add_family(strata, operation, elastic);
    if (operation.op == eval::Op::tether_response) {
      for (const Family& family : boundary_families) add_family(strata, operation, family);
      add_family(strata, operation, all_but_along, kFewInSpace);
    }
    const bool restores = std::any_of(operation.keys.begin(), operation.keys.end(),
                                      [](const std::string& key) { return key.starts_with("c"); });
    add_family(strata, operation, restores ? plastic : components, kFewInSpace);
  }
}

}  // namespace tps::vectors

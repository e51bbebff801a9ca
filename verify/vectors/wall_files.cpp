// The strata of wall_time: a particle B before a plane through A.
#include <cmath>
#include <nlohmann/json.hpp>

#include "verify/vectors/stratum.hpp"

namespace tps::vectors {
namespace wall_files {
namespace {

using exact::Kind;
using exact::TimingQuery;
using exact::Vec3;

constexpr int kCommitted = 24;

Vec3 in_cube(Random& random, double half_edge) {
  Vec3 x;
  for (double& component : x) component = random.uniform(-half_edge, half_edge);
  return x;
}

double dot(const Vec3& x, const Vec3& y) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += x[k] * y[k];
  return sum;
}

/// Of length 1 to rounding.
Vec3 direction(Random& random, bool planar) {
  Vec3 n = in_cube(random, 1);
  while (std::fabs(n[0]) < 0.1) n = in_cube(random, 1);
  if (planar) n[2] = 0;
  const double length = std::sqrt(dot(n, n));
  for (double& component : n) component /= length;
  return n;
}

/// Along an axis, as the faces of boxes are.
Vec3 along_axis(Random& random) {
  Vec3 n{};
  n[static_cast<std::size_t>(random.integer(0, 2))] = random.coin() ? 1 : -1;
  return n;
}

/// Three of four on the side of the normal, three of four on their way to the plane.
TimingQuery before(Random& random, const Vec3& normal) {
  const Vec3 point = in_cube(random, 2);
  const Vec3 r = in_cube(random, 2);
  const Vec3 v = in_cube(random, 1);
  const double side = random.integer(0, 3) == 0 || dot(normal, r) > 0 ? 1 : -1;
  const double way = random.integer(0, 3) == 0 || dot(normal, v) < 0 ? 1 : -1;
  TimingQuery query{Kind::plane, point, {}, {}, {}, 1, normal};
  for (std::size_t k = 0; k < 3; ++k) {
    query.u_B[k] = point[k] + side * r[k];
    query.v_B[k] = way * v[k];
  }
  query.L = random.uniform(0.1, 0.5);
  return query;
}

TimingQuery plain(Random& random) {
  return before(random, direction(random, false));
}

TimingQuery planar(Random& random) {
  TimingQuery query = before(random, direction(random, true));
  for (Vec3* x : {&query.u_A, &query.u_B, &query.v_A, &query.v_B}) (*x)[2] = 0;
  return query;
}

TimingQuery face(Random& random) {
  return before(random, along_axis(random));
}

/// A normal that leans by 2^-k from an axis.
TimingQuery graded_axis(Random& random) {
  Vec3 n{};
  const double side = random.coin() ? 1 : -1;
  const auto along = static_cast<std::size_t>(random.integer(0, 2));
  const double lean = std::ldexp(1.0, -random.integer(5, 45));
  n[along] = side * std::sqrt(1 - lean * lean);
  n[(along + static_cast<std::size_t>(random.integer(1, 2))) % 3] = lean;
  return before(random, n);
}

TimingQuery moving(Random& random) {
  TimingQuery query = plain(random);
  query.v_A = in_cube(random, 1);
  return query;
}

/// The particle is where rounding puts it at the limit: contact, or rounding beyond or before it.
TimingQuery touching(Random& random) {
  TimingQuery query = plain(random);
  Vec3 r;
  for (std::size_t k = 0; k < 3; ++k) r[k] = query.u_B[k] - query.u_A[k];
  const double distance = dot(query.normal, r);
  query.L = std::fabs(distance);
  if (distance < 0) {
    for (double& component : query.normal) component = -component;
  }
  return query;
}

/// Beside contact by 2^-k of the limit, on its side of the plane.
TimingQuery graded_limit(Random& random) {
  TimingQuery query = touching(random);
  query.L /= beside_one(random, 5, 45);
  return query;
}

/// Along the plane but for rounding: n·v is what cancels.
TimingQuery grazing(Random& random) {
  TimingQuery query = plain(random);
  const Vec3& n = query.normal;
  query.v_B = {-n[1], n[0], 0};
  if (random.coin()) query.v_B[0] = std::nextafter(query.v_B[0], random.coin() ? 9 : -9);
  return query;
}

/// Small integers along an axis: contacts and rational times abound.
TimingQuery integers(Random& random) {
  const auto vector = [&](int size) {
    Vec3 x;
    for (double& component : x) component = random.integer(-size, size);
    return x;
  };
  const Vec3 u_A = vector(3), u_B = vector(5), v_A = vector(1), v_B = vector(3), n = along_axis(random);
  return {Kind::plane, u_A, u_B, v_A, v_B, double(random.integer(1, 4)), n};
}

TimingQuery offset_origin(Random& random) {
  TimingQuery query = plain(random);
  const double offset = std::ldexp(1.0, random.integer(10, 45));
  for (Vec3* x : {&query.u_A, &query.u_B}) {
    for (double& component : *x) component += offset;
  }
  return query;
}

TimingQuery any_scale(Random& random) {
  TimingQuery query = moving(random);
  const int length = random.integer(-900, 900);
  const int speed = random.integer(-900, 900);
  for (std::size_t k = 0; k < 3; ++k) {
    query.u_A[k] = std::ldexp(query.u_A[k], length);
    query.u_B[k] = std::ldexp(query.u_B[k], length);
    query.v_A[k] = std::ldexp(query.v_A[k], speed);
    query.v_B[k] = std::ldexp(query.v_B[k], speed);
  }
  query.L = std::ldexp(query.L, length);
  return query;
}

TimingQuery float32(Random& random) {
  TimingQuery query = moving(random);
  for (Vec3* x : {&query.u_A, &query.u_B, &query.v_A, &query.v_B, &query.normal}) {
    for (double& component : *x) component = static_cast<float>(component);
  }
  query.L = static_cast<float>(query.L);
  return query;
}

struct Family {
  const char* name;
  const char* why;
  TimingQuery (*query)(Random&);
};

constexpr Family families[] = {
    {"plain", "a leaning plane at rest, particles in a cube of edge 4", plain},
    {"planar", "the same in the plane, in two components and in three", planar},
    {"face", "normals along an axis, as of the faces of a box", face},
    {"moving", "the plane moves, too", moving},
    {"touching", "the rounded distance is the limit: contact, or rounding beyond or before it", touching},
    {"grazing", "flies along the plane but for rounding", grazing},
    {"integers", "small integers: exact contacts, receding particles, rational times", integers},
    {"offset_origin", "plane and particle far from the origin", offset_origin},
    {"any_scale", "lengths times 2^j, velocities times 2^k", any_scale},
    {"float32", "every number exact in single precision", float32},
    {"graded_limit", "at a distance L(1 -+ 2^-k), k from 5 to 45", graded_limit},
    {"graded_axis", "normals that lean by 2^-k from an axis, k from 5 to 45", graded_axis},
};

}  // namespace
}  // namespace wall_files

void add_wall_strata(std::vector<Stratum>& strata) {
  for (const wall_files::Family& family : wall_files::families) {
    const bool is_planar = family.query == wall_files::planar;
    strata.push_back({Op::wall_time, family.name, family.why, wall_files::kCommitted,
                      [family, is_planar](Random& random, std::uint64_t number) -> Problem {
                        const int dimension = is_planar && number % 2 == 0 ? 2 : 3;
                        return {timing_input(family.query(random), dimension), {family.name}};
                      },
                      is_planar ? 2 : 1});
  }
}

}  // namespace tps::vectors

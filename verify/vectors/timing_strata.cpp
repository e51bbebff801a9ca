#include "verify/vectors/timing_strata.hpp"

#include <cmath>
#include <sstream>

namespace tps::exact::strata {

namespace {

/// In the plane its section z = 0.
Vec3 in_cube(Random& random, double half_edge, int dimension) {
  Vec3 x{};
  for (int k = 0; k < dimension; ++k) x[static_cast<std::size_t>(k)] = random.uniform(-half_edge, half_edge);
  return x;
}

/// Not hypot: its last bit differs between libraries.
double distance(const TimingQuery& q) {
  double squared = 0;
  for (std::size_t k = 0; k < 3; ++k) squared += (q.u_B[k] - q.u_A[k]) * (q.u_B[k] - q.u_A[k]);
  return std::sqrt(squared);
}

/// The rounded distance is the limit: about half of these pairs overlap, a few are exact contacts.
TimingQuery touching(Random& random, Kind kind, int dimension) {
  TimingQuery query = plain(random, kind, dimension);
  query.L = distance(query);
  return query;
}

/// Almost perpendicular at the limit: h and c are both rounding noise.
TimingQuery taut(Random& random, Kind kind, int dimension) {
  TimingQuery query = plain(random, kind, dimension);
  query.v_A = {0, 0, 0};
  query.v_B = {-(query.u_B[1] - query.u_A[1]), query.u_B[0] - query.u_A[0], 0};
  query.L = distance(query);
  return query;
}

/// Small integers: contacts, tangents, exactly perpendicular pairs and rational times abound.
TimingQuery integers(Random& random, Kind kind, int dimension) {
  const auto vector = [&](int size) -> Vec3 {
    return {double(random.integer(-size, size)), double(random.integer(-size, size)),
            dimension == 2 ? 0 : double(random.integer(-1, 1))};
  };
  return {kind, vector(5), vector(5), vector(2), vector(2), double(random.integer(1, 5))};
}

/// (3, 4) is the direction of flight, (−4, 3) the offset at closest approach: D = 0 exactly.
TimingQuery tangent(Random& random, Kind kind, int /*dimension*/) {
  const int x0 = random.integer(1, 1 << 20);
  TimingQuery query = graze(kind, 0, 0, x0, random.integer(0, 1));
  const Vec3 offset = {double(random.integer(-1000, 1000)), double(random.integer(-1000, 1000)), 0};
  for (std::size_t k = 0; k < 3; ++k) {
    query.u_A[k] += offset[k];
    query.u_B[k] += offset[k];
  }
  return query;
}

TimingQuery any_graze(Random& random, Kind kind, int /*dimension*/) {
  const double side = random.coin() ? 1 : -1;
  const int k = random.integer(5, 53);
  const double x0 = std::ldexp(1.0, random.integer(0, 20));
  return graze(kind, k, side, x0, random.integer(0, 1));
}

/// Two particles of a scene far from the origin.
TimingQuery offset_origin(Random& random, Kind kind, int dimension) {
  TimingQuery query = plain(random, kind, dimension);
  const double offset = std::ldexp(1.0, random.integer(10, 45));
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
    query.u_A[k] += offset;
    query.u_B[k] += offset;
  }
  return query;
}

TimingQuery far(Random& random, Kind kind, int dimension) {
  TimingQuery query = plain(random, kind, dimension);
  const double away = std::ldexp(1.0, random.integer(5, 40));
  for (std::size_t k = 0; k < 3; ++k) query.u_B[k] = away * query.v_A[k] + query.u_B[k];
  query.v_B = {0, 0, 0};
  return query;
}

TimingQuery near_static(Random& random, Kind kind, int dimension) {
  TimingQuery query = plain(random, kind, dimension);
  query.v_B = query.v_A;
  const auto k = static_cast<std::size_t>(random.integer(0, dimension - 1));
  query.v_B[k] = std::nextafter(query.v_B[k], random.uniform(-9, 9));
  return query;
}

TimingQuery any_scale(Random& random, Kind kind, int dimension) {
  const TimingQuery query =
      random.coin() ? plain(random, kind, dimension) : any_graze(random, kind, dimension);
  const int length = random.integer(-960, 960);
  return scaled(query, length, random.integer(-960, 960));
}

/// Every number with an exponent of its own.
TimingQuery wide(Random& random, Kind kind, int dimension) {
  const auto number = [&] { return random.any_double(-1073, 1023); };
  TimingQuery query{kind, {}, {}, {}, {}, std::fabs(number())};
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
    query.u_A[k] = number();
    query.u_B[k] = number();
    query.v_A[k] = number();
    query.v_B[k] = number();
  }
  return query;
}

/// Integers below 2^10 in units of the smallest double.
TimingQuery subnormal(Random& random, Kind kind, int dimension) {
  const TimingQuery query = integers(random, kind, dimension);
  return scaled(query, -1074, random.coin() ? -1074 : 0);
}

/// Every component rounded to single precision.
TimingQuery float32(Random& random, Kind kind, int dimension) {
  TimingQuery query = random.coin() ? plain(random, kind, dimension) : any_graze(random, kind, dimension);
  for (Vec3* vector : {&query.u_A, &query.u_B, &query.v_A, &query.v_B}) {
    for (double& x : *vector) x = static_cast<float>(x);
  }
  query.L = static_cast<float>(query.L);
  return query;
}

TimingQuery planar(Random& random, Kind kind, int /*dimension*/) {
  TimingQuery query = random.coin() ? plain(random, kind) : touching(random, kind, 3);
  query.u_A[2] = query.u_B[2] = query.v_A[2] = query.v_B[2] = 0;
  return query;
}

/// Beside the limit by 2^-k of it, and beside perpendicular by 2^-j: what a tolerance takes for contact, or
/// for neither coming nor going.
TimingQuery graded_limit(Random& random, Kind kind, int dimension) {
  TimingQuery query = plain(random, kind, dimension);
  query.L = distance(query) / beside_one(random, 5, 45);
  const double way =
      (kind == Kind::tether) == (random.integer(0, 3) > 0) ? 1 : -1;  // three of four to the limit
  const double apart = way * std::ldexp(1.0, -random.integer(0, 45));
  const double x = query.u_B[0] - query.u_A[0], y = query.u_B[1] - query.u_A[1];
  query.v_A = {0, 0, 0};
  query.v_B = {apart * x - y, apart * y + x, apart * (query.u_B[2] - query.u_A[2])};
  return query;
}

}  // namespace

TimingQuery plain(Random& random, Kind kind, int dimension) {
  TimingQuery query{kind,
                    in_cube(random, 2, dimension),
                    in_cube(random, 2, dimension),
                    in_cube(random, 1, dimension),
                    in_cube(random, 1, dimension),
                    1};
  query.L = random.uniform(0.5, 2);
  return query;
}

TimingQuery graze(Kind kind, int k, double side, double x0, int turn) {
  const double offset = 1 - side * std::ldexp(1.0, -k);
  const Vec3 zero = {0, 0, 0};
  if (turn == 0) return {kind, zero, {-x0, offset, 0}, zero, {1, 0, 0}, 1};
  return {kind, zero, {-3 * x0 - 4 * offset, -4 * x0 + 3 * offset, 0}, zero, {3, 4, 0}, 5};
}

TimingQuery relative(Kind kind, Vec3 r, Vec3 v, double L) {
  return {kind, {0, 0, 0}, r, {0, 0, 0}, v, L};
}

std::string text(const TimingQuery& query) {
  std::ostringstream out;
  out << std::hexfloat << (query.kind == Kind::block ? "block" : "tether");
  for (const Vec3& x : {query.u_A, query.u_B, query.v_A, query.v_B}) {
    out << " (" << x[0] << ", " << x[1] << ", " << x[2] << ")";
  }
  out << " L = " << query.L;
  return out.str();
}

TimingQuery scaled(TimingQuery query, int length, int speed) {
  for (std::size_t k = 0; k < 3; ++k) {
    query.u_A[k] = std::ldexp(query.u_A[k], length);
    query.u_B[k] = std::ldexp(query.u_B[k], length);
    query.v_A[k] = std::ldexp(query.v_A[k], speed);
    query.v_B[k] = std::ldexp(query.v_B[k], speed);
  }
  query.L = std::ldexp(query.L, length);
  return query;
}

const std::vector<TimingStratum>& timing_strata() {
  static const std::vector<TimingStratum> table = {
      {"plain", "particles in a cube of edge 4, speeds of order 1", plain},
      {"graze", "passes the limit at a distance L(1 -+ 2^-k), k from 5 to 53", any_graze},
      {"touching", "the rounded distance is the limit: contact, or an overlap of rounding size", touching},
      {"taut", "almost perpendicular at the limit: h and c are both of rounding size", taut},
      {"integers", "small integers: exact contacts, tangents, perpendicular pairs, rational times", integers},
      {"tangent", "D = 0 exactly", tangent},
      {"offset_origin", "two particles far from the origin", offset_origin},
      {"far", "a long way to go before the limit is reached", far},
      {"near_static", "the velocities differ by one unit in the last place", near_static},
      {"any_scale", "lengths times 2^j, velocities times 2^k", any_scale},
      {"wide", "every number with an exponent of its own", wide},
      {"subnormal", "integers in units of the smallest double", subnormal},
      {"float32", "every number exact in single precision", float32},
      {"planar", "z = 0 throughout: a case of the plane", planar},
      {"graded_limit", "at a distance L(1 -+ 2^-k), k from 5 to 45, and all but along the limit",
       graded_limit}};
  return table;
}

Kind any_kind(Random& random) {
  return random.coin() ? Kind::block : Kind::tether;
}

std::vector<Stratum> all(std::uint64_t seed, int count) {
  Random random(seed);
  std::vector<Stratum> strata;
  for (const TimingStratum& family : timing_strata()) {
    Stratum stratum{std::string(family.name), {}};
    for (int i = 0; i < count; ++i) {
      const Kind kind = any_kind(random);
      stratum.queries.push_back(family.query(random, kind, 3));
    }
    strata.push_back(stratum);
  }
  return strata;
}

}  // namespace tps::exact::strata

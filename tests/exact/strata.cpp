#include "tests/exact/strata.hpp"

#include <cmath>
#include <functional>
#include <sstream>

namespace tps::exact::strata {

std::uint64_t Random::bits() {
  std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

double Random::uniform(double low, double high) {
  return low + (high - low) * std::ldexp(static_cast<double>(bits() >> 11), -53);
}

int Random::integer(int low, int high) {
  return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
}

double Random::any_double(int low, int high) {
  const double significand = std::ldexp(static_cast<double>((bits() >> 11) | (1ULL << 52)), -52);
  const double x = std::ldexp(significand, integer(low, high));
  return (bits() & 1U) != 0 ? x : -x;
}

namespace {

Vec3 in_cube(Random& random, double half_edge) {
  return {random.uniform(-half_edge, half_edge), random.uniform(-half_edge, half_edge),
          random.uniform(-half_edge, half_edge)};
}

Kind any_kind(Random& random) {
  return (random.bits() & 1U) != 0 ? Kind::block : Kind::tether;
}

/// Not hypot: its last bit differs between libraries.
double distance(const TimingQuery& q) {
  double squared = 0;
  for (std::size_t k = 0; k < 3; ++k) squared += (q.u_B[k] - q.u_A[k]) * (q.u_B[k] - q.u_A[k]);
  return std::sqrt(squared);
}

/// The rounded distance is the limit: about half of these pairs overlap, a few are exact contacts.
TimingQuery touching(Random& random) {
  TimingQuery query = plain(random, any_kind(random));
  query.L = distance(query);
  return query;
}

/// Almost perpendicular at the limit: h and c are both rounding noise.
TimingQuery taut(Random& random) {
  TimingQuery query = plain(random, Kind::tether);
  query.v_A = {0, 0, 0};
  query.v_B = {-(query.u_B[1] - query.u_A[1]), query.u_B[0] - query.u_A[0], 0};
  query.L = distance(query);
  return query;
}

/// Small integers: contacts, tangents, exactly perpendicular pairs and rational times abound.
TimingQuery integers(Random& random) {
  const auto vector = [&](int size) -> Vec3 {
    return {double(random.integer(-size, size)), double(random.integer(-size, size)),
            double(random.integer(-1, 1))};
  };
  return {any_kind(random), vector(5), vector(5), vector(2), vector(2), double(random.integer(1, 5))};
}

/// (3, 4) is the direction of flight, (−4, 3) the offset at closest approach: D = 0 exactly.
TimingQuery tangent(Random& random) {
  TimingQuery query = graze(any_kind(random), 0, 0, random.integer(1, 1 << 20), random.integer(0, 1));
  const Vec3 offset = {double(random.integer(-1000, 1000)), double(random.integer(-1000, 1000)), 0};
  for (std::size_t k = 0; k < 3; ++k) {
    query.u_A[k] += offset[k];
    query.u_B[k] += offset[k];
  }
  return query;
}

TimingQuery any_graze(Random& random) {
  const double side = (random.bits() & 1U) != 0 ? 1 : -1;
  return graze(any_kind(random), random.integer(5, 53), side, std::ldexp(1.0, random.integer(0, 20)),
               random.integer(0, 1));
}

/// Two particles of a scene far from the origin.
TimingQuery offset_origin(Random& random) {
  TimingQuery query = plain(random, any_kind(random));
  const double offset = std::ldexp(1.0, random.integer(10, 45));
  for (std::size_t k = 0; k < 3; ++k) {
    query.u_A[k] += offset;
    query.u_B[k] += offset;
  }
  return query;
}

TimingQuery far(Random& random) {
  TimingQuery query = plain(random, any_kind(random));
  const double away = std::ldexp(1.0, random.integer(5, 40));
  for (std::size_t k = 0; k < 3; ++k) query.u_B[k] = away * query.v_A[k] + query.u_B[k];
  query.v_B = {0, 0, 0};
  return query;
}

TimingQuery near_static(Random& random) {
  TimingQuery query = plain(random, any_kind(random));
  query.v_B = query.v_A;
  const auto k = static_cast<std::size_t>(random.integer(0, 2));
  query.v_B[k] = std::nextafter(query.v_B[k], random.uniform(-9, 9));
  return query;
}

TimingQuery any_scale(Random& random) {
  const TimingQuery query = (random.bits() & 1U) != 0 ? plain(random, any_kind(random)) : any_graze(random);
  return scaled(query, random.integer(-960, 960), random.integer(-960, 960));
}

/// Every number with an exponent of its own.
TimingQuery wide(Random& random) {
  const auto number = [&] { return random.any_double(-1073, 1023); };
  TimingQuery query{any_kind(random), {}, {}, {}, {}, std::fabs(number())};
  for (std::size_t k = 0; k < 3; ++k) {
    query.u_A[k] = number();
    query.u_B[k] = number();
    query.v_A[k] = number();
    query.v_B[k] = number();
  }
  return query;
}

/// Integers below 2^10 in units of the smallest double.
TimingQuery subnormal(Random& random) {
  return scaled(integers(random), -1074, (random.bits() & 1U) != 0 ? -1074 : 0);
}

}  // namespace

TimingQuery plain(Random& random, Kind kind) {
  TimingQuery query{kind, in_cube(random, 2), in_cube(random, 2), in_cube(random, 1), in_cube(random, 1), 1};
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

std::vector<Stratum> all(std::uint64_t seed, int count) {
  const std::vector<std::pair<std::string, std::function<TimingQuery(Random&)>>> generators = {
      {"plain", [](Random& random) { return plain(random, any_kind(random)); }},
      {"graze", any_graze},
      {"touching", touching},
      {"taut", taut},
      {"integers", integers},
      {"tangent", tangent},
      {"offset_origin", offset_origin},
      {"far", far},
      {"near_static", near_static},
      {"any_scale", any_scale},
      {"wide", wide},
      {"subnormal", subnormal}};
  Random random(seed);
  std::vector<Stratum> strata;
  for (const auto& [name, generate] : generators) {
    Stratum stratum{name, {}};
    for (int i = 0; i < count; ++i) stratum.queries.push_back(generate(random));
    strata.push_back(stratum);
  }
  return strata;
}

}  // namespace tps::exact::strata

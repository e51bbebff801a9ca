#include "verify/exact/lifted_query.hpp"

#include <algorithm>
#include <limits>

#include "verify/exact/odd_multiple.hpp"

namespace tps::exact {
namespace {

int smallest_exponent(const Vec3& x, const Vec3& y) {
  int smallest = std::numeric_limits<int>::max();
  for (const double component : x) smallest = std::min(smallest, unit_of(component));
  for (const double component : y) smallest = std::min(smallest, unit_of(component));
  return smallest;
}

std::array<Integer, 3> lifted_difference(const Vec3& y, const Vec3& x, int unit) {
  std::array<Integer, 3> difference;
  for (std::size_t k = 0; k < 3; ++k) difference[k] = lifted(y[k], unit) - lifted(x[k], unit);
  return difference;
}

Integer dot(const std::array<Integer, 3>& x, const std::array<Integer, 3>& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

}  // namespace

int unit_of(double x) {
  return odd_multiple(x).exponent;
}

Integer lifted(double x, int unit) {
  const OddMultiple d = odd_multiple(x);
  if (d.mantissa == 0) return 0;
  return Integer(d.mantissa) << static_cast<unsigned>(d.exponent - unit);
}

std::uint64_t bits_of(const Integer& x) {
  return x == 0 ? 0 : msb(abs(x)) + 1;
}

LiftUnits units_of(const TimingQuery& query) {
  // At rest every power of two divides every velocity; any will do that sums of exponents can bear.
  const int speed = smallest_exponent(query.v_A, query.v_B);
  // An image counts whole edges.
  const int of_box = is_at_home(query) ? std::numeric_limits<int>::max() : smallest_exponent(query.edges, {});
  return {std::min({smallest_exponent(query.u_A, query.u_B), unit_of(query.L), of_box}),
          speed == std::numeric_limits<int>::max() ? 0 : speed};
}

LiftUnits common_units(const LiftUnits& first, const LiftUnits& second) {
  return {std::min(first.length, second.length), std::min(first.speed, second.speed)};
}

LiftedQuadratic lifted_quadratic(const TimingQuery& query, const LiftUnits& units) {
  std::array<Integer, 3> r = lifted_difference(query.u_B, query.u_A, units.length);
  for (std::size_t k = 0; k < 3; ++k) {
    if (query.image[k] != 0) r[k] += lifted(query.image[k], 0) * lifted(query.edges[k], units.length);
  }
  const std::array<Integer, 3> v = lifted_difference(query.v_B, query.v_A, units.speed);
  const Integer L = lifted(query.L, units.length);
  const Integer a = dot(v, v);
  const Integer h = dot(r, v);
  const Integer c = dot(r, r) - L * L;
  const Integer D = h * h - a * c;
  return {a, h, c, D, units.length - units.speed};
}

Sign sign_of(const Integer& x) {
  const int sign = x.sign();
  return sign < 0 ? Sign::negative : sign > 0 ? Sign::positive : Sign::zero;
}

Verdict verdict_of(Kind kind, const LiftedQuadratic& quadratic) {
  return *decide(kind, sign_of(quadratic.h), sign_of(quadratic.c), sign_of(quadratic.D));
}

std::uint64_t largest_bits(const LiftedQuadratic& quadratic) {
  return std::max({bits_of(quadratic.a), bits_of(quadratic.h), bits_of(quadratic.c), bits_of(quadratic.D)});
}

}  // namespace tps::exact

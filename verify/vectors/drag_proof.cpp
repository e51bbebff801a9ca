#include "verify/vectors/drag_proof.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "verify/exact/drag_time.hpp"
#include "verify/exact/rounded_drag_time.hpp"

namespace tps::vectors {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// −1, 0, +1: x lies before, at, after t(s).
int side_of(double gamma, double s, const Dyadic& x) {
  switch (exact::compare_drag_time(gamma, dyadic(s), x)) {
    case exact::Sign::positive:
      return -1;
    case exact::Sign::zero:
      return 0;
    case exact::Sign::negative:
      return 1;
    default:
      throw std::invalid_argument("2^13 bits of the logarithm do not tell the time from a neighbour");
  }
}

TimeBracket bracket(double gamma, double s) {
  const exact::DragTime time = exact::rounded_drag_time(gamma, s);
  const bool beyond = std::isinf(time.t) || side_of(gamma, s, dyadic(time.t)) > 0;
  const double lo = s > 0 && beyond ? std::nextafter(time.t, 0.0) : time.t;
  const double hi = s > 0 && !beyond ? std::nextafter(time.t, kInfinity) : time.t;
  const auto side = [&](double x, double y) { return side_of(gamma, s, exact::middle_of(x, y)); };
  const TimeBracket found{lo, hi, time.t, side(lo, lo), side(hi, hi), side(lo, hi)};
  const bool lo_is_nearest = found.sign_mid >= 0;
  if (lo != hi && (found.sign_lo >= 0 || found.sign_hi <= 0 || lo_is_nearest != (time.t == lo)))
    throw std::logic_error("the sides of the neighbours contradict the rounded time");
  return found;
}

/// In long double: a size.
double condition_of(double gamma, double s) {
  const long double z = static_cast<long double>(gamma) * s;
  return static_cast<double>(z / ((1 - z) * -std::log1p(-z)));
}

}  // namespace

DragProof prove_drag_time(double gamma, double s) {
  DragProof proof{dyadic_text(dyadic(gamma) * dyadic(s)), std::nullopt, std::nullopt};
  if (!exact::drag_clock_is_reached(gamma, s)) return proof;
  proof.bracket = bracket(gamma, s);
  if (s > 0) proof.condition = condition_of(gamma, s);
  return proof;
}

}  // namespace tps::vectors

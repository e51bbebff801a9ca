#include "verify/exact/modular_query.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "verify/exact/lifted_query.hpp"
#include "verify/exact/refined_root.hpp"

namespace tps::exact {
namespace {

using Vector = std::array<ModularInteger, 3>;
using ShortVector = std::array<ShortInteger, 3>;

Vector difference(const Vec3& y, const Vec3& x, int unit) {
  Vector all;
  for (std::size_t k = 0; k < 3; ++k) all[k] = ModularInteger::difference(y[k], x[k], unit);
  return all;
}

ModularInteger dot(const Vector& x, const Vector& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}
ModularInteger dot(const ShortVector& x, const ShortVector& y) {
  return ModularInteger::product(x[0], y[0]) + ModularInteger::product(x[1], y[1]) +
         ModularInteger::product(x[2], y[2]);
}

template <typename Parts>
ModularQuadratic quadratic_of(const Parts& r, const Parts& v, const ModularInteger& L_squared,
                              const LiftUnits& units) {
  ModularQuadratic q{dot(v, v), dot(r, v), dot(r, r) - L_squared, {}, units.length - units.speed};
  q.D = q.h * q.h - q.a * q.c;
  return q;
}

/// Whether a number that is `x` up to `error` leaves room for its sign, in units of 2^unit. REQUIRES finite
/// ones.
bool fits(double x, double error, int unit) {
  constexpr int kFractionBits = 52, kBias = 1022;  // the number is less than 2^(exponent − bias)
  const auto bits = std::bit_cast<std::uint64_t>(std::fabs(x) + error);
  return static_cast<int>(bits >> kFractionBits) - kBias <= unit + ModularInteger::kMostBits - 1;
}

bool fits(const Coefficients& bounds, const LiftUnits& units) {
  const int of_h = units.length + units.speed;
  return fits(2 * bounds.a, 0, 2 * units.speed) && fits(bounds.h, bounds.h_error, of_h) &&
         fits(bounds.c, bounds.c_error, 2 * units.length) && fits(bounds.D, bounds.D_error, 2 * of_h);
}

/// A query that means B itself, whose numbers are taken apart once for both units and differences.
class ShortQuery {
 public:
  /// REQUIRES v ≠ 0.
  explicit ShortQuery(const TimingQuery& query) : L_(odd_multiple(query.L)) {
    units_ = {L_.exponent, std::numeric_limits<int>::max()};
    for (std::size_t k = 0; k < 3; ++k) {
      u_A_[k] = odd_multiple(query.u_A[k]);
      u_B_[k] = odd_multiple(query.u_B[k]);
      v_A_[k] = odd_multiple(query.v_A[k]);
      v_B_[k] = odd_multiple(query.v_B[k]);
      units_.length = std::min({units_.length, u_A_[k].exponent, u_B_[k].exponent});
      units_.speed = std::min({units_.speed, v_A_[k].exponent, v_B_[k].exponent});
    }
  }

  /// Those of units_of.
  const LiftUnits& units() const { return units_; }
  /// Nothing where a difference is not short.
  std::optional<ModularQuadratic> quadratic() const {
    ShortVector r, v;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto r_k = short_difference(u_B_[k], u_A_[k], units_.length);
      const auto v_k = short_difference(v_B_[k], v_A_[k], units_.speed);
      if (!r_k || !v_k) return std::nullopt;
      r[k] = *r_k;
      v[k] = *v_k;
    }
    const auto L = short_difference(L_, {}, units_.length);
    if (!L) return std::nullopt;
    return quadratic_of(r, v, ModularInteger::product(*L, *L), units_);
  }

 private:
  std::array<OddMultiple, 3> u_A_, u_B_, v_A_, v_B_;
  OddMultiple L_;
  LiftUnits units_;
};

Sign sign_of(const ModularInteger& x) {
  const int sign = x.sign();
  return sign < 0 ? Sign::negative : sign > 0 ? Sign::positive : Sign::zero;
}

DoubleWord in_double_words(const ModularInteger& x) {
  if (x.sign() == 0) return {0, 0};
  return x.sign() < 0 ? -x.magnitude() : x.magnitude();
}

/// √x to 5u²: one Newton step from the root of the high part (docs/exact.md, "Integers of 256 bits").
/// REQUIRES x > 0.
TPS_IN_EVERY_COPY DoubleWord square_root(DoubleWord x) {
  const double root = std::sqrt(x.hi);
  const DoubleWord rest = x - two_product(root, root);
  return fast_two_sum(root, rest.hi / (2 * root));
}

/// x/y to 8u², as a first quotient and that of the rest.
TPS_IN_EVERY_COPY RefinedTime quotient(DoubleWord x, DoubleWord y) {
  const double first = x.hi / y.hi;
  const DoubleWord rest = x - y * first;
  return {first, rest.hi / y.hi, 0};
}

}  // namespace

std::optional<ModularQuadratic> modular_quadratic(const TimingQuery& query, const Coefficients& bounds) {
  if (!bounds.in_range) return std::nullopt;
  if (is_at_home(query)) {
    const ShortQuery parts(query);
    if (!fits(bounds, parts.units())) return std::nullopt;
    if (const auto quadratic = parts.quadratic()) return quadratic;
  }
  const LiftUnits units = units_of(query);
  if (!fits(bounds, units)) return std::nullopt;
  Vector r = difference(query.u_B, query.u_A, units.length);
  for (std::size_t k = 0; k < 3; ++k) {
    if (query.image[k] == 0) continue;
    r[k] = r[k] +
           ModularInteger::lifted(query.image[k], 0) * ModularInteger::lifted(query.edges[k], units.length);
  }
  const ModularInteger L = ModularInteger::lifted(query.L, units.length);
  return quadratic_of(r, difference(query.v_B, query.v_A, units.speed), L * L, units);
}

Verdict verdict_of(Kind kind, const ModularQuadratic& q) {
  return *decide(kind, sign_of(q.h), sign_of(q.c), sign_of(q.D));
}

TPS_WITH_FMA std::optional<double> rounded_time(Kind kind, Verdict verdict, const ModularQuadratic& q) {
  const DoubleWord a = in_double_words(q.a), h = in_double_words(q.h), c = in_double_words(q.c);
  RefinedTime time{};
  if (verdict == Verdict::turning) {
    time = quotient(-h, a);
  } else {
    const DoubleWord root = q.D.sign() > 0 ? square_root(in_double_words(q.D)) : DoubleWord{0, 0};
    const bool adds = kind != Kind::block && h.hi <= 0;
    const DoubleWord sum = (h.hi > 0 ? h : -h) + root;  // of one sign: nothing cancels
    time = adds ? quotient(sum, a) : quotient(c.hi > 0 ? c : -c, sum);
  }
  constexpr double kError = 32 * unit_roundoff * unit_roundoff;
  time.error = kError * time.t;
  // So far from the ends of the range nothing is lost by the power of two.
  if (!(std::ldexp(time.t, q.time_exponent) > 0x1p-800 && std::ldexp(time.t, q.time_exponent) < 0x1p800))
    return std::nullopt;
  const std::optional<double> rounded = time.rounded();
  if (!rounded) return std::nullopt;
  return std::ldexp(*rounded, q.time_exponent);
}

}  // namespace tps::exact

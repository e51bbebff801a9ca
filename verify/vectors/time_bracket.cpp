#include "verify/vectors/time_bracket.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "verify/exact/lifted_query.hpp"
#include "verify/exact/plane_time.hpp"
#include "verify/exact/rounded_time.hpp"

namespace tps::vectors {
namespace {

using exact::Integer;
using exact::LiftedQuadratic;
using exact::Verdict;

/// m 2^e.
struct DyadicTime {
  Integer m;
  int e;
};

DyadicTime dyadic_time(double x) {
  if (std::isinf(x)) return {1, 1024};
  int e = 0;
  const double significand = std::frexp(x, &e);
  return {Integer(static_cast<std::int64_t>(std::ldexp(significand, 53))), e - 53};
}

DyadicTime midpoint(const DyadicTime& x, const DyadicTime& y) {
  const int e = std::min(x.e, y.e);
  return {(x.m << static_cast<unsigned>(x.e - e)) + (y.m << static_cast<unsigned>(y.e - e)), e - 1};
}

int sign(const Integer& x) {
  return x.sign();
}

/// The polynomial whose zero is the time, and which of its zeros.
class Branch {
 public:
  Branch(exact::Kind kind, Verdict verdict, const LiftedQuadratic& q)
      : q_(q),
        linear_(verdict == Verdict::turning || kind == exact::Kind::plane),
        larger_(kind == exact::Kind::tether) {}

  int sign_at(const DyadicTime& x) const {
    const auto [m, up, down] = lifted(x);
    if (linear_) return sign((q_.a * m << up) + (q_.h << down));
    return sign((q_.a * m * m << 2 * up) + (q_.h * m << (up + down + 1)) + (q_.c << 2 * down));
  }

  /// −1, 0, +1: x lies before, at, after the time.
  int side_of(const DyadicTime& x) const {
    const int value = sign_at(x);
    if (linear_) return value;
    const auto [m, up, down] = lifted(x);
    const int slope = sign((q_.a * m << up) + (q_.h << down));
    if (larger_) return slope < 0 ? -1 : value;
    return slope >= 0 ? 1 : -value;
  }

 private:
  /// x = m 2^up / 2^down in the quadratic's unit of time; one of the two is 0.
  struct Lifted {
    Integer m;
    unsigned up, down;
  };
  Lifted lifted(const DyadicTime& x) const {
    const int shift = x.e - q_.time_exponent;
    return {x.m, static_cast<unsigned>(std::max(shift, 0)), static_cast<unsigned>(std::max(-shift, 0))};
  }

  const LiftedQuadratic& q_;
  bool linear_, larger_;
};

TimeBracket bracket(const Branch& branch, double nearest) {
  const int side = branch.side_of(dyadic_time(nearest));
  const bool beyond = std::isinf(nearest) || side > 0;
  const double lo = beyond ? std::nextafter(nearest, 0.0) : nearest;
  const double hi = side < 0 && !beyond ? std::nextafter(nearest, HUGE_VAL) : nearest;
  const DyadicTime mid = midpoint(dyadic_time(lo), dyadic_time(hi));
  const int mid_side = branch.side_of(mid);
  const bool lo_is_even = std::bit_cast<std::uint64_t>(lo) % 2 == 0;
  const bool lo_is_nearest = mid_side > 0 || (mid_side == 0 && lo_is_even);
  const bool exact = lo == hi;
  const bool enclosed = exact || (branch.side_of(dyadic_time(lo)) < 0 &&
                                  (std::isinf(hi) || branch.side_of(dyadic_time(hi)) > 0));
  if (!enclosed || (!exact && (nearest == lo) != lo_is_nearest)) {
    throw std::logic_error("the signs of the polynomial contradict the rounded time");
  }
  return {
      lo, hi, nearest, branch.sign_at(dyadic_time(lo)), branch.sign_at(dyadic_time(hi)), branch.sign_at(mid)};
}

std::string text(const Integer& x, int exponent) {
  if (x == 0) return "0x0p+0";
  return (x < 0 ? "-0x" : "0x") + abs(x).str(0, std::ios_base::hex) + (exponent < 0 ? "p" : "p+") +
         std::to_string(exponent);
}

void check_filter(Verdict verdict, const exact::TimingAnswer& filtered) {
  if (filtered.verdict != verdict) throw std::logic_error("a filter's verdict contradicts the integers");
}

TimingProof prove_plane(const exact::TimingQuery& query) {
  const exact::LiftUnits units = exact::units_of(query);
  const exact::LiftedPlane plane = exact::lifted_plane(query, units);
  const Verdict verdict = exact::is_static(query) ? Verdict::static_pair : exact::plane_verdict_of(plane);
  TimingProof proof{verdict,
                    text(0, 0),
                    text(-plane.w, units.speed + plane.unit),
                    text(-plane.gap, units.length + plane.unit),
                    plane.w == 0 ? 0 : 1,
                    std::nullopt};
  exact::Counters counters;
  const exact::TimingAnswer filtered = exact::rounded_time(query, counters);
  check_filter(verdict, filtered);
  if (verdict == Verdict::hit) {
    const LiftedQuadratic line{-plane.w, -plane.gap, 0, 0, units.length - units.speed};
    proof.bracket = bracket(Branch(query.kind, verdict, line), *filtered.t);
  }
  return proof;
}

}  // namespace

std::string dyadic_text(const Dyadic& x) {
  return text(Integer(x.digits), static_cast<int>(x.exponent));
}

TimingProof prove(const exact::TimingQuery& query) {
  if (query.kind == exact::Kind::plane) return prove_plane(query);
  const exact::LiftUnits units = exact::units_of(query);
  const LiftedQuadratic q = exact::lifted_quadratic(query, units);
  const Verdict verdict = exact::is_static(query) ? Verdict::static_pair : exact::verdict_of(query.kind, q);
  TimingProof proof{verdict,
                    text(q.a, 2 * units.speed),
                    text(q.h, units.length + units.speed + 1),
                    text(q.c, 2 * units.length),
                    sign(q.D),
                    std::nullopt};
  exact::Counters counters;
  const exact::TimingAnswer filtered = exact::rounded_time(query, counters);
  check_filter(verdict, filtered);
  if (exact::occurs(verdict) && !exact::at_once(verdict)) {
    proof.bracket = bracket(Branch(query.kind, verdict, q), *filtered.t);
  }
  return proof;
}

std::optional<double> condition(const exact::TimingQuery& query, const TimingProof& proof) {
  if (!proof.bracket || std::isinf(proof.bracket->nearest) || proof.bracket->nearest == 0)
    return std::nullopt;
  using Wide = long double;  // its exponents hold every product here
  if (query.kind == exact::Kind::plane) {
    Wide gap = -Wide(query.L), gap_terms = query.L, w = 0, w_terms = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Wide of_r = query.normal[k] * (Wide(query.u_B[k]) - Wide(query.u_A[k]));
      const Wide of_v = query.normal[k] * (Wide(query.v_B[k]) - Wide(query.v_A[k]));
      gap += of_r, gap_terms += std::fabs(of_r);
      w += of_v, w_terms += std::fabs(of_v);
    }
    const Wide cond = gap_terms / std::fabs(gap) + w_terms / std::fabs(w);
    return std::isfinite(cond) ? std::optional(static_cast<double>(cond)) : std::nullopt;
  }
  Wide H = 0, M = Wide(query.L) * Wide(query.L);
  for (std::size_t k = 0; k < 3; ++k) {
    const Wide r = Wide(query.u_B[k]) - Wide(query.u_A[k]);
    const Wide v = Wide(query.v_B[k]) - Wide(query.v_A[k]);
    H += std::fabs(r * v);
    M += r * r;
  }
  // Each from its integer, so that nothing has cancelled, and a time that underflows is not that of a double.
  const exact::LiftUnits units = exact::units_of(query);
  const LiftedQuadratic q = exact::lifted_quadratic(query, units);
  const auto lowered = [](const Integer& x, int unit) { return std::ldexp(x.convert_to<Wide>(), unit); };
  const Wide a = lowered(q.a, 2 * units.speed), c = lowered(q.c, 2 * units.length);
  const Wide h = lowered(q.h, units.length + units.speed);
  if (proof.verdict == Verdict::turning) return static_cast<double>(H / std::fabs(h));
  const Wide root = std::ldexp(std::sqrt(q.D.convert_to<Wide>()), units.length + units.speed);
  const Wide towards = std::fabs(h) + root;
  const bool is_by_a = query.kind == exact::Kind::tether && h <= 0;
  const Wide t = is_by_a ? towards / a : std::fabs(c) / towards;
  return static_cast<double>((a * t * t + 2 * H * t + M) / (2 * t * root));
}

}  // namespace tps::vectors

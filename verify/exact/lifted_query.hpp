// Stage 3: the query as integers. Lengths are integers times one power of two, velocities times another;
// a, h, c, D are then integers, and every sign is exact. Heavy header: only sources of this folder include
// it.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>

#include "verify/exact/timing_query.hpp"
#include "verify/exact/verdict.hpp"

namespace tps::exact {

/// Without expression templates: `auto` and `?:` then mean what they say. Up to 1024 bits nothing is
/// allocated.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<1024>,
                                              boost::multiprecision::et_off>;

/// The two units, as powers of two: lengths are multiples of 2^length, velocities of 2^speed.
struct LiftUnits {
  int length, speed;
};

/// The largest powers of two that divide every length and every velocity of the query; 1 for velocities that
/// are all zero.
/// REQUIRES a valid query.
LiftUnits units_of(const TimingQuery& query);

/// The units that serve both.
LiftUnits common_units(const LiftUnits& first, const LiftUnits& second);

/// The quadratic a t² + 2 h t + c = 0 in integers, with t in units of 2^time_exponent.
struct LiftedQuadratic {
  Integer a, h, c, D;
  int time_exponent;
};

/// Exactly the query's quadratic. REQUIRES units that divide the query's numbers.
LiftedQuadratic lifted_quadratic(const TimingQuery& query, const LiftUnits& units);

/// The largest n such that 2^n divides x; the largest int for 0.
int unit_of(double x);

/// x / 2^unit. REQUIRES unit ≤ unit_of(x).
Integer lifted(double x, int unit);

Sign sign_of(const Integer& x);

/// The verdict of the quadratic. REQUIRES a ≠ 0.
Verdict verdict_of(Kind kind, const LiftedQuadratic& quadratic);

std::uint64_t bits_of(const Integer& x);

/// Bits of the largest of a, h, c, D.
std::uint64_t largest_bits(const LiftedQuadratic& quadratic);

}  // namespace tps::exact

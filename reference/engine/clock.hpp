// Time since the start of a run, to twice the precision of the scalar.
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

#include "reference/equations/dyadic.hpp"

namespace tps {

/// A time as an unevaluated sum hi + lo with hi = fl(hi + lo).
///
/// Why not one number: in a long run dt ≪ t, and fl(t + dt) would move the event by up to an ulp of t. With
/// the sum, an event at t ≈ 2^40 is placed as finely as one at t ≈ 1 in plain arithmetic. Times are offsets
/// from the scene's start_time, which itself enters no computation.
template <typename Scalar>
struct Time {
  Scalar hi = Scalar(0);
  Scalar lo = Scalar(0);

  static Time never() { return {std::numeric_limits<Scalar>::infinity(), Scalar(0)}; }

  friend bool operator==(const Time& a, const Time& b) { return a.hi == b.hi && a.lo == b.lo; }
  friend bool operator<(const Time& a, const Time& b) { return a.hi < b.hi || (a.hi == b.hi && a.lo < b.lo); }
  friend bool operator<=(const Time& a, const Time& b) { return !(b < a); }
};

/// The sum hi + lo with hi the nearest to it, for |lo| of the size of an ulp of hi.
///
/// One step suffices where subtraction rounds to nearest. Boost 1.74's cpp_bin_float rounds it to within 0.75
/// ulp only: h − 0.4 ulp(h) is h − ulp(h) there, which would leave hi = h − ulp, lo = +0.6 ulp, a second
/// spelling of the same time. Its additions do round to nearest, so that a second step upwards puts that
/// right. For other types it changes nothing.
template <typename Scalar>
Time<Scalar> normalised(const Scalar& hi, const Scalar& lo) {
  const Scalar first = hi + lo;
  const Scalar rest = lo - (first - hi);
  if (!(rest > Scalar(0))) return {first, rest};
  const Scalar second = first + rest;
  return {second, rest - (second - first)};
}

/// t + dt: exact addition of hi and dt (Knuth's TwoSum), lo added once, normalised.
/// Error: at most 2u² (|t| + |dt|), u the largest relative error of an addition or subtraction.
template <typename Scalar>
Time<Scalar> after(const Time<Scalar>& t, const Scalar& dt) {
  const Scalar sum = t.hi + dt;
  if (sum == std::numeric_limits<Scalar>::infinity()) return Time<Scalar>::never();
  const Scalar part = sum - t.hi;
  const Scalar rest = (t.hi - (sum - part)) + (dt - part) + t.lo;
  return normalised<Scalar>(sum, rest);
}

/// x + y = sum + rest exactly, where the scalar's operations round to nearest (Knuth's TwoSum).
template <typename Scalar>
Time<Scalar> two_sum(const Scalar& x, const Scalar& y) {
  const Scalar sum = x + y;
  const Scalar part = sum - x;
  return {sum, (x - (sum - part)) + (y - part)};
}

namespace detail {

/// elapsed() by integers. Apart, so that the rest of it is short enough to stand where it is used.
template <typename Scalar>
[[gnu::noinline]] Scalar exactly_elapsed(const Time<Scalar>& earlier, const Time<Scalar>& later) {
  return nearest<Scalar>((dyadic(later.hi) - dyadic(earlier.hi)) + (dyadic(later.lo) - dyadic(earlier.lo)));
}

}  // namespace detail

/// later − earlier, rounded to the scalar. REQUIRES both finite.
///
/// For float, double and long double this is the number nearest to the exact difference, to even where there
/// are two: a definition that does not depend on how it is computed. The differences of the his and of the
/// los are each exact as two numbers; their largest part and the rest are added once. Mostly the rest is
/// exact, too (as `lo`s have few bits, it often is half an ulp of the result, exactly). Else it errs by less
/// than `doubt`; where both ends of that doubt round to one number, that is the nearest (Ziv), and else
/// integers decide. For scalars of software, whose subtraction errs by up to 0.75 ulp, it is within an ulp of
/// the exact difference.
template <typename Scalar>
Scalar elapsed(const Time<Scalar>& earlier, const Time<Scalar>& later) {
  using std::abs;
  const Time<Scalar> large = two_sum<Scalar>(later.hi, -earlier.hi);
  const Time<Scalar> small = two_sum<Scalar>(later.lo, -earlier.lo);
  const Scalar rest = (large.lo + small.hi) + small.lo;
  if constexpr (!std::is_floating_point_v<Scalar>) return large.hi + rest;
  if (small.lo == Scalar(0) && two_sum<Scalar>(large.lo, small.hi).lo == Scalar(0)) return large.hi + rest;
  const Scalar doubt = Scalar(2) * std::numeric_limits<Scalar>::epsilon() * (abs(large.lo) + abs(small.hi));
  const Scalar least = large.hi + (rest - doubt);
  const Scalar most = large.hi + (rest + doubt);
  if (least == most) return least;
  return detail::exactly_elapsed<Scalar>(earlier, later);
}

}  // namespace tps

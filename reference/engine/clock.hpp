// Time since the start of a run, to twice the precision of the scalar.
#pragma once

#include <limits>

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

/// later − earlier, rounded to the scalar. REQUIRES both finite.
///
/// The difference of the his is exact (TwoSum), so that the one rounding that counts is the last one: the
/// result is the nearest to the exact difference, or the next after it where that difference is within a
/// relative 4u² of the middle between the two.
template <typename Scalar>
Scalar elapsed(const Time<Scalar>& earlier, const Time<Scalar>& later) {
  const Scalar difference = later.hi - earlier.hi;
  const Scalar part = later.hi - difference;
  const Scalar rest = (later.hi - (difference + part)) + (part - earlier.hi);
  return difference + (rest + (later.lo - earlier.lo));
}

}  // namespace tps

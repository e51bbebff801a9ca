// A first look at a pair in plain doubles: whether it stayed clear of both of its limits by far more than
// they can err (docs/check.md, "Range of the filters").
#pragma once

#include <algorithm>
#include <cmath>

#include "verify/trace_check/number.hpp"

namespace tps::check {

/// A particle at a moment, in doubles: how it came there in a straight line.
struct StraightLine {
  const double* position;  ///< where the line begins, three numbers
  const double* velocity;
  double duration;  ///< of the line so far
};

/// What limits a pair has, in doubles; absent ones are negative.
struct LimitsInDoubles {
  double inner = -1, outer = -1;
};

/// Whether two particles, while both flew, kept more than `share` of the squares of the lengths concerned
/// away from their limits. `clock` is how much each duration may be off beyond its own rounding. False says
/// nothing.
///
/// Law: true implies that in real arithmetic, too, the pair is inside of its outer and outside of its inner
/// limit all the time, by half of that share, whatever the inputs. REQUIRES share ≥ 2^-40.
inline bool is_clear(const StraightLine& a, const StraightLine& b, const LimitsInDoubles& limits,
                     double clock, double share) {
  const double together = std::min(a.duration, b.duration);
  double rr = 0, rd = 0, dd = 0, size = 0, speed = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double way_a = a.velocity[k] * a.duration;
    const double way_b = b.velocity[k] * b.duration;
    const double r = (b.position[k] + way_b) - (a.position[k] + way_a);
    const double d = (b.velocity[k] - a.velocity[k]) * together;
    rr += r * r;
    rd += r * d;
    dd += d * d;
    size += (std::fabs(a.position[k]) + std::fabs(b.position[k])) + (std::fabs(way_a) + std::fabs(way_b));
    speed += std::fabs(a.velocity[k]) + std::fabs(b.velocity[k]);
  }
  size += 0x1p42 * clock * speed;
  constexpr double kLargest = 0x1p200;
  constexpr double kLongest = 0x1p500;
  // Written so that what is no number is out of range.
  if (!(size < kLargest && size > 1 / kLargest && a.duration < kLongest && b.duration < kLongest))
    return false;
  const double before = rr - (2 * rd - dd);  // squared distance when the flight began
  const double nearest = rd > 0 && rd < dd ? rr - rd * (rd / dd) : std::min(rr, before);
  const auto error = [&](double L) { return share * (size * size + L * L); };
  if (limits.inner >= 0 && !(nearest - limits.inner * limits.inner > error(limits.inner))) return false;
  return !(limits.outer >= 0) || std::max(rr, before) - limits.outer * limits.outer < -error(limits.outer);
}

}  // namespace tps::check

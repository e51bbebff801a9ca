// A first look at pairs in plain doubles: whether they stayed clear of their limits by far more than they can
// err (docs/check.md, "Range of the filters").
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace tps::check {

/// A particle at a moment, in doubles: how it came there in a straight line.
struct StraightLine {
  const double* position;  ///< where the line begins, three numbers
  const double* velocity;
  double duration;  ///< of the line so far
  double size;      ///< Σ |x_k|; not a number: the place is uncertain, so that nobody is clear of it
  double speed;     ///< Σ |v_k|
};

/// What limits a pair has, in doubles; absent ones are negative.
struct LimitsInDoubles {
  double inner = -1, outer = -1;
};

/// One particle at a moment, beside others.
class FirstLook {
 public:
  /// `clock` is how much each duration may be off beyond its own rounding; `edges` are those of a periodic
  /// box, 0 along an open axis, or null. REQUIRES share ≥ 2^-40.
  FirstLook(const StraightLine& line, double clock, double share, const double* edges = nullptr)
      : a_(line), blur_of_speed_(0x1p42 * clock), share_(share) {
    for (std::size_t k = 0; k < 3; ++k) {
      place_[k] = a_.position[k] + a_.velocity[k] * a_.duration;
      edges_[k] = edges == nullptr ? 0 : edges[k];
      if (edges_[k] > 0) half_box_ = std::min(half_box_, 0.49 * edges_[k]);
    }
    size_ = a_.size + a_.speed * std::fabs(a_.duration) + blur_of_speed_ * a_.speed;
  }

  /// Whether two particles, while both flew, kept more than `share` of the squares of the lengths concerned
  /// away from their limits; in a periodic box every image from an inner limit. False says nothing.
  ///
  /// Law: true implies that in real arithmetic, too, the pair is inside of its outer and outside of its inner
  /// limit all the time, by half of that share, whatever the inputs.
  bool is_clear(const StraightLine& b, const LimitsInDoubles& limits) const {
    const double together = std::min(a_.duration, b.duration);
    std::array<double, 3> r, d;
    for (std::size_t k = 0; k < 3; ++k) {
      r[k] = (b.position[k] + b.velocity[k] * b.duration) - place_[k];
      d[k] = (b.velocity[k] - a_.velocity[k]) * together;
    }
    const double dd = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    const double size = size_ + (b.size + b.speed * std::fabs(b.duration) + blur_of_speed_ * b.speed);
    constexpr double kLargest = 0x1p200;
    constexpr double kLongest = 0x1p500;
    // Written so that what is no number is out of range.
    if (!(size < kLargest && size > 1 / kLargest && a_.duration < kLongest && b.duration < kLongest))
      return false;
    if (half_box_ < HUGE_VAL && !is_of_one_image(r, dd, limits, size)) return false;
    const double rr = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
    const double L = limits.inner;
    const double inner_error = share_ * (size * size + L * L);
    // |r|² > 2(L² + |d|² + e) leaves (|r| − |d|)² > L² + e: most pairs are as far as that.
    if (limits.outer < 0 && (L < 0 || rr > 2 * (L * L + dd + inner_error))) return true;
    const double rd = r[0] * d[0] + r[1] * d[1] + r[2] * d[2];
    const double before = rr - (2 * rd - dd);  // squared distance when the flight began
    const double nearest = rd > 0 && rd < dd ? rr - rd * (rd / dd) : std::min(rr, before);
    if (L >= 0 && !(nearest - L * L > inner_error)) return false;
    if (!(limits.outer >= 0)) return true;
    const double outer_error = share_ * (size * size + limits.outer * limits.outer);
    return std::max(rr, before) - limits.outer * limits.outer < -outer_error;
  }

 private:
  /// Takes r to the nearest image. Whether the others stayed clear of it: one of their coordinates is half an
  /// edge at least, and so far they did not fly. A tether is of one image, which is not looked for here.
  bool is_of_one_image(std::array<double, 3>& r, double dd, const LimitsInDoubles& limits,
                       double size) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (edges_[k] > 0 && std::fabs(r[k]) > edges_[k] / 2)
        r[k] -= edges_[k] * std::floor(r[k] / edges_[k] + 0.5);
    }
    const double room = half_box_ - std::max(0.0, limits.inner);
    return limits.outer < 0 && room > 0 && dd < room * room && size < 0x1p40 * half_box_;
  }

  StraightLine a_;
  double blur_of_speed_, share_;
  std::array<double, 3> place_, edges_;
  double half_box_ = HUGE_VAL;  ///< a little less than half the shortest edge
  double size_;
};

}  // namespace tps::check

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
    Beside x = beside(b);
    if (!is_in_range(b, x.size)) return false;
    if (half_box_ < HUGE_VAL && !is_of_one_image(x.r, dot(x.d, x.d), limits, x.size)) return false;
    const double L = limits.inner;
    if (limits.outer < 0) return L < 0 || is_clear_of(x, L);
    if (L >= 0 && !is_clear_of(x, L)) return false;
    const double rr = dot(x.r, x.r);
    const double outer_error = share_ * (x.size * x.size + limits.outer * limits.outer);
    return std::max(rr, before(x, rr)) - limits.outer * limits.outer < -outer_error;
  }
  /// The same of a pair with an inner limit alone, in an open scene.
  [[gnu::always_inline]] bool is_clear_of_inner(const StraightLine& b, double L) const {
    const Beside x = beside(b);
    return is_in_range(b, x.size) && is_clear_of(x, L);
  }

  /// Law: true implies that in real arithmetic, too, the two flew apart all the time that both flew, r·v > 0
  /// at its beginning. REQUIRES an open scene.
  bool flew_apart(const StraightLine& b) const {
    const Beside x = beside(b);
    return is_in_range(b, x.size) && dot(x.r, x.d) - dot(x.d, x.d) > share_ * (x.size * x.size);
  }

 private:
  using Three = std::array<double, 3>;

  /// The distance vector now and the relative way while both flew, and the sum of what they are made of.
  struct Beside {
    Three r, d;
    double size;
  };

  static double dot(const Three& a, const Three& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  /// The squared distance when the flight began.
  static double before(const Beside& x, double rr) { return rr - (2 * dot(x.r, x.d) - dot(x.d, x.d)); }

  [[gnu::always_inline]] Beside beside(const StraightLine& b) const {
    const double together = std::min(a_.duration, b.duration);
    const auto place = [&](std::size_t k) {
      return (b.position[k] + b.velocity[k] * b.duration) - place_[k];
    };
    const auto way = [&](std::size_t k) { return (b.velocity[k] - a_.velocity[k]) * together; };
    return {{place(0), place(1), place(2)},
            {way(0), way(1), way(2)},
            size_ + (b.size + b.speed * std::fabs(b.duration) + blur_of_speed_ * b.speed)};
  }
  /// Written so that what is no number is out of range.
  bool is_in_range(const StraightLine& b, double size) const {
    constexpr double kLargest = 0x1p200;
    constexpr double kLongest = 0x1p500;
    return size < kLargest && size > 1 / kLargest && a_.duration < kLongest && b.duration < kLongest;
  }
  [[gnu::always_inline]] bool is_clear_of(const Beside& x, double L) const {
    const double rr = dot(x.r, x.r), dd = dot(x.d, x.d);
    const double error = share_ * (x.size * x.size + L * L);
    // |r|² > 2(L² + |d|² + e) leaves (|r| − |d|)² > L² + e: many pairs are as far as that.
    if (rr > 2 * (L * L + dd + error)) return true;
    const double rd = dot(x.r, x.d);
    const double nearest = rd > 0 && rd < dd ? rr - rd * (rd / dd) : std::min(rr, before(x, rr));
    return nearest - L * L > error;
  }

  /// Takes r to the nearest image. Whether the others stayed clear of it: one of their coordinates is half an
  /// edge at least, and so far they did not fly. A tether is of one image, which is not looked for here.
  bool is_of_one_image(Three& r, double dd, const LimitsInDoubles& limits, double size) const {
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

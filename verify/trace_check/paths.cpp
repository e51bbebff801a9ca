#include "verify/trace_check/paths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tps::check {
namespace {

double component(const Path& path, std::size_t k) {
  return k < 3 ? path.position[k] : path.velocity[k - 3];
}

double error_of(const Path& path, std::size_t k) {
  const double rounding = 0x1p-40 * std::fabs(component(path, k)) + std::numeric_limits<double>::denorm_min();
  return k < 3 ? rounding + path.error : rounding;
}

/// A part of the time ahead, never too small.
struct Span {
  double from, to;
  bool empty = false;

  /// Leaves the times at which r + v t ≤ L for some r ≥ r_low and v ≥ v_low.
  void narrow(double r_low, double v_low, double L) {
    const double outside = r_low - L;
    if (!(outside > 0)) {
      if (v_low > 0) to = std::min(to, -outside / v_low * (1 + 0x1p-40) + std::numeric_limits<double>::min());
      return;
    }
    if (v_low >= 0) empty = true;
    if (v_low < 0) from = std::max(from, outside / -v_low * (1 - 0x1p-40));
  }
};

}  // namespace

Paths::Paths(std::vector<Path> paths, double reach)
    : paths_(std::move(paths)), reach_(reach), leaf_of_(paths_.size()), done_(paths_.size(), false) {
  if (!paths_.empty()) make_box(0, paths_.size(), kNone);
}

/// The direction in which a box is widest, in units of what all paths spread over.
std::size_t Paths::widest(const Box& box) const {
  std::size_t result = 0;
  double largest = -1;
  for (std::size_t k = 0; k < 6; ++k) {
    const double share = (box.high[k] / 2 - box.low[k] / 2) / (boxes_[0].high[k] / 2 - boxes_[0].low[k] / 2);
    if (share > largest) {
      largest = share;
      result = k;
    }
  }
  return result;
}

std::size_t Paths::make_box(std::size_t begin, std::size_t end, std::size_t above) {
  const std::size_t n = boxes_.size();
  Box box{begin, end, above, end - begin, {}, {}};
  for (std::size_t k = 0; k < 6; ++k) {
    box.low[k] = HUGE_VAL;
    box.high[k] = -HUGE_VAL;
    for (std::size_t p = begin; p < end; ++p) {
      const double x = component(paths_[p], k);
      const double error = error_of(paths_[p], k);
      box.low[k] = std::min(box.low[k], x - error);
      box.high[k] = std::max(box.high[k], x + error);
    }
  }
  boxes_.push_back(box);
  if (end - begin <= kLeaf) {
    std::fill(leaf_of_.begin() + static_cast<std::ptrdiff_t>(begin),
              leaf_of_.begin() + static_cast<std::ptrdiff_t>(end), n);
    return n;
  }
  const std::size_t k = widest(box);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t p) { return paths_.begin() + static_cast<std::ptrdiff_t>(p); };
  std::nth_element(at(begin), at(middle), at(end), [k](const Path& a, const Path& b) {
    return std::pair(component(a, k), a.particle) < std::pair(component(b, k), b.particle);
  });
  const std::size_t left = make_box(begin, middle, n);
  const std::size_t right = make_box(middle, end, n);
  boxes_[n].left = left;
  boxes_[n].right = right;
  return n;
}

/// Whether in every coordinate some of a and some of b are within reach at one time. What is no number is.
bool Paths::can_be_near(const Box& a, const Box& b) const {
  Span span{0, duration_};
  for (std::size_t k = 0; k < 3; ++k) {
    span.narrow(b.low[k] - a.high[k], b.low[k + 3] - a.high[k + 3], reach_);
    span.narrow(a.low[k] - b.high[k], a.low[k + 3] - b.high[k + 3], reach_);
  }
  return !span.empty && !(span.from > span.to);
}

void Paths::each_near_pair(double duration, const Judge& judge) {
  duration_ = duration;
  if (!boxes_.empty()) visit(0, 0, judge);
}

/// Pairs of members of two boxes, or of one. Halves of one box come before pairs of the halves: those who are
/// near come first.
void Paths::visit(std::size_t a, std::size_t b, const Judge& judge) {
  const Box& first = boxes_[a];
  const Box& second = boxes_[b];
  if (first.open + second.open == 0 || (a != b && !can_be_near(first, second))) return;
  if (first.left == kNone && second.left == kNone) {
    visit_members(a, b, judge);
  } else if (a == b) {
    visit(first.left, first.left, judge);
    visit(first.right, first.right, judge);
    visit(first.left, first.right, judge);
  } else if (first.left == kNone || second.end - second.begin > first.end - first.begin) {
    visit(a, second.left, judge);
    visit(a, second.right, judge);
  } else {
    visit(first.left, b, judge);
    visit(first.right, b, judge);
  }
}

void Paths::visit_members(std::size_t a, std::size_t b, const Judge& judge) {
  for (std::size_t p = boxes_[a].begin; p < boxes_[a].end; ++p) {
    for (std::size_t q = a == b ? p + 1 : boxes_[b].begin; q < boxes_[b].end; ++q) {
      if (done_[p] && done_[q]) continue;
      if (judge(paths_[p].particle, paths_[q].particle)) continue;
      finish(p);
      finish(q);
    }
  }
}

void Paths::finish(std::size_t path) {
  if (done_[path]) return;
  done_[path] = true;
  for (std::size_t n = leaf_of_[path]; n != kNone; n = boxes_[n].above) --boxes_[n].open;
}

}  // namespace tps::check

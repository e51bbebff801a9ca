// When anchors expire: the next ones in a heap that a cache holds, later ones in no order.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace tps::check {

/// Hands out times in ascending order. Law: as one heap of them all, whatever the times.
class Expiries {
 public:
  struct Expiry {
    double t;
    int particle;
    std::uint32_t number;  ///< of the particle's anchors
    bool operator>(const Expiry& other) const {
      return std::tie(t, particle, number) > std::tie(other.t, other.particle, other.number);
    }
  };

  std::size_t size() const { return soon_.size() + later_.size(); }

  void push(const Expiry& expiry) {
    if (expiry.t < horizon_) {
      soon_.push(expiry);
    } else {
      later_.push_back(expiry);
    }
  }
  /// The earliest one, if it is at or before t; null otherwise.
  const Expiry* next(double t) {
    while (soon_.empty() && horizon_ <= t && !later_.empty()) look_further();
    return probably_next(t);
  }
  /// The one that next() gave. REQUIRES that it gave one, and nothing has been done since.
  void pop() { soon_.pop(); }
  /// The earliest one of the heap, if it is at or before t: most often it is what next() will give.
  const Expiry* probably_next(double t) const {
    return !soon_.empty() && soon_.top().t <= t ? &soon_.top() : nullptr;
  }

  void assign(std::vector<Expiry> all) {
    soon_ = {};
    later_ = std::move(all);
    horizon_ = -HUGE_VAL;
  }

 private:
  /// Makes a heap of about the earliest sixteenth of those later.
  void look_further() {
    std::array<double, 64> some{};
    const std::size_t step = later_.size() / some.size() + 1;
    std::size_t count = 0;
    for (std::size_t n = 0; n < later_.size(); n += step) some[count++] = later_[n].t;
    const auto sixteenth = some.begin() + static_cast<std::ptrdiff_t>(count / 16);
    std::nth_element(some.begin(), sixteenth, some.begin() + static_cast<std::ptrdiff_t>(count));
    horizon_ = std::nextafter(*sixteenth, HUGE_VAL);
    const auto first_soon = std::partition(later_.begin(), later_.end(),
                                           [this](const Expiry& expiry) { return !(expiry.t < horizon_); });
    for (auto each = first_soon; each != later_.end(); ++each) soon_.push(*each);
    later_.erase(first_soon, later_.end());
  }

  double horizon_ = -HUGE_VAL;
  std::priority_queue<Expiry, std::vector<Expiry>, std::greater<>> soon_;  ///< before the horizon
  std::vector<Expiry> later_;                                              ///< at it or behind
};

}  // namespace tps::check

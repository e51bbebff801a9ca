// What one particle has ahead: the first few events of its pairs, and when it has to look again.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "reference/engine/clock.hpp"

namespace tps {

/// With whom a particle has an event, and which one.
struct Partner {
  int particle;
  std::uint32_t revision;  ///< of the partner when this was predicted
  int effect;              ///< PairPredictor::kUnasked: known is only a time before which they do not meet
};

/// The earliest meetings of a particle, ascending; of doubles, two cache lines. Law: every live event of the
/// particle with a pair that has been asked is among them, at their time or later where it is unasked, or at
/// or after complete_until().
template <typename Scalar>
class alignas(sizeof(Scalar) == 8 ? 64 : alignof(Time<Scalar>)) Outlook {
 public:
  Time<Scalar> look = Time<Scalar>::never();  ///< when the particle may leave its region

  /// Asks memory for it.
  void prefetch() const {
    __builtin_prefetch(this);
    __builtin_prefetch(&partners_);
  }

  void clear() {
    count_ = 0;
    complete_until_ = Time<Scalar>::never();
  }
  const Time<Scalar>& complete_until() const { return complete_until_; }
  int count() const { return count_; }
  const Time<Scalar>& time(int n) const { return times_[at(n)]; }
  const Partner& partner(int n) const { return partners_[at(n)]; }

  /// The earliest of what is ahead: a meeting, the end of what is known, a look.
  const Time<Scalar>& due() const {
    const Time<Scalar>& known = count_ > 0 && times_[0] < complete_until_ ? times_[0] : complete_until_;
    return look < known ? look : known;
  }
  bool looks_first() const { return look < Time<Scalar>::never() && !(due() < look); }
  bool knows_first() const { return count_ > 0 && times_[0] <= complete_until_; }

  /// Takes up a meeting; the last one gives way where there is no room. A second one with a partner replaces
  /// the first.
  void add(const Time<Scalar>& time, const Partner& partner) {
    forget(partner.particle);
    if (complete_until_ < time) return;
    if (count_ == kRoom) {
      const Time<Scalar>& last = times_[kRoom - 1];
      complete_until_ = last < time ? time : last;
      if (last <= time) return;
      --count_;
    }
    int place = count_++;
    for (; place > 0 && time < times_[at(place - 1)]; --place) move(place - 1, place);
    times_[at(place)] = time;
    partners_[at(place)] = partner;
  }

  /// Drops meetings from the front while they are void. @return whether there were any.
  template <typename IsVoid>
  bool drop(IsVoid is_void) {
    int dropped = 0;
    while (dropped < count_ && is_void(partners_[at(dropped)])) ++dropped;
    count_ -= dropped;
    for (int n = 0; dropped > 0 && n < count_; ++n) move(n + dropped, n);
    return dropped > 0;
  }

  void forget(int particle) {
    int kept = 0;
    for (int n = 0; n < count_; ++n) {
      if (partners_[at(n)].particle == particle) continue;
      if (kept != n) move(n, kept);
      ++kept;
    }
    count_ = kept;
  }

 private:
  static constexpr int kRoom = 3;
  static std::size_t at(int n) { return static_cast<std::size_t>(n); }

  void move(int from, int to) {
    times_[at(to)] = times_[at(from)];
    partners_[at(to)] = partners_[at(from)];
  }

  Time<Scalar> complete_until_ = Time<Scalar>::never();
  std::array<Time<Scalar>, kRoom> times_;
  std::array<Partner, kRoom> partners_;
  int count_ = 0;
};

}  // namespace tps

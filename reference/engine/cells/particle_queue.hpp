// Which particle has something due first: a small heap of those that are due soon, and bins of time for the
// others.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "reference/engine/clock.hpp"
#include "reference/engine/large_pages.hpp"

namespace tps {

/// Every particle with the time at which it is due, or never().
///
/// Bins of equal width follow each other in time. Those that have been opened are in a heap, in which a
/// particle has one place; the others only say who may be in them. A particle that is put off or brought
/// forward is entered in its new bin, and its old entry is void: to move it costs one entry at the end of a
/// list, however many particles there are. What lies behind the last bin waits until all have been opened.
/// Law: a particle's bin is a function of its time that never decreases, so nobody who is not in the heap is
/// due before somebody in an opened bin.
///
/// Schedule: O(1) but for the heap of about a hundred. Memory: at most 4 entries a particle.
template <typename Scalar>
class ParticleQueue {
 public:
  struct Due {
    Time<Scalar> time;
    int particle;
  };

  /// Nobody is due.
  void reset(std::size_t particles) {
    heap_.clear();
    filed_.assign(particles, {Time<Scalar>::never(), kNowhere});
    bins_.clear();
    behind_.clear();
    opened_ = waiting_ = entries_ = 0;
    origin_ = per_width_ = 0;
  }

  /// REQUIRES at least one particle. Calls near(particles) with those who are due soon, before
  /// they are.
  template <typename Near>
  Due earliest(Near near) {
    while (heap_.empty() && waiting_ > 0) open_next(near);
    return heap_.empty() ? Due{Time<Scalar>::never(), 0} : heap_.front();
  }

  void schedule(int particle, const Time<Scalar>& time) {
    Filed& filed = filed_[index(particle)];
    if (filed.time == time) return;
    const bool comes_forward = time < filed.time;
    filed.time = time;
    const std::size_t bin = bin_of(time);
    if (filed.place >= 0) {
      const auto at = static_cast<std::size_t>(filed.place);
      if (bin < opened_) {
        if (comes_forward) {
          rise(at, {time, particle});
        } else {
          sink(at, {time, particle});
        }
        return;
      }
      take_out(at);
    } else if (filed.place != kNowhere) {
      if (filed.place == place_of(bin)) return;
      --waiting_;
    }
    file(particle, bin);
    if (entries_ > kEntriesPerParticle * filed_.size()) file_all_anew();
  }

  /// Appends the particles that are due at or before a time.
  template <typename Near>
  void due_until(const Time<Scalar>& latest, std::vector<int>& particles, Near near) {
    while (waiting_ > 0 && bin_of(latest) >= opened_) open_next(near);
    append_due(0, latest, particles);
    if (latest < Time<Scalar>::never()) return;
    for (std::size_t i = 0; i < filed_.size(); ++i) {
      if (filed_[i].place == kNowhere) particles.push_back(static_cast<int>(i));
    }
  }

 private:
  static constexpr std::size_t kBranches = 4;
  static constexpr std::size_t kPerBin = 64;
  static constexpr std::size_t kEntriesPerParticle = 4;
  static constexpr std::size_t kSample = 1024;

  /// Where a particle is: at its place in the heap, nowhere as it is never due, or in bin −2 − place.
  struct Filed {
    Time<Scalar> time;
    int place;
  };
  static constexpr int kNowhere = -1;
  static int place_of(std::size_t bin) { return -2 - static_cast<int>(bin); }
  static std::size_t index(int particle) { return static_cast<std::size_t>(particle); }

  /// Doubles for every scalar: each step of bin_of() is rounded in one direction of growth only.
  static double coarse(const Time<Scalar>& time) {
    return std::min(static_cast<double>(time.hi), std::numeric_limits<double>::max());
  }

  /// The bin of a time; the number of bins stands for all times behind them.
  std::size_t bin_of(const Time<Scalar>& time) const {
    const double bin = (coarse(time) - origin_) * per_width_;
    if (!(bin < static_cast<double>(bins_.size()))) return bins_.size();
    return bin > 0 ? static_cast<std::size_t>(bin) : 0;
  }

  /// Puts a particle that is in no list, nor in the heap, where its time belongs.
  void file(int particle, std::size_t bin) {
    Filed& filed = filed_[index(particle)];
    if (filed.time == Time<Scalar>::never()) {
      filed.place = kNowhere;
    } else if (bin < opened_) {
      heap_.push_back({});
      rise(heap_.size() - 1, {filed.time, particle});
    } else {
      filed.place = place_of(bin);
      (bin < bins_.size() ? bins_[bin] : behind_).push_back(particle);
      ++waiting_;
      ++entries_;
    }
  }

  /// Takes the next bin into the heap, or, where there is none, lays out new ones.
  template <typename Near>
  void open_next(Near near) {
    if (opened_ == bins_.size()) return file_all_anew();
    const std::size_t bin = opened_++;
    std::vector<int> entered = std::exchange(bins_[bin], {});
    entries_ -= entered.size();
    std::size_t kept = 0;
    for (std::size_t n = 0; n < entered.size(); ++n) {
      constexpr std::size_t kAhead = 16;
      if (n + kAhead < entered.size()) __builtin_prefetch(&filed_[index(entered[n + kAhead])]);
      if (filed_[index(entered[n])].place != place_of(bin)) continue;
      --waiting_;
      file(entered[n], bin);
      entered[kept++] = entered[n];
    }
    entered.resize(kept);
    near(entered);
  }

  /// New bins from the earliest of those that wait on, about kPerBin of them in each of the first ones.
  void file_all_anew() {
    std::vector<int> waiting;
    waiting.reserve(waiting_);
    const auto take = [&](const std::vector<int>& entered) {
      for (const int i : entered) {
        // Who is in the heap, or was taken before, has a void entry here.
        if (filed_[index(i)].place >= kNowhere) continue;
        filed_[index(i)].place = kNowhere;
        waiting.push_back(i);
      }
    };
    for (std::size_t bin = opened_; bin < bins_.size(); ++bin) take(bins_[bin]);
    take(behind_);
    bins_.clear();
    behind_.clear();
    waiting_ = entries_ = 0;
    lay_out_bins(waiting);
    for (const int i : waiting) file(i, bin_of(filed_[index(i)].time));
  }

  /// The first bin is opened at once: it stands for all times before it as well.
  void lay_out_bins(const std::vector<int>& waiting) {
    std::vector<double> sample;
    const std::size_t step = waiting.size() / kSample + 1;
    for (std::size_t n = 0; n < waiting.size(); n += step) {
      sample.push_back(coarse(filed_[index(waiting[n])].time));
    }
    origin_ = per_width_ = 0;
    std::size_t count = 1;
    if (waiting.size() > kPerBin) {
      const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
      std::nth_element(sample.begin(), middle, sample.end());
      origin_ = *std::min_element(sample.begin(), middle + 1);
      const double per_width = static_cast<double>(waiting.size() / kPerBin) / (2 * (*middle - origin_));
      if (per_width < std::numeric_limits<double>::max()) {
        per_width_ = per_width;
        count = waiting.size() / kPerBin + 1;
      }
    }
    bins_.resize(count);
    opened_ = 1;
  }

  void append_due(std::size_t at, const Time<Scalar>& latest, std::vector<int>& particles) const {
    if (at >= heap_.size() || latest < heap_[at].time) return;
    particles.push_back(heap_[at].particle);
    for (std::size_t n = 1; n <= kBranches; ++n) append_due(kBranches * at + n, latest, particles);
  }

  void put(std::size_t at, const Due& due) {
    heap_[at] = due;
    filed_[index(due.particle)].place = static_cast<int>(at);
  }

  void take_out(std::size_t at) {
    const Due last = heap_.back();
    heap_.pop_back();
    if (at == heap_.size()) return;
    if (at > 0 && last.time < heap_[(at - 1) / kBranches].time) {
      rise(at, last);
    } else {
      sink(at, last);
    }
  }

  void rise(std::size_t at, const Due& due) {
    while (at > 0) {
      const std::size_t parent = (at - 1) / kBranches;
      if (!(due.time < heap_[parent].time)) break;
      put(at, heap_[parent]);
      at = parent;
    }
    put(at, due);
  }

  void sink(std::size_t at, const Due& due) {
    for (;;) {
      const std::size_t first = kBranches * at + 1;
      if (first >= heap_.size()) break;
      const std::size_t end = std::min(first + kBranches, heap_.size());
      std::size_t least = first;
      for (std::size_t child = first + 1; child < end; ++child) {
        if (heap_[child].time < heap_[least].time) least = child;
      }
      if (!(heap_[least].time < due.time)) break;
      put(at, heap_[least]);
      at = least;
    }
    put(at, due);
  }

  std::vector<Due> heap_;
  LargeVector<Filed> filed_;
  std::vector<std::vector<int>> bins_;
  std::vector<int> behind_;  ///< the last bin: whom no other one has
  std::size_t opened_ = 0;   ///< bins whose particles are in the heap
  std::size_t waiting_ = 0;  ///< particles in bins that are not
  std::size_t entries_ = 0;  ///< in the lists of those, void ones included
  double origin_ = 0;        ///< where the first bin begins
  double per_width_ = 0;     ///< bins in a unit of time; 0: one bin has all times
};

}  // namespace tps

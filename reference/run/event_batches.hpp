// Events on their way to the trace: kept as they happen, put into words by the thread that writes them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reference/engine/record.hpp"
#include "reference/run/trace_file.hpp"
#include "reference/scene/scene.hpp"
#include "reference/text/background_writer.hpp"
#include "reference/trace/event_line.hpp"

namespace tps {

/// Events one after the other. Their memory is used again.
template <typename Scalar, int D>
class EventBatch {
 public:
  void add(const Scene& scene, const Record<Scalar, D>& record) {
    if (used_ == events_.size()) events_.emplace_back();
    Kept& kept = events_[used_++];
    kept.words.clear();
    kept.addition.reset();
    const Addition<Scalar, D>* const added = record.addition;
    weight_ += 1 + record.involved.size() + (added != nullptr ? added->members.size() : 0);
    if (added != nullptr && !added->own.empty()) {  // these point into their effect
      append_event<Scalar, D>(kept.words, scene, record);
      return;
    }
    kept.record = record;
    if (added != nullptr) kept.addition = *added;
  }

  /// What was added since is part of the trace.
  void end_step() { whole_ = used_; }
  /// What was added since is not.
  void drop_step() { used_ = whole_; }
  bool empty() const { return used_ == 0; }
  /// How much it holds: events, and particles that they name.
  std::size_t weight() const { return weight_; }

  /// Appends their lines, and has nothing left.
  void put_into_words(std::string& text, const Scene& scene) {
    for (std::size_t n = 0; n < whole_; ++n) put_into_words(text, scene, events_[n]);
    used_ = whole_ = weight_ = 0;
  }

 private:
  struct Kept {
    Record<Scalar, D> record;
    std::optional<Addition<Scalar, D>> addition;  ///< what the record's pointed to
    std::string words;                            ///< instead of both
  };
  /// Of more than so many the memory is given back: a body may have thousands of members.
  static constexpr std::size_t kFew = 16;

  static void put_into_words(std::string& text, const Scene& scene, Kept& kept) {
    if (!kept.words.empty()) {
      text.append(kept.words);
      return;
    }
    if (kept.addition) kept.record.addition = &*kept.addition;
    append_event<Scalar, D>(text, scene, kept.record);
    if (kept.record.involved.capacity() > kFew) kept.record.involved = {};
  }

  std::vector<Kept> events_;
  std::size_t used_ = 0;   ///< of `events_`
  std::size_t whole_ = 0;  ///< of these, of steps that are done
  std::size_t weight_ = 0;
};

/// Fills one batch while others are being written.
template <typename Scalar, int D>
class EventBatches {
 public:
  EventBatches(const Scene& scene, TraceFiles& files) : scene_(scene), files_(files) {}
  /// What the thread has not written yet is here.
  ~EventBatches() { files_.settle(); }
  EventBatches(const EventBatches&) = delete;
  EventBatches& operator=(const EventBatches&) = delete;

  void add(const Record<Scalar, D>& record) { filling().add(scene_, record); }
  void end_step() {
    filling().end_step();
    if (filling().weight() >= kEnough) hand_over();
  }
  void drop_step() { filling().drop_step(); }

  /// Before anything else is written to the trace. REQUIRES that no step is being made.
  void hand_over() {
    if (filling().empty()) return;
    EventBatch<Scalar, D>& batch = filling();
    const Scene& scene = scene_;
    next_ = (next_ + 1) % batches_.size();  // is done: at most kMostPending others are not
    files_.lines([&batch, &scene](std::string& text) { batch.put_into_words(text, scene); });
  }

 private:
  /// Some 300 collisions, a quarter of a megabyte of text: two threads meet rarely, and both find it in their
  /// caches.
  static constexpr std::size_t kEnough = 1000;

  EventBatch<Scalar, D>& filling() { return batches_[next_]; }

  const Scene& scene_;
  TraceFiles& files_;
  std::array<EventBatch<Scalar, D>, BackgroundWriter::kMostPending + 1> batches_;
  std::size_t next_ = 0;  ///< is being filled
};

}  // namespace tps

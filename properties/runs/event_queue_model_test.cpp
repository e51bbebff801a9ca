// Random sequences of pushes, changes and takes on EventQueue, against a list that is searched.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <rapidcheck/state.h>

#include <algorithm>

#include "reference/engine/queue.hpp"

namespace tps::properties::runs {
namespace {

constexpr int kQueued = 4;
using Pending = PendingEvent<double>;

struct Waiting {
  std::vector<Pending> events;
  std::vector<std::uint32_t> revisions = std::vector<std::uint32_t>(kQueued, 0);

  std::uint32_t revision(int i) const { return revisions[static_cast<std::size_t>(i)]; }
  bool is_live(const Pending& e) const {
    return revision(e.first) == e.first_revision && revision(e.second) == e.second_revision;
  }
  /// By time, rank, smaller and larger particle, as semantics §6 has it.
  std::vector<Pending>::const_iterator earliest() const {
    return std::ranges::min_element(events, {}, [this](const Pending& e) {
      return std::make_tuple(!is_live(e), e.time.hi, e.time.lo, e.rank, e.first, e.second, e.detail);
    });
  }
};

using Queue = EventQueue<double>;
using OnQueue = rc::state::Command<Waiting, Queue>;

/// One event, or so many that the queue drops those which have become void.
struct Push : OnQueue {
  int copies = *rc::gen::element(1, 1, 1, 1, 1, 3000);
  double hi = *rc::gen::inRange(0, 4), lo = *rc::gen::inRange(-1, 2) * 0x1p-60;
  Rank rank = *rc::gen::element(Rank::collision, Rank::restitution, Rank::wall);
  int first = *rc::gen::inRange(0, kQueued), second = *rc::gen::inRange(0, kQueued),
      detail = *rc::gen::inRange(0, 2);

  Pending event(const Waiting& model) const {
    const auto [a, b] = std::minmax(first, second);
    return {{hi, lo}, rank, a, b, detail, 0, model.revision(a), model.revision(b)};
  }
  void apply(Waiting& model) const override {
    model.events.insert(model.events.end(), static_cast<std::size_t>(copies), event(model));
  }
  void run(const Waiting& model, Queue& queue) const override {
    for (int n = 0; n < copies; ++n) queue.push(event(model));
  }
  void show(std::ostream& out) const override {
    out << "push " << copies << " at " << hi << " + " << lo << " of " << first << " and " << second
        << ", rank " << static_cast<int>(rank) << ", detail " << detail;
  }
};

struct Change : OnQueue {
  int i = *rc::gen::inRange(0, kQueued);

  void apply(Waiting& model) const override { ++model.revisions[static_cast<std::size_t>(i)]; }
  void show(std::ostream& out) const override { out << "particle " << i << " changes"; }
};

struct Take : OnQueue {
  void apply(Waiting& model) const override {
    const auto next = model.earliest();
    if (next != model.events.end() && model.is_live(*next)) model.events.erase(next);
  }
  void run(const Waiting& model, Queue& queue) const override {
    const Pending* found = queue.next([&](const Pending& e) { return model.is_live(e); });
    const auto expected = model.earliest();
    RC_ASSERT((found != nullptr) == (expected != model.events.end() && model.is_live(*expected)));
    if (found == nullptr) return;
    RC_ASSERT(!(*found < *expected) && !(*expected < *found));
    queue.pop();
  }
  void show(std::ostream& out) const override { out << "take"; }
};

RC_GTEST_PROP(EventQueueModel, IsASearchedList, ()) {
  Queue queue;
  rc::state::check(Waiting{}, queue, rc::state::gen::execOneOfWithArgs<Push, Push, Change, Take>());
}

}  // namespace
}  // namespace tps::properties::runs

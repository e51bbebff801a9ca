// Work on a second thread, a little ahead of whoever needs it.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

#include "reference/process/without_signals.hpp"

namespace tps::properties::conform {

/// Held by a second thread while it works: a fork waits for it. A child has only the thread that forked, so
/// it must not inherit a lock, or a static that another thread was about to make.
class NoForkMeanwhile {
 public:
  NoForkMeanwhile();
  ~NoForkMeanwhile();
  NoForkMeanwhile(const NoForkMeanwhile&) = delete;
  NoForkMeanwhile& operator=(const NoForkMeanwhile&) = delete;
};

/// use(make(0)), use(make(1)), … make(count − 1): `use` on this thread, in this order, until it returns
/// false; `make` on another one, at most two items ahead. What either throws is thrown here, after the items
/// before it have been used. `make` holds a NoForkMeanwhile in each of its steps if `use` may fork.
template <typename Item>
void for_each_made_ahead(std::size_t count, const std::function<Item(std::size_t)>& make,
                         const std::function<bool(Item)>& use) {
  constexpr std::size_t kAhead = 2;
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<Item> made;
  std::exception_ptr failure;
  bool stopped = false, complete = false;

  const auto work = [&] {
    try {
      for (std::size_t n = 0; n < count; ++n) {
        Item item = make(n);
        std::unique_lock lock(mutex);
        changed.wait(lock, [&] { return stopped || made.size() < kAhead; });
        if (stopped) break;
        made.push_back(std::move(item));
        changed.notify_all();
      }
    } catch (...) {
      failure = std::current_exception();
    }
    const std::lock_guard lock(mutex);
    complete = true;
    changed.notify_all();
  };
  std::thread maker;
  {
    const WithoutSignals mask;
    maker = std::thread(work);
  }
  const auto end = [&] {
    {
      const std::lock_guard lock(mutex);
      stopped = true;
    }
    changed.notify_all();
    maker.join();
  };

  try {
    for (bool wanted = true; wanted;) {
      std::unique_lock lock(mutex);
      changed.wait(lock, [&] { return complete || !made.empty(); });
      if (made.empty()) break;
      Item item = std::move(made.front());
      made.pop_front();
      lock.unlock();
      changed.notify_all();
      wanted = use(std::move(item));
    }
  } catch (...) {
    end();
    throw;
  }
  end();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace tps::properties::conform

// When a line of progress is due.
#pragma once

#include <chrono>
#include <cstdlib>
#include <string_view>

namespace tps::cli {

/// Whether progress may be said: not under --quiet, nor with TPS_PROGRESS=never in the environment, which is
/// for whoever compares outputs, since how often progress comes depends on the machine.
inline bool may_say_progress(bool quiet) {
  const char* setting = std::getenv("TPS_PROGRESS");
  return !quiet && (setting == nullptr || std::string_view(setting) != "never");
}

/// Due at most once in so many seconds, the first time after as many.
class LineEvery {
 public:
  using Clock = std::chrono::steady_clock;

  LineEvery(std::chrono::seconds between, bool quiet)
      : between_(between), next_(Clock::now() + between), wanted_(may_say_progress(quiet)) {}

  bool due() {
    if (!wanted_) return false;
    const Clock::time_point now = Clock::now();
    if (now < next_) return false;
    next_ = now + between_;
    return true;
  }

 private:
  std::chrono::seconds between_;
  Clock::time_point next_;
  bool wanted_;
};

}  // namespace tps::cli

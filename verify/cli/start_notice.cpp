#include "verify/cli/start_notice.hpp"

#include <chrono>

#include "reference/process/without_signals.hpp"
#include "reference/text/printable.hpp"
#include "verify/cli/line_every.hpp"
#include "verify/cli/say.hpp"

namespace tps::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kPatience(1);
constexpr std::chrono::seconds kBetweenNotices(5);

}  // namespace

StartNotice::StartNotice(bool quiet) : stopped_(!may_say_progress(quiet)) {
  if (stopped_) return;
  const WithoutSignals mask;
  thread_ = std::thread([this] { watch(); });
}

StartNotice::~StartNotice() {
  stop();
}

void StartNotice::doing(std::string what) {
  const std::lock_guard lock(mutex_);
  what_ = std::move(what);
}

void StartNotice::stop() {
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void StartNotice::watch() {
  const Clock::time_point start = Clock::now();
  std::unique_lock lock(mutex_);
  for (Clock::time_point next = start + kPatience;; next += kBetweenNotices) {
    if (changed_.wait_until(lock, next, [this] { return stopped_; })) return;
    const std::chrono::duration<double> passed = Clock::now() - start;
    say("starting: {} ({:.0f} s)\n", printable(what_), passed.count());
    std::fflush(stderr);
  }
}

}  // namespace tps::cli

// Ctrl-C, SIGTERM and SIGHUP, in one place for every verb (docs/robustness.md).
#pragma once

#include <poll.h>

#include <atomic>
#include <chrono>
#include <exception>

namespace tps::interrupt {

constexpr int kExitCode = 130;

/// What somebody who has begun something to be ended in good order has for that.
constexpr std::chrono::milliseconds kGrace{500};

/// Thrown where work is given up because a signal came.
class Interrupted : public std::exception {
 public:
  const char* what() const noexcept override { return "interrupted"; }
};

/// From here on a signal ends the process with kExitCode: at once, unless a GoodOrder lives. The second one
/// always does, and so does the end of the grace, wherever the process waits or computes. `program` names it
/// in messages, and must stay.
void install(const char* program);

/// Whether a signal came.
bool requested();
const std::atomic<bool>& flag();

/// Throws Interrupted where a signal came.
void check();

/// While one lives, the first signal sets the flag and interrupts waiting; whoever made it looks at the flag.
class GoodOrder {
 public:
  GoodOrder();
  ~GoodOrder();
  GoodOrder(const GoodOrder&) = delete;
  GoodOrder& operator=(const GoodOrder&) = delete;
};

/// As poll(), restarted where another signal interrupts it. No signal is lost between the look at the flag
/// and the wait. Throws Interrupted.
int wait(pollfd* awaited, nfds_t count, std::chrono::milliseconds timeout);

/// Has `last_act` called before a signal ends the process. It must be safe in a signal handler.
void before_leaving(void (*last_act)());

/// In a new child: signals do what they do by default.
void forget();

}  // namespace tps::interrupt

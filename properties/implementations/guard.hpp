// The process between us and somebody else's program: what the program starts ends when we do, however we
// end.
#pragma once

#include <sys/types.h>

#include <functional>

namespace tps::properties {

/// Standard input, output and error of a program, and the two pipes by which its guard is spoken with.
struct GuardedPipes {
  int input, output, errors;
  int orders;   ///< read by the guard; once it is closed everything is ended
  int reports;  ///< written by the guard
};

/// What a guard reports, once each.
struct GuardReport {
  enum class What : int { started, ended } what;
  int value;  ///< the program's process, which leads a group; its status as of waitpid()
};

/// Runs `body` in a process of its own and waits for its end or for ours. Then everything that descends from
/// it is killed, whatever group or session it has moved to, and the end is reported. Never returns; the
/// calling process becomes the guard, and should be a fresh child.
[[noreturn]] void guard(const std::function<int()>& body, const GuardedPipes& pipes);

}  // namespace tps::properties

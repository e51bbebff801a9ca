// Processor time of the calling thread: what others do on the machine costs caches, not time.
#pragma once

#include <time.h>

namespace tps {

/// A reading of a clock of POSIX, in seconds; a double holds a year of nanoseconds to less than ten.
inline double seconds_of(clockid_t clock) {
  timespec now{};
  ::clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// CPU seconds that the calling thread has used since it began.
inline double thread_seconds() {
  return seconds_of(CLOCK_THREAD_CPUTIME_ID);
}

}  // namespace tps

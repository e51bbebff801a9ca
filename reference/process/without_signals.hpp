// Threads that signals pass by.
#pragma once

#include <csignal>

namespace tps {

/// Threads that are started while it lives are sent no signal: those are for the thread whose waiting they
/// are to interrupt (interrupt.hpp).
class WithoutSignals {
 public:
  WithoutSignals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before_);
  }
  ~WithoutSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  WithoutSignals(const WithoutSignals&) = delete;
  WithoutSignals& operator=(const WithoutSignals&) = delete;

 private:
  sigset_t before_{};
};

}  // namespace tps

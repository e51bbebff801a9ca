#include "reference/text/background_writer.hpp"

#include <csignal>
#include <utility>

namespace tps {

BackgroundWriter::~BackgroundWriter() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void BackgroundWriter::hand_over(std::string& buffer) {
  wait();
  if (buffer.empty()) return;
  if (!thread_.joinable()) {
    // Signals are for the threads that wait for them.
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before);
    thread_ = std::thread([this] { work(); });
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }
  {
    const std::lock_guard lock(mutex_);
    std::swap(pending_, buffer);
  }
  changed_.notify_all();
}

void BackgroundWriter::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return pending_.empty(); });
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

void BackgroundWriter::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return !pending_.empty() || is_over_; });
    if (pending_.empty()) return;
    lock.unlock();
    std::exception_ptr error;
    try {
      write_(pending_);
    } catch (...) {
      error = std::current_exception();
    }
    lock.lock();
    pending_.clear();
    error_ = error;
    changed_.notify_all();
  }
}

}  // namespace tps

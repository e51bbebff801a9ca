#include "reference/text/background_writer.hpp"

#include <utility>

#include "reference/process/without_signals.hpp"

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
    const WithoutSignals mask;
    thread_ = std::thread([this] { work(); });
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

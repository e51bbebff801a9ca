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
  if (buffer.empty()) return;
  put([&](Piece& piece) { std::swap(piece.text, buffer); });
}

void BackgroundWriter::hand_over(MakeText make) {
  put([&](Piece& piece) { piece.make = std::move(make); });
}

void BackgroundWriter::put(const std::function<void(Piece&)>& fill) {
  if (!thread_.joinable()) {
    const WithoutSignals mask;
    thread_ = std::thread([this] { work(); });
  }
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return error_ ? pending_ == 0 : pending_ < kMostPending; });
    if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
    fill(ring_[(first_ + pending_) % kMostPending]);
    ++pending_;
  }
  changed_.notify_all();
}

void BackgroundWriter::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return pending_ == 0; });
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

void BackgroundWriter::settle() noexcept {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return pending_ == 0; });
}

void BackgroundWriter::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return pending_ > 0 || is_over_; });
    if (pending_ == 0) return;
    Piece& piece = ring_[first_];
    if (!error_) {  // behind what could not be written nothing else is
      lock.unlock();
      std::exception_ptr error;
      try {
        write(piece);
      } catch (...) {
        error = std::current_exception();
      }
      lock.lock();
      error_ = error;
    }
    piece.text.clear();
    piece.make = nullptr;
    first_ = (first_ + 1) % kMostPending;
    --pending_;
    changed_.notify_all();
  }
}

void BackgroundWriter::write(Piece& piece) {
  if (!piece.text.empty()) write_(piece.text);
  if (!piece.make) return;
  made_.clear();
  piece.make(made_);
  write_(made_);
}

}  // namespace tps

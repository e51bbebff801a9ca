// Writes on a thread of its own what another one puts together meanwhile, or puts it together, too.
#pragma once

#include <array>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace tps {

/// Appends text to what a string holds.
using MakeText = std::function<void(std::string&)>;

/// A bounded queue of pieces of text, which are written in the order in which they came. The thread starts
/// with the first piece.
class BackgroundWriter {
 public:
  /// Pieces that wait or are being written: what evens out that one of the two threads is sometimes kept from
  /// its processor for some milliseconds.
  static constexpr std::size_t kMostPending = 8;

  /// `write` is called on the thread, and may throw.
  explicit BackgroundWriter(std::function<void(std::string_view)> write) : write_(std::move(write)) {}
  /// Waits; what then fails is not reported.
  ~BackgroundWriter();
  BackgroundWriter(const BackgroundWriter&) = delete;
  BackgroundWriter& operator=(const BackgroundWriter&) = delete;

  /// Whether another thread would have a processor to itself.
  static bool pays() { return std::thread::hardware_concurrency() > 1; }

  /// Takes over what is in the buffer and leaves an empty one. Waits while the queue is full, and throws what
  /// was thrown on the thread: then what was pending is lost, and so is this.
  void hand_over(std::string& buffer);
  /// The same of text that is yet to be made, on the thread. What `make` refers to is to stay as it is until
  /// kMostPending pieces more have been handed over, or all is written.
  void hand_over(MakeText make);
  /// Waits until all is written. Throws what was thrown on the thread.
  void wait();
  /// Waits until the thread has nothing to do; what went wrong is thrown by the next call.
  void settle() noexcept;

 private:
  struct Piece {
    std::string text;
    MakeText make;  ///< of what follows the text
  };

  /// Waits for a place, and has it filled. @param fill called under the lock
  void put(const std::function<void(Piece&)>& fill);
  void work();
  void write(Piece& piece);

  std::function<void(std::string_view)> write_;
  std::string made_;  ///< of the thread alone: its memory is used again
  std::mutex mutex_;  ///< of all below
  std::condition_variable changed_;
  std::array<Piece, kMostPending> ring_;
  std::size_t first_ = 0;    ///< being written, if any is pending
  std::size_t pending_ = 0;  ///< from `first_` on
  bool is_over_ = false;
  std::exception_ptr error_;
  std::thread thread_;
};

}  // namespace tps

// Writes on a thread of its own what another one puts together meanwhile.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace tps {

/// Takes buffers one after the other and writes each, one being written while the next one is filled. The
/// thread starts with the first buffer.
class BackgroundWriter {
 public:
  /// `write` is called on the thread, and may throw.
  explicit BackgroundWriter(std::function<void(std::string_view)> write) : write_(std::move(write)) {}
  /// Waits; what then fails is not reported.
  ~BackgroundWriter();
  BackgroundWriter(const BackgroundWriter&) = delete;
  BackgroundWriter& operator=(const BackgroundWriter&) = delete;

  /// Whether another thread would have a processor to itself.
  static bool pays() { return std::thread::hardware_concurrency() > 1; }

  /// Takes over what is in the buffer and leaves an empty one. Waits until the one before is written, and
  /// throws what was thrown then.
  void hand_over(std::string& buffer);
  /// Waits until all is written. Throws what was thrown then.
  void wait();

 private:
  void work();

  std::function<void(std::string_view)> write_;
  std::mutex mutex_;  ///< of all below
  std::condition_variable changed_;
  std::string pending_;  ///< being written, if it is not empty
  bool is_over_ = false;
  std::exception_ptr error_;
  std::thread thread_;
};

}  // namespace tps

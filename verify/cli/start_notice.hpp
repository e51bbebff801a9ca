// Says what a run is at before its first events, where that takes longer than a second.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace tps::cli {

/// From a thread of its own: the start of a large scene is one long computation that reports nothing.
class StartNotice {
 public:
  explicit StartNotice(bool quiet);
  ~StartNotice();
  StartNotice(const StartNotice&) = delete;
  StartNotice& operator=(const StartNotice&) = delete;

  /// What is being done from now on, such as "reading scene.json".
  void doing(std::string what);
  /// Events happen: from here the progress speaks.
  void stop();

 private:
  void watch();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::string what_;
  bool stopped_ = false;
  std::thread thread_;
};

}  // namespace tps::cli

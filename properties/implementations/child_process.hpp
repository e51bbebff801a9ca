// A process of ours that is talked to through pipes, line by line.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

namespace tps::properties {

class ChildProcess {
 public:
  struct Line {
    enum class Status {
      line,
      ended,  ///< the process is gone; `text` says how
      late,   ///< nothing came in time
      too_long,
    };
    Status status;
    std::string text;
  };

  /// Runs `body` in a child whose standard input and output are the pipes; what it returns is the exit code.
  /// `body` may exec. Throws std::system_error where the system has no process to give.
  explicit ChildProcess(const std::function<int()>& body);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// @return whether the child took the line.
  bool write_line(std::string_view text);
  Line read_line(std::chrono::milliseconds timeout);

 private:
  Line ended();

  pid_t process_ = -1;
  int to_child_ = -1, from_child_ = -1;
  std::string buffer_;
};

}  // namespace tps::properties

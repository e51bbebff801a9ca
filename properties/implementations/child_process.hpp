// Somebody else's program as a process, talked to through pipes, line by line.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tps::properties {

/// Its process leads a group and is watched by a guard (guard.hpp): when this object goes, or this process
/// does, everything that the program has started is ended. Memory is bounded whatever the program writes.
class ChildProcess {
 public:
  struct Line {
    enum class Status {
      line,
      ended,   ///< the process is gone; `text` says how
      closed,  ///< it is there and has closed its output
      late,    ///< nothing came in time; `text` is what it wrote to its standard error, as words to add
      too_long,
    };
    Status status;
    std::string text;
    int code = 0;           ///< of one that ended: its exit code, or 128 + the signal that ended it
    std::string rest = {};  ///< of one that ended: what it wrote behind the last line end
  };

  /// Runs `body` with pipes as its standard input, output and error; what it returns is the exit code. `body`
  /// may exec. Throws std::system_error where the system has no process to give. SIGPIPE is ignored from then
  /// on.
  explicit ChildProcess(const std::function<int()>& body);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Sends what the child takes now; the rest goes while lines are read.
  void write_line(std::string_view text);
  /// Throws interrupt::Interrupted.
  Line read_line(std::chrono::milliseconds timeout);
  /// Passes over what the program writes until it ends, or is late.
  Line read_to_end(std::chrono::milliseconds timeout);

 private:
  using Clock = std::chrono::steady_clock;

  void exchange(std::chrono::milliseconds timeout);
  void send();
  void take_output();
  void take_errors();
  void take_report();
  Line ended();
  std::string errors_to_add() const;

  pid_t guard_ = -1, program_ = -1;
  int to_child_ = -1, from_child_ = -1, errors_ = -1, orders_ = -1, reports_ = -1;
  std::string unsent_, buffer_, written_errors_;
  bool errors_are_cut_ = false;
  bool has_ended_ = false;
  int status_ = 0;
};

constexpr int kNotExecuted = 127;  ///< as shells have it

/// A body that becomes this command. What keeps it from being executed is said on its standard error.
std::function<int()> executing(std::vector<std::string> words);

}  // namespace tps::properties

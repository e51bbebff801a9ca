// Lines from a pipe, a terminal or a file, as they come.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace tps {

/// Reads lines from a file descriptor. What is there is used before more is asked for, so that a sender of
/// many lines costs few system calls and one that waits for its answer is never kept waiting.
class LineReader {
 public:
  enum class Status {
    line,         ///< a line, without its end ("\n" or "\r\n"); the last one may lack it
    too_long,     ///< a line of more than the limit was passed over; its beginning is given
    end,          ///< no more lines
    interrupted,  ///< `stop` said so while waiting
  };
  struct Result {
    Status status;
    std::string_view text;  ///< valid until the next call
  };

  /// `source` is what messages call it. `before_waiting` is called whenever the next line is not there yet;
  /// `stop` whether to give up waiting, which is asked at the start and whenever a signal arrives.
  LineReader(std::string source, int descriptor, std::size_t longest_line,
             std::function<void()> before_waiting, std::function<bool()> stop)
      : source_(std::move(source)),
        descriptor_(descriptor),
        longest_(longest_line),
        before_waiting_(std::move(before_waiting)),
        stop_(std::move(stop)) {}

  /// From the next line on.
  void set_longest_line(std::size_t bytes) { longest_ = bytes; }

  /// Throws InputError where the system refuses to read (a directory, a closed descriptor).
  Result next();

  /// Bytes before the next line.
  std::uint64_t place() const { return erased_ + begin_; }

 private:
  enum class Filled { more, end, interrupted };
  Filled fill();
  Result taken(std::size_t length, std::size_t end_length, bool too_long);

  std::string source_;
  int descriptor_;
  std::size_t longest_;
  std::function<void()> before_waiting_;
  std::function<bool()> stop_;
  std::string buffer_;
  std::size_t begin_ = 0;     ///< of what has not been handed out
  std::uint64_t erased_ = 0;  ///< bytes that are no longer in the buffer
  std::string beginning_;     ///< of a line that is too long
};

}  // namespace tps

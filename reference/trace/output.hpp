// A file that is being written line by line: nothing is lost silently, and what is there is readable at any
// moment.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tps {

/// A result could not be written: names the file and the system's reason.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Appends text to a file, "-" being standard output. Buffered; throws OutputError as soon as the system
/// refuses to take something (a full disk, a closed pipe).
class Output {
 public:
  /// Creates or empties the file.
  explicit Output(const std::string& path);
  /// Keeps the first `keep` bytes of an existing file and goes on behind them.
  Output(const std::string& path, std::uint64_t keep);
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  void write(std::string_view text);
  /// Hands everything to the system.
  void flush();
  /// Flushes and closes; a write that fails only now is reported too.
  void close();

 private:
  [[noreturn]] void fail(const char* action) const;

  std::string path_;
  int descriptor_ = -1;
  std::string buffer_;
};

/// Replaces a file's content in one step: a reader sees the old or the new one, never a part.
void replace_file(const std::string& path, std::string_view content);

}  // namespace tps

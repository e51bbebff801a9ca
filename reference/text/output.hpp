// A file that is being written line by line: nothing is lost silently, and what is there is readable at any
// moment.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tps {

class BackgroundWriter;

/// A result could not be written: names the file and the system's reason.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Appends text to a file, "-" being standard output. Buffered; throws OutputError as soon as the system
/// refuses to take something (a full disk, a closed pipe), or where another process writes the same file.
class Output {
 public:
  enum class Append { at_end };
  enum class Reserve { only };

  /// Creates or empties the file.
  explicit Output(const std::string& path);
  /// Opens and locks the file, and leaves what it holds as it is until begin(): for who has to compute a
  /// while before the first line. A file that was made for it, and never begun, is removed again.
  Output(const std::string& path, Reserve only);
  /// Creates the file if it is not there, and goes on at its end.
  Output(const std::string& path, Append at_end);
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// Keeps the first `keep` bytes of the file and goes on behind them.
  void begin(std::uint64_t keep = 0);
  void write(std::string_view text);
  /// Text that `make` appends to a string: in the background it is the thread that has it made, and what
  /// `make` refers to is to stay as BackgroundWriter::hand_over says.
  void write(std::function<void(std::string&)> make);
  /// From now on full buffers are handed to the system by a thread of their own, where it has a processor for
  /// itself; what the system refuses is reported by one of the calls after.
  void write_in_background();
  /// Sees to it that everything gets to the system soon, and waits for nothing that the background does.
  void send();
  /// Hands everything to the system.
  void flush();
  /// Waits until no `make` is needed any more.
  void settle() noexcept;
  /// Flushes and closes; a write that fails only now is reported too.
  void close();

 private:
  /// Locked until it is closed, by whichever name or link it was opened.
  void open_locked(int mode);
  [[noreturn]] void fail(const char* action) const;
  /// Behind what could not be written nothing else is.
  template <typename Action>
  void in_background(const Action& action);
  void write_out(std::string_view text) const;

  std::string path_;
  int descriptor_ = -1;
  bool is_file_ = false;     ///< rather than a pipe, a terminal, a device
  bool made_empty_ = false;  ///< by us, and nothing was begun in it
  std::string buffer_;
  std::unique_ptr<BackgroundWriter> background_;  ///< null: buffers are written by who fills them
};

/// A file whose content is replaced in one step: a reader sees the old or the new one, never a part. While
/// one lives, no other process can have one of the same file.
class ReplacedFile {
 public:
  /// Throws OutputError where another process has it, or what is there is no file (a device).
  explicit ReplacedFile(const std::string& path);
  ~ReplacedFile();
  ReplacedFile(const ReplacedFile&) = delete;
  ReplacedFile& operator=(const ReplacedFile&) = delete;

  void replace(std::string_view content);
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  int ours_ = -1;  ///< what was there or what we put there, locked
};

}  // namespace tps

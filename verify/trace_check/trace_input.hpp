// A trace as a file: what its header says, then its lines.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "reference/engine/timing.hpp"
#include "reference/scene/scene.hpp"
#include "reference/text/line_reader.hpp"
#include "verify/trace_check/line_text.hpp"

namespace tps::check {

/// The header of anybody's trace (docs/check.md); TraceHead is that of ours.
struct TraceFileHead {
  Scene scene;
  std::string scalar = "double";
  Timing timing = Timing::stable;
  bool minimal = false;
  int semantics = 0;      ///< 0: not said
  std::string positions;  ///< "lazy", "eager" or empty: not said
  bool own_draws = false;
  bool checksum_holds = true;      ///< where it has one
  bool has_another_scene = false;  ///< than the file that was given with it
};

/// Opens a trace and reads its header; then hands out the lines behind it, as text.
class TraceInput {
 public:
  /// "-" is the standard input. `scene_file` is the scene of a trace that lacks its own; empty: none. `stop`
  /// is asked before each line. Throws InputError where there is no trace: no file, no header, a broken
  /// scene.
  TraceInput(const std::string& path, const std::string& scene_file, std::function<bool()> stop);

  const TraceFileHead& head() const { return head_; }
  /// The next line; false at the end, or where `stop` said so.
  bool next(LineText& line);

  /// From where the next line is.
  std::uint64_t place() const { return reader_.place(); }
  /// Whether what was read can be read again: a file, and not a pipe.
  bool can_be_reopened() const { return can_be_reopened_; }
  /// Reads lines from a place on once more, beside this one. REQUIRES can_be_reopened().
  class Again;

  std::uint64_t lines() const { return lines_; }  ///< handed out or read so far, the header among them
  std::uint64_t bytes() const { return bytes_; }
  bool interrupted() const { return interrupted_; }

 private:
  struct Descriptor {
    int number;
    explicit Descriptor(int descriptor) : number(descriptor) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor();
  };

  std::size_t longest_line() const;

  std::string path_;
  Descriptor descriptor_;  ///< closed in the end; 0 is the standard input
  bool can_be_reopened_;
  std::function<bool()> stop_;
  LineReader reader_;
  TraceFileHead head_;
  std::uint64_t lines_ = 1;
  std::uint64_t bytes_ = 0;
  bool interrupted_ = false;
};

class TraceInput::Again {
 public:
  Again(const TraceInput& input, std::uint64_t place);
  /// Throws InputError where the file has become shorter.
  LineText next();

 private:
  std::string path_;
  Descriptor descriptor_;
  LineReader reader_;
};

}  // namespace tps::check

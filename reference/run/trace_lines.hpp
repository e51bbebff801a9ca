// A trace or a checkpoint line by line, and whether its lines follow each other.
#pragma once

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>

#include "reference/trace/state_data.hpp"

namespace tps {

/// Complete lines of a file, with the place behind each. A last line without an end was cut off while it was
/// written and does not count. Throws InputError where the file cannot be read or a line is too long.
class TraceLines {
 public:
  explicit TraceLines(const std::string& path);

  bool next();
  StateData state() const;  ///< of a line that is one; throws InputError

  const std::string& path() const { return path_; }

  std::string text;
  std::size_t number = 0;
  std::uint64_t end = 0;

 private:
  std::string path_;
  std::ifstream in_;
};

/// What kind of line one is, by its first key, and the number that it carries.
struct TraceLineKind {
  enum class What { head, event, state, end, other };
  What what = What::other;
  std::uint64_t k = 0;  ///< of an event, its number; of a state, the events so far
};

/// Damage that shows without simulating: a line that is no whole JSON object, events that are not numbered in
/// a row, a state that does not stand behind its event or whose checksum is wrong, anything behind the end.
/// A changed digit of an event does not show; `tps check` finds those.
class TraceOrder {
 public:
  /// Takes the next line up. REQUIRES that it is given every line.
  TraceLineKind next(const TraceLines& lines);

  /// Throws InputError where a line so far was damaged: what is behind it is not what the run left. Of the
  /// content of the last state so far nothing is said: whoever takes it up reads it.
  void require_sound() const;

 private:
  struct Damage {
    std::string path;
    std::size_t line = 0;
    std::string what;  ///< empty: none
  };

  std::string damage(const TraceLines& lines, TraceLineKind& kind);
  void note(const Damage& found);

  std::optional<std::uint64_t> events_;
  bool ended_ = false;
  Damage damage_, suspect_;
};

}  // namespace tps

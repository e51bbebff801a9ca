// A trace in segments from full state to full state.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "verify/trace_check/trace_input.hpp"

namespace tps::check {

/// Which lines of a trace end a segment: by the text alone, so that whoever reads it finds the same ones.
class Borders {
 public:
  /// `possible`: in traces that have full states and are judged from them.
  Borders(bool possible, std::uint64_t least_lines) : possible_(possible), least_(least_lines) {}

  /// Whether the next line is a full state, as our runs spell them, behind enough others; but for the one
  /// that a run ends with, which nothing follows.
  bool is_at(const LineText& line) {
    ++lines_;
    if (!possible_ || lines_ < least_ || line.too_long || !is_state(line.text)) return false;
    lines_ = 0;
    return true;
  }

 private:
  static bool is_state(std::string_view text) {
    constexpr std::size_t kBeginning = 300;  // holds the number and the time, which stand before
    return text.starts_with("{\"state\":") && text.substr(0, kBeginning).find("\"final\":true") == text.npos;
  }

  bool possible_;
  std::uint64_t least_;
  std::uint64_t lines_ = 0;  ///< since the last one
};

/// Lines in a row, numbers `first_line` and on.
struct Segment {
  struct Kept {
    std::size_t begin, length;
    bool too_long;
  };

  std::uint64_t first_line = 0;
  std::string state;  ///< the line before it, which ends the segment before; empty: the header
  bool ends_at_border = false;
  std::uint64_t lines = 0;
  std::string text;  ///< of the lines, of an input that cannot be read again
  std::vector<Kept> kept;
  std::uint64_t place = 0;  ///< of its first line in any other
  bool goes_on = false;     ///< behind what is kept: the rest has not been read
};

class Segments {
 public:
  /// The lines of a file are read again by who wants them. Of any other input about `most_bytes` of a
  /// segment's lines are kept, and what is behind them is left unread.
  Segments(TraceInput& input, Borders borders, std::size_t most_bytes)
      : input_(input), borders_(borders), most_bytes_(most_bytes) {}

  /// REQUIRES that no segment before goes on. Nothing at the end of the trace.
  std::optional<Segment> next();

  using Visit = std::function<bool(const LineText&, std::uint64_t number)>;
  /// Goes through the lines of a segment, from any thread, until `visit` says no.
  void each_line(const Segment& segment, const Visit& visit) const;
  /// Goes through the unread rest of a segment that goes on. @return whether it ends at a border
  bool each_line_of_rest(Segment& segment, const Visit& visit);

 private:
  void keep(Segment& segment, const LineText& line) const;

  TraceInput& input_;
  Borders borders_;
  std::size_t most_bytes_;
  std::string state_;  ///< which the last segment ended with
};

}  // namespace tps::check

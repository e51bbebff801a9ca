// Lines of a stream, none of them longer than a limit.
#pragma once

#include <cstddef>
#include <istream>
#include <string>

namespace tps {

/// What std::getline does not say of the line it read.
struct LineRead {
  bool too_long = false;  ///< only its beginning was kept
  bool ended = false;     ///< by a line end, not by the end of the stream
};

/// Reads the next line without its end into `line`, at most `longest` bytes of it; what is longer is passed
/// over. False where nothing is left.
bool read_line(std::istream& in, std::string& line, std::size_t longest, LineRead& read);

}  // namespace tps

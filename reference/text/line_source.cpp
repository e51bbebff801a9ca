#include "reference/text/line_source.hpp"

#include <streambuf>

namespace tps {

bool read_line(std::istream& in, std::string& line, std::size_t longest, LineRead& read) {
  line.clear();
  read = {};
  std::streambuf& source = *in.rdbuf();
  constexpr int end = std::char_traits<char>::eof();
  int c = source.sbumpc();
  if (c == end) return false;
  for (; c != end && c != '\n'; c = source.sbumpc()) {
    if (line.size() < longest) {
      line.push_back(static_cast<char>(c));
    } else {
      read.too_long = true;
    }
  }
  read.ended = c == '\n';
  return true;
}

}  // namespace tps

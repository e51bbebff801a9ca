#include "verify/trace_check/segments.hpp"

#include <utility>

namespace tps::check {

void Segments::keep(Segment& segment, const LineText& line) const {
  segment.kept.push_back({segment.text.size(), line.text.size(), line.too_long});
  segment.text.append(line.text);
}

std::optional<Segment> Segments::next() {
  Segment segment;
  segment.state = std::exchange(state_, {});
  segment.first_line = input_.lines() + 1;
  segment.place = input_.place();
  const bool is_kept = !input_.can_be_reopened();
  LineText line;
  while (input_.next(line)) {
    ++segment.lines;
    if (is_kept) keep(segment, line);
    segment.ends_at_border = borders_.is_at(line);
    if (segment.ends_at_border) {
      state_.assign(line.text);
      break;
    }
    segment.goes_on = segment.text.size() >= most_bytes_;
    if (segment.goes_on) break;
  }
  if (segment.lines == 0) return std::nullopt;
  return segment;
}

void Segments::each_line(const Segment& segment, const Visit& visit) const {
  if (segment.kept.empty()) {
    TraceInput::Again again(input_, segment.place);
    for (std::uint64_t n = 0; n < segment.lines; ++n) {
      if (!visit(again.next(), segment.first_line + n)) return;
    }
    return;
  }
  const std::string_view text = segment.text;
  for (std::size_t n = 0; n < segment.kept.size(); ++n) {
    const Segment::Kept& line = segment.kept[n];
    if (!visit({text.substr(line.begin, line.length), line.too_long}, segment.first_line + n)) return;
  }
}

bool Segments::each_line_of_rest(Segment& segment, const Visit& visit) {
  segment.goes_on = false;
  LineText line;
  while (input_.next(line)) {
    ++segment.lines;
    const bool goes_on = visit(line, input_.lines());
    if (borders_.is_at(line)) {
      state_.assign(line.text);
      return true;
    }
    if (!goes_on) break;
  }
  return false;
}

}  // namespace tps::check

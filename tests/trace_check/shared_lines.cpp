#include "tests/trace_check/shared_lines.hpp"

#include <algorithm>

namespace tps::mutation {

Json& SharedLines::change(std::size_t n) {
  if (lines_[n].use_count() > 1) lines_[n] = std::make_shared<Line>(Line{lines_[n]->json, ""});
  lines_[n]->text.clear();
  return lines_[n]->json;
}

void SharedLines::insert(std::size_t before, Json line) {
  push_back(std::move(line));
  std::rotate(lines_.begin() + static_cast<std::ptrdiff_t>(before), lines_.end() - 1, lines_.end());
}

void SharedLines::erase(std::size_t n) {
  lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(n));
}

std::string SharedLines::text() const {
  std::string all;
  for (const auto& line : lines_) {
    if (line->text.empty()) line->text = line->json.dump() + '\n';
    all += line->text;
  }
  return all;
}

}  // namespace tps::mutation

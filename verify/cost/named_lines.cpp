#include "verify/cost/named_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "reference/text/printable.hpp"

namespace tps::cost {

std::string Names::style(const std::string& name) {
  constexpr int kMostDifferent[] = {0, 7, 3, 8, 1, 4, 10, 2, 6, 9, 5, 11};
  const auto found = std::find(names_.begin(), names_.end(), name);
  const auto index = static_cast<std::size_t>(found - names_.begin());
  if (found == names_.end()) names_.push_back(name);
  return fmt::format("series-{}", kMostDifferent[index % std::size(kMostDifferent)]);
}

void Lines::add(const std::string& name, Position at, const std::string& tip) {
  plot_.point(at, names_->style(name), "", name + ": " + tip);
  lines_[name].push_back(at);
}

std::string Lines::figure() {
  std::string key;
  for (const auto& [name, points] : lines_) {
    const std::string style = names_->style(name);
    if (are_drawn_) plot_.line(points, style);
    key += fmt::format("<span class=\"key {}\"></span> {} ", style, xml_text(name));
  }
  std::string text = plot_.figure();
  return text.insert(text.find("<details"), "<p class=\"lines\">" + key + "</p>");
}

std::string figures(std::vector<Lines> all) {
  std::string text = "<div class=\"figures\">\n";
  for (Lines& lines : all) text += lines.figure();
  return text + "</div>\n";
}

}  // namespace tps::cost

// Figures of rows of numbers, a line for each name.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "verify/cost/plot.hpp"

namespace tps::cost {

/// The names of a section's lines, so that one name has one colour in all of its figures.
class Names {
 public:
  /// series-0, series-1, … of the style sheet, those that differ most first.
  std::string style(const std::string& name);

 private:
  std::vector<std::string> names_;
};

/// A figure of one number of rows against another, with the key to its colours.
class Lines {
 public:
  Lines(Names& names, std::string title, Axis x, Axis y)
      : names_(&names), plot_(std::move(title), std::move(x), std::move(y)) {}

  /// Marks alone: what lies side by side is no row of numbers.
  Lines& without_lines() {
    are_drawn_ = false;
    return *this;
  }

  void add(const std::string& name, Position at, const std::string& tip);

  /// The element <figure>.
  std::string figure();

 private:
  Names* names_;
  Plot plot_;
  bool are_drawn_ = true;
  std::map<std::string, std::vector<Position>> lines_;
};

/// The figures of a section, side by side.
std::string figures(std::vector<Lines> all);

}  // namespace tps::cost

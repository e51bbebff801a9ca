// A figure in SVG: two axes, points and lines, each with its figures shown when it is pointed at or reached
// by the keyboard. No script: a style sheet shows the tips (page.cpp).
#pragma once

#include <string>
#include <vector>

namespace tps::cost {

/// One axis: linear in what it is given; ticks at whole numbers, written as a power of `base` (0: as they
/// are).
struct Axis {
  std::string title;
  double low, high;
  int base = 0;
  int every = 1;  ///< a tick each so many units
};

struct Position {
  double x, y;
};

/// A panel. A point outside of the axes is drawn at their edge.
class Plot {
 public:
  Plot(std::string title, Axis x, Axis y);

  /// `style` names the series in the style sheet. A mark that is `wrong` is a cross. A label that would stand
  /// on another one is left out.
  void point(Position at, const std::string& style, const std::string& label, const std::string& tip,
             bool wrong = false);
  void line(const std::vector<Position>& points, const std::string& style);

  /// The element <figure>: the picture under its title.
  std::string figure() const;

 private:
  Position pixel(Position at) const;
  bool has_room(Position label) const;
  std::string axes() const;

  std::string title_;
  Axis x_, y_;
  std::string lines_, points_;
  std::vector<Position> labels_;
};

}  // namespace tps::cost

// A figure of two axes, points and lines, as the data of a drawing: plots.js makes a Vega specification of
// it.
#pragma once

#include <nlohmann/json.hpp>
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
  /// on another one or on a mark is left out.
  void point(Position at, const std::string& style, const std::string& label, const std::string& tip,
             bool wrong = false);
  void line(const std::vector<Position>& points, const std::string& style);

  /// The element <figure>: title, the place of the picture, {"x": axis, "y": axis, "lines": [{"style", "at":
  /// [[x, y], …]}], "points": [[x, y, style, label, 1 if wrong else 0], …]} as a block of JSON, and the tips
  /// as a list, which needs no script.
  std::string figure() const;

 private:
  nlohmann::ordered_json place(Position at) const;

  std::string title_;
  Axis x_, y_;
  nlohmann::ordered_json lines_ = nlohmann::ordered_json::array();
  nlohmann::ordered_json points_ = nlohmann::ordered_json::array();
  std::string tips_;
};

}  // namespace tps::cost

// Shapes of an SVG picture in coordinates of the case.
#pragma once

#include <fmt/format.h>

#include <string>

namespace tps::properties::conform {

struct Point {
  double x, y;
};

/// A square about the origin. Styles are classes of the page's style sheet (report_html.cpp): limit, path,
/// body, right, found.
class Picture {
 public:
  /// `reach` is the largest coordinate that is drawn.
  explicit Picture(double reach) : scale_(0.45 * kSize / reach) {}

  void circle(const Point& at, double radius, const char* style) {
    const Point p = placed(at);
    shapes_ += fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}" class="{}"/>)", p.x, p.y,
                           radius * scale_, style);
  }
  void dot(const Point& at, const char* style, const std::string& label) {
    const Point p = placed(at);
    shapes_ += fmt::format(
        R"(<circle cx="{0:.1f}" cy="{1:.1f}" r="3" class="{2}"/><text x="{3:.1f}" y="{4:.1f}">{5}</text>)",
        p.x, p.y, style, p.x + 5, p.y - 5, label);
  }
  void line(const Point& from, const Point& to, const char* style) {
    const Point p = placed(from), q = placed(to);
    shapes_ += fmt::format(R"(<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}" class="{}"/>)", p.x, p.y,
                           q.x, q.y, style);
  }
  /// A vector from the origin, its end named.
  void arrow(const Point& to, const char* style, const std::string& label) {
    line({0, 0}, to, style);
    dot(to, style, label);
  }
  std::string svg() const {
    return fmt::format(R"(<svg viewBox="0 0 {0} {0}" width="{0}" height="{0}">{1}</svg>)", kSize, shapes_);
  }

 private:
  static constexpr double kSize = 240;  // in its own units

  Point placed(const Point& p) const { return {kSize / 2 + scale_ * p.x, kSize / 2 - scale_ * p.y}; }

  double scale_;
  std::string shapes_;
};

}  // namespace tps::properties::conform

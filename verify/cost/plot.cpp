#include "verify/cost/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reference/text/printable.hpp"

namespace tps::cost {
namespace {

constexpr double kWidth = 460, kHeight = 310;
constexpr double kLeft = 58, kRight = 448, kTop = 24, kBottom = 266;

std::string tick_label(const Axis& axis, int n) {
  if (axis.base == 0) return fmt::format("{}", n);
  return fmt::format("{}<tspan class=\"power\" dy=\"-4\">{}</tspan>", axis.base, n);
}

std::vector<int> ticks(const Axis& axis) {
  std::vector<int> result;
  const int first = static_cast<int>(std::ceil(axis.low / axis.every)) * axis.every;
  for (int n = first; n <= axis.high; n += axis.every) result.push_back(n);
  return result;
}

double place(const Axis& axis, double value, double from, double to) {
  const double part = std::clamp((value - axis.low) / (axis.high - axis.low), 0.0, 1.0);
  return from + part * (to - from);
}

}  // namespace

Plot::Plot(std::string title, Axis x, Axis y)
    : title_(std::move(title)), x_(std::move(x)), y_(std::move(y)) {}

Position Plot::pixel(Position at) const {
  return {place(x_, at.x, kLeft, kRight), place(y_, at.y, kBottom, kTop)};
}

bool Plot::has_room(Position label) const {
  constexpr double kWide = 20, kHigh = 9;  // of a label
  return std::none_of(labels_.begin(), labels_.end(), [&](Position other) {
    return std::fabs(other.x - label.x) < kWide && std::fabs(other.y - label.y) < kHigh;
  });
}

void Plot::point(Position at, const std::string& style, const std::string& label, const std::string& tip,
                 bool wrong) {
  const Position p = pixel(at);
  const std::string mark = wrong ? fmt::format("<path class=\"cross\" d=\"M{0:.1f} {1:.1f}l7 7m-7 0l7 -7\"/>",
                                               p.x - 3.5, p.y - 3.5)
                                 : fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.6\"/>", p.x, p.y);
  const bool is_labelled = !label.empty() && has_room(p);
  if (is_labelled) labels_.push_back(p);
  const std::string words = !is_labelled
                                ? ""
                                : fmt::format("<text class=\"label\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>",
                                              p.x + 5, p.y - 5, xml_text(label));
  points_ += fmt::format(
      "<g class=\"mark {0}\" tabindex=\"0\" role=\"img\" aria-label=\"{1}\">"
      "<circle class=\"reach\" cx=\"{2:.1f}\" cy=\"{3:.1f}\" r=\"8\"/>{4}{5}"
      "<text class=\"tip\" x=\"{6}\" y=\"12\">{1}</text></g>\n",
      style, xml_text(tip), p.x, p.y, mark, words, kLeft);
}

void Plot::line(const std::vector<Position>& points, const std::string& style) {
  if (points.size() < 2) return;
  lines_ += fmt::format("<polyline class=\"line {}\" points=\"", style);
  for (const Position& at : points) {
    const Position p = pixel(at);
    lines_ += fmt::format("{:.1f},{:.1f} ", p.x, p.y);
  }
  lines_ += "\"/>\n";
}

std::string Plot::axes() const {
  std::string text;
  for (const int n : ticks(x_)) {
    const double x = pixel({static_cast<double>(n), y_.low}).x;
    text += fmt::format(
        "<line class=\"grid\" x1=\"{0:.1f}\" y1=\"{1}\" x2=\"{0:.1f}\" y2=\"{2}\"/>"
        "<text class=\"tick\" text-anchor=\"middle\" x=\"{0:.1f}\" y=\"{3}\">{4}</text>\n",
        x, kTop, kBottom, kBottom + 17, tick_label(x_, n));
  }
  for (const int n : ticks(y_)) {
    const double y = pixel({x_.low, static_cast<double>(n)}).y;
    text += fmt::format(
        "<line class=\"grid\" x1=\"{0}\" y1=\"{1:.1f}\" x2=\"{2}\" y2=\"{1:.1f}\"/>"
        "<text class=\"tick\" text-anchor=\"end\" x=\"{3}\" y=\"{4:.1f}\">{5}</text>\n",
        kLeft, y, kRight, kLeft - 6, y + 4, tick_label(y_, n));
  }
  text += fmt::format("<text class=\"axis\" text-anchor=\"middle\" x=\"{}\" y=\"{}\">{}</text>\n",
                      (kLeft + kRight) / 2, kHeight - 8, xml_text(x_.title));
  text += fmt::format(
      "<text class=\"axis\" text-anchor=\"middle\" transform=\"translate(14 {}) rotate(-90)\">{}</text>\n",
      (kTop + kBottom) / 2, xml_text(y_.title));
  return text;
}

std::string Plot::figure() const {
  return fmt::format(
      "<figure><figcaption>{0}</figcaption>\n<svg viewBox=\"0 0 {1} {2}\" role=\"group\" "
      "aria-label=\"{0}\">\n{3}{4}{5}</svg>"
      "</figure>\n",
      xml_text(title_), kWidth, kHeight, axes(), lines_, points_);
}

}  // namespace tps::cost

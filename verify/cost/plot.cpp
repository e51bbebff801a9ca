#include "verify/cost/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reference/text/printable.hpp"
#include "verify/view/safe_page.hpp"

namespace tps::cost {
namespace {

using Json = nlohmann::ordered_json;

Json axis_json(const Axis& axis) {
  Json ticks = Json::array();
  const int first = static_cast<int>(std::ceil(axis.low / axis.every)) * axis.every;
  for (int n = first; n <= axis.high; n += axis.every) ticks.push_back(n);
  return {
      {"title", axis.title}, {"low", axis.low}, {"high", axis.high}, {"base", axis.base}, {"ticks", ticks}};
}

/// Within the axis, to a thousandth of a pixel or so: shorter numbers are a smaller page.
double coordinate(const Axis& axis, double value) {
  const double digits = std::pow(10.0, std::max(0.0, 5 - std::floor(std::log10(axis.high - axis.low))));
  return std::round(std::clamp(value, axis.low, axis.high) * digits) / digits;
}

}  // namespace

Plot::Plot(std::string title, Axis x, Axis y)
    : title_(std::move(title)), x_(std::move(x)), y_(std::move(y)) {}

Json Plot::place(Position at) const {
  return {coordinate(x_, at.x), coordinate(y_, at.y)};
}

void Plot::point(Position at, const std::string& style, const std::string& label, const std::string& tip,
                 bool wrong) {
  Json point = place(at);
  for (const std::string& text : {style, label}) point.push_back(text);
  point.push_back(wrong ? 1 : 0);
  points_.push_back(std::move(point));
  tips_ += fmt::format("<li>{}</li>\n", xml_text(tip));
}

void Plot::line(const std::vector<Position>& points, const std::string& style) {
  if (points.size() < 2) return;
  Json places = Json::array();
  for (const Position& at : points) places.push_back(place(at));
  lines_.push_back({{"style", style}, {"at", std::move(places)}});
}

std::string Plot::figure() const {
  const Json data{{"x", axis_json(x_)}, {"y", axis_json(y_)}, {"lines", lines_}, {"points", points_}};
  return fmt::format(
      "<figure><figcaption>{}</figcaption><p class=\"tip\" aria-hidden=\"true\"></p>\n<div "
      "class=\"plot\"></div>"
      "<script type=\"application/json\">{}</script>\n<details class=\"lines\"><summary>every "
      "number</summary>"
      "<ul>\n{}</ul></details></figure>\n",
      xml_text(title_), view::embedded(data), tips_);
}

}  // namespace tps::cost

#include "properties/conform/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "properties/conform/mistakes.hpp"

namespace tps::properties::conform {
namespace {

constexpr double kSize = 240;  // of a picture, in its own units

struct Point {
  double x, y;
};

/// r and v of a pair as coordinates of the plane that they span: x along r, y so that v has none below it.
struct Plane {
  Vec e, f;

  Plane(const Vec& r, const Vec& v) : e(r), f(v) {
    if (norm(e) == 0) e = v;
    if (norm(e) > 0) e = (1 / norm(e)) * e;
    f = v - dot(v, e) * e;
    f = norm(f) > 0 ? (1 / norm(f)) * f : 0.0 * f;
  }
  Point of(const Vec& x) const { return {dot(x, e), dot(x, f)}; }
};

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
  std::string svg() const {
    return fmt::format(R"(<svg viewBox="0 0 {0} {0}" width="{0}" height="{0}">{1}</svg>)", kSize, shapes_);
  }

 private:
  Point placed(const Point& p) const { return {kSize / 2 + scale_ * p.x, kSize / 2 - scale_ * p.y}; }

  double scale_;
  std::string shapes_;
};

std::optional<double> time_in(const Json& answer) {
  const Json t = answer.value("t", Json());
  const auto numbers = t.is_null() ? std::nullopt : numbers_of(t);
  return numbers && !numbers->empty() && std::isfinite(numbers->front()) ? std::optional(numbers->front())
                                                                         : std::nullopt;
}

std::string timing(const Given& g, const Json& found, const Json& right) {
  const Vec r = g.r(), v = g.v();
  const Plane plane(r, v);
  const auto at = [&](double t) { return plane.of(r + t * v); };
  const auto t_found = time_in(found), t_right = time_in(right);
  double reach = std::max(norm(r), g.number("L"));
  for (const auto& t : {t_found, t_right}) {
    if (t) reach = std::max(reach, std::hypot(at(*t).x, at(*t).y));
  }
  if (!std::isfinite(reach) || reach == 0) return {};
  Picture picture(reach);
  picture.circle({0, 0}, g.number("L"), "limit");
  const double ahead = norm(v) > 0 ? 2 * reach / norm(v) : 0;
  picture.line(at(0), at(ahead), "path");
  picture.dot({0, 0}, "body", "A");
  picture.dot(at(0), "body", "B");
  if (t_right) picture.dot(at(*t_right), "right", "right");
  if (t_found) picture.dot(at(*t_found), "found", "found");
  return picture.svg();
}

std::string impulse(const Given& g, const Json& found, const Json& right) {
  const auto dp_found = numbers_of(found.value("dp", Json())),
             dp_right = numbers_of(right.value("dp", Json()));
  if (!dp_found || !dp_right || dp_found->size() != dp_right->size()) return {};
  const Vec r = g.r(), v = g.v();
  const Plane plane(r, v);
  // Directions and their ratios: lengths, speeds and impulses have no common scale.
  const double longest = std::max(norm(*dp_found), norm(*dp_right));
  if (!(norm(r) > 0 && norm(v) > 0 && longest > 0) || !std::isfinite(longest)) return {};
  Picture picture(1);
  picture.line({-1, 0}, {1, 0}, "path");
  const Point speed = plane.of((0.8 / norm(v)) * v);
  picture.line({0, 0}, speed, "path");
  picture.dot(speed, "body", "v_AB");
  picture.dot({0, 0}, "body", "");
  for (const bool is_right : {true, false}) {
    const Point end = plane.of((0.7 / longest) * (is_right ? *dp_right : *dp_found));
    picture.line({0, 0}, end, is_right ? "right" : "found");
    picture.dot(end, is_right ? "right" : "found", is_right ? "right" : "found");
  }
  return picture.svg();
}

}  // namespace

std::string drawing_of(const Example& example) {
  if (example.in.empty() || example.found.empty()) return {};
  try {
    const Json in = Json::parse(example.in), found = Json::parse(example.found),
               right = Json::parse(example.right);
    if (!found.is_object() || !in.contains("u_A")) return {};
    const Given given(in);
    return in.contains("L") ? timing(given, found, right) : impulse(given, found, right);
  } catch (const std::exception&) {
    return {};  // not a pair, or no numbers
  }
}

}  // namespace tps::properties::conform

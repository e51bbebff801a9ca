#include "properties/conform/drawing.hpp"

#include <algorithm>
#include <cmath>

#include "properties/conform/picture.hpp"

namespace tps::properties::conform {
namespace {

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
  const Vec r = g.r(), v = g.v();
  const Plane plane(r, v);
  if (!(norm(r) > 0 && norm(v) > 0)) return {};
  // Directions and their ratios: lengths, speeds and impulses have no common scale.
  Picture picture(1);
  picture.line({-1, 0}, {1, 0}, "path");
  picture.arrow(plane.of((0.8 / norm(v)) * v), "path", "v_AB");
  picture.dot({0, 0}, "body", "");
  double longest = 0;
  for (const auto& dp : {dp_found, dp_right}) {
    if (dp && dp->size() == r.size()) longest = std::max(longest, norm(*dp));
  }
  if (!(longest > 0) || !std::isfinite(longest)) return picture.svg();
  if (dp_right && dp_right->size() == r.size())
    picture.arrow(plane.of((0.7 / longest) * *dp_right), "right", "right");
  if (dp_found && dp_found->size() == r.size())
    picture.arrow(plane.of((0.7 / longest) * *dp_found), "found", "found");
  return picture.svg();
}

/// What is given and what comes out of eqs. (3), (6), (7), as vectors in the plane of v_A and v_B.
std::string vectors(const Given& g, const Json& found, const Json& right) {
  const Vec v_A = g.vec("v_A"), v_B = g.vec("v_B");
  const Plane plane(v_A, v_B);
  struct Arrow {
    Point to;
    const char* style;
    std::string label;
  };
  std::vector<Arrow> arrows{{plane.of(v_A), "path", "v_A"}, {plane.of(v_B), "path", "v_B"}};
  for (const bool is_right : {true, false}) {
    const Json& answer = is_right ? right : found;
    for (const char* key : {"v_A", "v_B", "v_load", "dp_AB"}) {
      const auto x = numbers_of(answer.value(key, Json()));
      if (answer.contains(key) && x && x->size() == v_A.size())
        arrows.push_back({plane.of(*x), is_right ? "right" : "found", key});
    }
  }
  double reach = 0;
  for (const Arrow& arrow : arrows) reach = std::max(reach, std::hypot(arrow.to.x, arrow.to.y));
  if (!(reach > 0) || !std::isfinite(reach)) return {};
  Picture picture(reach);
  for (const Arrow& arrow : arrows) picture.arrow(arrow.to, arrow.style, arrow.label);
  return picture.svg();
}

/// Across the plane along x, the flight in the page.
std::string wall(const Given& g, const Json& found, const Json& right) {
  const Vec r = g.r(), v = g.v();
  const Plane plane(g.vec("normal"), v);
  const auto at = [&](double t) { return plane.of(r + t * v); };
  double reach = std::max({norm(r), g.number("L"), std::fabs(at(0).x), std::fabs(at(0).y)});
  const auto t_found = time_in(found), t_right = time_in(right);
  for (const auto& t : {t_found, t_right}) {
    if (t) reach = std::max({reach, std::fabs(at(*t).x), std::fabs(at(*t).y)});
  }
  if (!std::isfinite(reach) || reach == 0) return {};
  Picture picture(reach);
  picture.line({0, -reach}, {0, reach}, "body");
  picture.line({g.number("L"), -reach}, {g.number("L"), reach}, "limit");
  picture.line(at(0), at(norm(v) > 0 ? 2 * reach / norm(v) : 0), "path");
  picture.dot(at(0), "body", "B");
  if (t_right) picture.dot(at(*t_right), "right", "right");
  if (t_found) picture.dot(at(*t_found), "found", "found");
  return picture.svg();
}

/// Times on a line that begins at 0.
std::string time_line(const Given& g, const Json& found, const Json& right) {
  const auto t_found = time_in(found), t_right = time_in(right);
  const double reach = std::max({g.number("s"), t_right.value_or(0), std::fabs(t_found.value_or(0))});
  if (!std::isfinite(reach) || reach == 0) return {};
  Picture picture(reach);
  picture.line({0, 0}, {reach, 0}, "path");
  picture.dot({g.number("s"), 0}, "body", "s");
  if (t_right) picture.dot({*t_right, 0}, "right", "right");
  if (t_found) picture.dot({*t_found, 0}, "found", "found");
  return picture.svg();
}

std::string drawn(const Json& in, const Json& found, const Json& right) {
  if (in.contains("scene")) return drawing_of_scene(in.at("scene"), found, right);
  if (in.contains("bodies")) return drawing_of_group(in, found, right);
  if (in.contains("first")) {
    const Json none = Json::object();
    return timing(Given(in.at("first")), none, none) + timing(Given(in.at("second")), none, none);
  }
  const Given given(in);
  if (in.contains("normal")) return wall(given, found, right);
  if (in.contains("gamma")) return time_line(given, found, right);
  if (in.contains("L")) return timing(given, found, right);
  return in.contains("u_A") ? impulse(given, found, right) : vectors(given, found, right);
}

/// An answer, or nothing where there is none to show.
Json object_in(const std::string& text) {
  const Json value = text.empty() ? Json() : Json::parse(text);
  return value.is_object() ? value : Json::object();
}

}  // namespace

std::string drawing_of(const Example& example) {
  if (example.in.empty()) return {};
  try {
    return drawn(Json::parse(example.in), object_in(example.found), object_in(example.right));
  } catch (const std::exception&) {
    return {};  // no numbers
  }
}

}  // namespace tps::properties::conform

#include "properties/generators/pairs.hpp"

#include <cmath>

#include "properties/generators/numbers.hpp"

namespace tps::properties {
namespace {

Vec3 operator+(const Vec3& a, const Vec3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vec3 operator*(double s, const Vec3& a) {
  return {s * a[0], s * a[1], s * a[2]};
}

/// Perpendicular vectors of one length, which is `length` exactly where they are integers.
struct Axes {
  Vec3 along, across;
  double length;
};

/// A Pythagorean triple in one of the coordinate planes.
Axes exact_axes(int dimension) {
  struct Triple {
    double p, q, hypotenuse;
  };
  const Triple t =
      one_of({Triple{1, 0, 1}, Triple{0, 1, 1}, Triple{3, 4, 5}, Triple{-12, 5, 13}, Triple{8, -15, 17}});
  const auto first = static_cast<std::size_t>(whole(0, dimension));
  const auto second = (first + 1) % static_cast<std::size_t>(dimension);
  Axes axes{{}, {}, t.hypotenuse};
  axes.along[first] = t.p;
  axes.along[second] = t.q;
  axes.across[first] = -t.q;
  axes.across[second] = t.p;
  return axes;
}

/// Any direction, and one across it; unit vectors to rounding.
Axes rounded_axes(const Format& format, int dimension) {
  Vec3 n = vector(format, dimension);
  const double length = std::hypot(n[0], n[1], n[2]);
  if (length == 0) return exact_axes(dimension);
  n = (1 / length) * n;
  const Vec3 axis = dimension == 2         ? Vec3{-n[1], n[0], 0}
                    : std::abs(n[0]) < 0.7 ? Vec3{1, 0, 0}
                                           : Vec3{0, 1, 0};
  const double share = axis[0] * n[0] + axis[1] * n[1] + axis[2] * n[2];
  const Vec3 w = axis + (-share) * n;
  return {n, (1 / std::hypot(w[0], w[1], w[2])) * w, 1};
}

/// A relative state (r, v).
struct Relative {
  Vec3 r, v;
};

Relative aimed(const std::string& hazard, const Axes& axes, double unit, double speed, const Format& format) {
  const Vec3& n = axes.along;
  const Vec3& w = axes.across;
  const double distance = unit * magnitude(format);
  if (hazard == "graze") {
    const double side = one_of({-1.0, 1.0});
    const double offset = std::ldexp(side, -whole(4, format.bits + 1));
    return {(-distance) * n + (unit * (1 + offset)) * w, speed * n};
  }
  if (hazard == "tangent") return {(-distance) * n + unit * w, speed * n};
  if (hazard == "touch") return {unit * n, (-speed) * (n + one_of({0.0, 1.0, -3.0}) * w)};
  if (hazard == "taut") return {unit * n, speed * w};
  if (hazard == "head_on") return {(-(unit + distance)) * n, speed * n};
  if (hazard == "static") return {(unit + distance) * n, {}};
  if (hazard == "far") return {std::ldexp(-unit, 20) * n + (unit / 2) * w, speed * n};
  if (hazard == "near") return {std::ldexp(unit, -whole(10, 30)) * n, speed * (w + n)};
  if (hazard == "inside") return {(unit / 2) * n, speed * (n + one_of({-2.0, 0.0, 0.5}) * w)};
  return {(-unit * one_of({1.0, 1.5, 3.0})) * n + (unit / 4) * w, speed * (n + (-0.25) * w)};
}

Vec3 in_format(const Format& format, const Vec3& x) {
  return {format.rounded(x[0]), format.rounded(x[1]), format.rounded(x[2])};
}

AimedPair general(const Format& format, int dimension) {
  const auto any = [&] { return vector(format, dimension); };
  const Vec3 u_A = any(), u_B = any(), v_A = any(), v_B = any();
  return {{u_A, u_B, v_A, v_B}, magnitude(format)};
}

AimedPair integers(int dimension) {
  const auto any = [dimension] {
    Vec3 x{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) x[k] = whole(-12, 13);
    return x;
  };
  const double unit = std::ldexp(1.0, one_of({0, 0, 0, -2, 5}));
  const double speed = std::ldexp(1.0, one_of({0, 0, 0, -3, 4}));
  return {{unit * any(), unit * any(), speed * any(), speed * any()}, unit * whole(1, 16)};
}

}  // namespace

const std::vector<std::string>& pair_hazards() {
  static const std::vector<std::string> names{"general", "integers", "graze", "tangent", "touch",  "taut",
                                              "head_on", "static",   "far",   "near",    "inside", "passing"};
  return names;
}

AimedPair pair_aimed_at(const std::string& hazard, const Format& format, int dimension) {
  if (hazard == "general") return general(format, dimension);
  if (hazard == "integers") return integers(dimension);
  const bool exact = coin();
  const Axes axes = exact ? exact_axes(dimension) : rounded_axes(format, dimension);
  const double unit = exact ? std::ldexp(1.0, whole(-4, 5)) : magnitude(format);
  const double speed = exact ? std::ldexp(1.0, whole(-4, 5)) : magnitude(format);
  const Relative x = aimed(hazard, axes, unit, speed, format);
  const bool at_rest = coin();
  const Vec3 u_A = at_rest ? Vec3{} : in_format(format, vector(format, dimension));
  const Vec3 v_A = at_rest ? Vec3{} : in_format(format, vector(format, dimension));
  return AimedPair{{u_A, in_format(format, u_A + x.r), v_A, in_format(format, v_A + x.v)},
                   format.rounded(unit * axes.length)};
}

void put_pair(Case& c, const Format& format) {
  c.dimension = whole(2, 4);
  c.hazard = one_of(pair_hazards());
  const AimedPair aim = pair_aimed_at(c.hazard, format, c.dimension);
  c.set(aim.pair);
  c.set("L", aim.L);
}

void put_integer_pair(Case& c) {
  c.dimension = whole(2, 4);
  c.hazard = "integers";
  const AimedPair aim = integers(c.dimension);
  c.set(aim.pair);
  c.set("L", aim.L);
}

}  // namespace tps::properties

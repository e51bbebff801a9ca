// Eq. (2) in plain doubles, for the mistakes in it.
#pragma once

#include <optional>

#include "properties/conform/mistakes.hpp"

namespace tps::properties::conform {

struct Quadratic {
  double a, h, c, D;

  explicit Quadratic(const Given& g) : Quadratic(g.r(), g.v(), g.number("L")) {}
  Quadratic(const Vec& r, const Vec& v, double L)
      : a(dot(v, v)), h(dot(r, v)), c(dot(r, r) - L * L), D(h * h - a * c) {}

  bool has_roots() const { return a > 0 && D >= 0; }
  double smaller() const { return (-h - std::sqrt(D)) / a; }
  double larger() const { return (-h + std::sqrt(D)) / a; }
  /// D1's literal rule.
  std::optional<double> literal() const {
    if (!has_roots() || larger() < 0) return std::nullopt;
    return smaller() >= 0 ? smaller() : larger();
  }
};

/// The answer to a timing query that names these verdicts or none.
inline Mistaken at(std::optional<double> t, std::vector<std::string> verdicts = {}) {
  return {{{"t", t ? Vec{*t} : Vec{}}}, {}, std::move(verdicts)};
}

}  // namespace tps::properties::conform

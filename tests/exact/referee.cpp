#include "tests/exact/referee.hpp"

namespace tps::exact::referee {

Quadratic quadratic(const TimingQuery& query) {
  Quadratic q{0, 0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational r = Rational(query.u_B[k]) - Rational(query.u_A[k]);
    const Rational v = Rational(query.v_B[k]) - Rational(query.v_A[k]);
    q.a += v * v;
    q.h += r * v;
    q.c += r * r;
  }
  q.c -= Rational(query.L) * Rational(query.L);
  q.D = q.h * q.h - q.a * q.c;
  return q;
}

std::string verdict(const TimingQuery& query, const Quadratic& exact) {
  const auto& [a, h, c, D] = exact;
  if (a == 0) return "static";
  if (query.kind == Kind::block) {
    if (h >= 0) return "receding";
    if (c <= 0) return c < 0 ? "overlap" : "contact";
    if (D <= 0) return D < 0 ? "miss" : "tangent";
    return "hit";
  }
  if (c < 0) return "hit";
  if (c == 0) return h >= 0 ? "taut" : "hit";
  if (h >= 0) return "overstretched";
  return D > 0 ? "hit" : "turning";
}

std::string verdict(const TimingQuery& query) {
  return verdict(query, quadratic(query));
}

std::optional<Wide> time(const TimingQuery& query) {
  const Quadratic exact = quadratic(query);
  const std::string which = verdict(query, exact);
  if (which == "static" || which == "receding" || which == "miss" || which == "tangent") return std::nullopt;
  if (which != "hit" && which != "turning") return Wide(0);
  if (which == "turning") return Wide(Rational(-exact.h / exact.a));
  // D is exact before its root is taken, and the form is chosen so that the sum does not cancel: queries that
  // span all exponents of double would cancel more than 1500 digits.
  const Wide root = sqrt(Wide(exact.D));
  const Wide h(exact.h);
  if ((query.kind == Kind::block) || exact.h > 0) {
    const Wide sum = query.kind == Kind::block ? Wide(root - h) : Wide(-root - h);
    return Wide(exact.c) / sum;
  }
  return (root - h) / Wide(exact.a);
}

}  // namespace tps::exact::referee

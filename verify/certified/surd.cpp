#include "verify/certified/surd.hpp"

namespace tps::certified {
namespace {

std::optional<Integer> integer_root(const Integer& x) {
  if (x < 0) return std::nullopt;
  const Integer root = sqrt(x);
  if (root * root != x) return std::nullopt;
  return root;
}

}  // namespace

std::optional<Rational> rational_root(const Rational& x) {
  const std::optional<Integer> n = integer_root(numerator(x));
  if (!n) return std::nullopt;
  const std::optional<Integer> d = integer_root(denominator(x));
  if (!d) return std::nullopt;
  return Rational(*n, *d);
}

SurdOrRational simplified(const Rational& a, const Rational& b, const Rational& D) {
  if (b == 0) return a;
  return Surd{a, b, D};
}

std::optional<Surd> over_root(const Surd& x, const Rational& D) {
  if (x.D == D) return x;
  const std::optional<Rational> ratio = rational_root(x.D / D);
  if (!ratio) return std::nullopt;
  return Surd{x.a, x.b * *ratio, D};
}

SurdOrRational sum(const Surd& x, const Surd& y) {
  return simplified(x.a + y.a, x.b + y.b, x.D);
}

SurdOrRational product(const Surd& x, const Surd& y) {
  return simplified(x.a * y.a + x.b * y.b * x.D, x.a * y.b + x.b * y.a, x.D);
}

Surd inverse(const Surd& x) {
  const Rational norm = x.a * x.a - x.b * x.b * x.D;  // not zero: √D is irrational
  return {x.a / norm, -x.b / norm, x.D};
}

Sign sign(const Surd& x) {
  const bool root_wins = x.b * x.b * x.D > x.a * x.a;
  return (root_wins ? x.b : x.a) > 0 ? Sign::positive : Sign::negative;
}

std::optional<SurdOrRational> root_within(const Surd& x) {
  // (p + q√D)² = x: p² + q²D = a and 2pq = b, so p² = (a ± √(a² − b²D))/2.
  const std::optional<Rational> norm_root = rational_root(x.a * x.a - x.b * x.b * x.D);
  if (!norm_root) return std::nullopt;
  for (const Rational& half_norm : {*norm_root, Rational(-*norm_root)}) {
    const std::optional<Rational> p = rational_root((x.a + half_norm) / 2);
    if (!p || *p == 0) continue;
    const Surd root{*p, x.b / (2 * *p), x.D};
    if (sign(root) == Sign::positive) return root;
    return Surd{-root.a, -root.b, root.D};
  }
  return std::nullopt;
}

}  // namespace tps::certified

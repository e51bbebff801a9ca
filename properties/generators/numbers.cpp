#include "properties/generators/numbers.hpp"

#include <cmath>
#include <limits>

namespace tps::properties {
namespace {

/// Uniform in [0, 1): 53 random bits, of which a shrink takes away.
rc::Gen<double> fraction() {
  return rc::gen::map(rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << 53),
                      [](std::int64_t bits) { return std::ldexp(static_cast<double>(bits), -53); });
}

rc::Gen<double> magnitude() {
  return rc::gen::weightedOneOf<double>(
      {{2, rc::gen::just(1.0)},
       {2, rc::gen::map(rc::gen::inRange(-60, 60), [](int k) { return std::ldexp(1.0, k); })},
       {1, rc::gen::map(rc::gen::inRange(-50, 50),
                        [](int k) { return std::nextafter(std::ldexp(1.0, k), 0.0); })},
       {1, rc::gen::map(rc::gen::inRange(-50, 50),
                        [](int k) { return std::nextafter(std::ldexp(1.0, k), 1e300); })},
       {2, rc::gen::map(rc::gen::inRange(1, 100), [](int tenths) { return tenths / 10.0; })},
       {4, rc::gen::map(fraction(), [](double x) { return x + 0.5; })},
       {2, rc::gen::map(rc::gen::pair(fraction(), rc::gen::inRange(-30, 30)),
                        [](const std::pair<double, int>& p) { return std::ldexp(p.first + 1, p.second); })}});
}

rc::Gen<Masses> pair_of(const rc::Gen<double>& first) {
  const rc::Gen<Masses> apart = rc::gen::map(rc::gen::pair(first, finite_mass()), [](const auto& m) {
    return Masses{m.first, m.second};
  });
  const rc::Gen<Masses> swapped = rc::gen::map(apart, [](const Masses& m) { return Masses{m.B, m.A}; });
  const rc::Gen<Masses> equal = rc::gen::map(finite_mass(), [](double m) { return Masses{m, m}; });
  return rc::gen::weightedOneOf<Masses>({{2, apart}, {2, swapped}, {1, equal}});
}

}  // namespace

rc::Gen<double> number() {
  return rc::gen::weightedOneOf<double>({{1, rc::gen::just(0.0)},
                                         {5, magnitude()},
                                         {5, rc::gen::map(magnitude(), [](double x) { return -x; })}});
}

rc::Gen<double> coefficient() {
  return rc::gen::weightedOneOf<double>({{1, rc::gen::just(0.0)},
                                         {1, rc::gen::just(1.0)},
                                         {1, rc::gen::element(0.5, 0.9, 1e-9)},
                                         {3, fraction()}});
}

rc::Gen<double> revolve_angle() {
  return rc::gen::weightedOneOf<double>({{1, rc::gen::element(1.0, 30.0, 45.0, 60.0, 89.0)},
                                         {1, rc::gen::map(fraction(), [](double x) { return 1 + 88 * x; })}});
}

rc::Gen<double> finite_mass() {
  return rc::gen::weightedOneOf<double>(
      {{1, rc::gen::just(1.0)},
       {1, rc::gen::element(1e-9, 1e-3, 1e3, 1e9)},
       {3, rc::gen::map(rc::gen::pair(fraction(), rc::gen::inRange(-29, 29)),
                        [](const auto& p) { return std::ldexp(p.first + 1, p.second); })}});
}

rc::Gen<double> mass() {
  return rc::gen::weightedOneOf<double>(
      {{1, rc::gen::just(std::numeric_limits<double>::infinity())}, {4, finite_mass()}});
}

rc::Gen<Masses> masses() {
  return pair_of(mass());
}
rc::Gen<Masses> finite_masses() {
  return pair_of(finite_mass());
}

}  // namespace tps::properties

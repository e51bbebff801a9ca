#include "properties/generators/numbers.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

namespace tps::properties {
namespace {

/// Uniform in [0, 1).
rc::Gen<double> fraction() {
  return rc::gen::map(rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << 53),
                      [](std::int64_t bits) { return std::ldexp(static_cast<double>(bits), -53); });
}

rc::Gen<double> in_format(const Format& format, rc::Gen<double> gen) {
  return rc::gen::map(std::move(gen), [format](double x) { return format.rounded(x); });
}

rc::Gen<double> any_significand(int exponent) {
  return rc::gen::map(rc::gen::pair(fraction(), rc::gen::inRange(-exponent, exponent)),
                      [](const std::pair<double, int>& p) { return std::ldexp(p.first + 1, p.second); });
}

rc::Gen<Masses> pair_of(const Format& format, const rc::Gen<double>& first) {
  const rc::Gen<Masses> apart = rc::gen::map(rc::gen::pair(first, finite_mass(format)), [](const auto& m) {
    return Masses{m.first, m.second};
  });
  const rc::Gen<Masses> swapped = rc::gen::map(apart, [](const Masses& m) { return Masses{m.B, m.A}; });
  const rc::Gen<Masses> equal = rc::gen::map(finite_mass(format), [](double m) { return Masses{m, m}; });
  return rc::gen::weightedOneOf<Masses>({{2, apart}, {2, swapped}, {1, equal}});
}

}  // namespace

rc::Gen<double> magnitude(const Format& format) {
  const int e = format.largest_case_exponent();
  const double next = std::ldexp(1.0, 1 - format.bits);  // relative distance to the next number
  const auto power = [](int k) { return std::ldexp(1.0, k); };
  return in_format(
      format,
      rc::gen::weightedOneOf<double>(
          {{2, rc::gen::just(1.0)},
           {2, rc::gen::map(rc::gen::inRange(-e, e), power)},
           {1, rc::gen::map(rc::gen::inRange(-e, e), [=](int k) { return power(k) * (1 - next / 2); })},
           {1, rc::gen::map(rc::gen::inRange(-e, e), [=](int k) { return power(k) * (1 + next); })},
           {2, rc::gen::map(rc::gen::inRange(1, 100), [](int tenths) { return tenths / 10.0; })},
           {2, rc::gen::map(rc::gen::inRange(1, 20), [](int n) { return static_cast<double>(n); })},
           {4, rc::gen::map(fraction(), [](double x) { return x + 0.5; })},
           {2, any_significand(e / 2)}}));
}

rc::Gen<double> number(const Format& format) {
  return rc::gen::weightedOneOf<double>({{1, rc::gen::just(0.0)},
                                         {5, magnitude(format)},
                                         {5, rc::gen::map(magnitude(format), [](double x) { return -x; })}});
}

rc::Gen<double> small_integer() {
  return rc::gen::map(rc::gen::pair(rc::gen::inRange(-12, 13), rc::gen::element(0, 0, 0, -1, 3)),
                      [](const auto& p) { return std::ldexp(static_cast<double>(p.first), p.second); });
}

rc::Gen<double> coefficient(const Format& format) {
  return in_format(format, rc::gen::weightedOneOf<double>({{1, rc::gen::just(0.0)},
                                                           {1, rc::gen::just(1.0)},
                                                           {1, rc::gen::element(0.5, 0.9, 1e-9)},
                                                           {3, fraction()}}));
}

rc::Gen<double> revolve_angle(const Format& format) {
  return in_format(format, rc::gen::weightedOneOf<double>(
                               {{1, rc::gen::element(1.0, 30.0, 45.0, 60.0, 89.0)},
                                {1, rc::gen::map(fraction(), [](double x) { return 1 + 88 * x; })}}));
}

rc::Gen<double> finite_mass(const Format& format) {
  const int e = format.bits <= 24 ? 12 : 50;  // 2^50 is 10^15
  return in_format(format,
                   rc::gen::weightedOneOf<double>({{1, rc::gen::just(1.0)},
                                                   {1, rc::gen::element(0.001, 0.5, 2.0, 3.0, 1000.0)},
                                                   {3, any_significand(e)}}));
}

rc::Gen<Masses> masses(const Format& format) {
  const rc::Gen<double> infinite = rc::gen::just(std::numeric_limits<double>::infinity());
  return pair_of(format, rc::gen::weightedOneOf<double>({{1, infinite}, {4, finite_mass(format)}}));
}

rc::Gen<Masses> finite_masses(const Format& format) {
  return pair_of(format, finite_mass(format));
}

rc::Gen<Vec3> vector(const Format& format, int dimension) {
  return rc::gen::exec([format, dimension] {
    const bool integers = *rc::gen::inRange(0, 4) == 0;
    Vec3 x{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
      x[k] = integers ? *small_integer() : *number(format);
    return x;
  });
}

}  // namespace tps::properties

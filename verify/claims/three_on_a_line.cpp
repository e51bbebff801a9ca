#include "verify/claims/three_on_a_line.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/mpfr.hpp>

namespace tps::claims {
namespace {

namespace mp = boost::multiprecision;
using Wide = mp::number<mp::mpfr_float_backend<300>, mp::et_off>;

Wide angle(double middle_mass, double e_double) {
  const Wide e = e_double;
  const Wide a = 1 / (1 + Wide(middle_mass));
  return acos(Wide((1 + e) * a / (2 * sqrt(e))));
}

Wide pi() {
  return boost::math::constants::pi<Wide>();
}

}  // namespace

double collapse_restitution(double middle_mass) {
  const Wide a = 1 / (1 + Wide(middle_mass));
  const Wide sine = sqrt(Wide(1 - a * a));
  return static_cast<double>(Wide((1 - sine) / (1 + sine)));
}

int collisions_by_formula(double middle_mass, double e) {
  // π/φ is a whole number for equal masses (φ = π/3): what rounding adds to it must not count.
  const Wide rounding = Wide("1e-280");
  return static_cast<int>(ceil(Wide(pi() / angle(middle_mass, e) - rounding))) - 1;
}

double last_approach_by_formula(double middle_mass, double e) {
  const Wide phi = angle(middle_mass, e);
  const int n = collisions_by_formula(middle_mass, e);
  const Wide g = pow(Wide(e), Wide(Wide(n - 1) / 2)) * sin(Wide(n * phi)) / sin(phi);
  return static_cast<double>(Wide(log10(g)));
}

double restitution_where_speeds_reach(double middle_mass, double log10_smallest) {
  double below = collapse_restitution(middle_mass);
  double above = 1;
  for (;;) {
    const double middle = below + (above - below) / 2;
    if (middle <= below || middle >= above) return above;
    const Wide exponent = pi() / angle(middle_mass, middle) / 2 * log10(Wide(middle));
    (exponent < log10_smallest ? below : above) = middle;
  }
}

Counted count_one_by_one(double middle_mass, double e_double) {
  const std::array<Wide, 3> m{1, middle_mass, 1};
  const Wide e = e_double;
  std::array<Wide, 3> v{1, 0, 0};
  Counted result;
  Wide smallest = 1;
  for (std::size_t left = 0;; left = 1 - left) {
    const Wide approach = v[left] - v[left + 1];
    if (approach <= 0) break;
    smallest = approach < smallest ? approach : smallest;
    const Wide impulse = (1 + e) * approach / (1 / m[left] + 1 / m[left + 1]);
    v[left] -= impulse / m[left];
    v[left + 1] += impulse / m[left + 1];
    ++result.collisions;
  }
  result.log10_smallest_approach = static_cast<double>(Wide(log10(smallest)));
  for (std::size_t i = 0; i < 3; ++i) result.velocities[i] = v[i].str(60);
  return result;
}

double difference(const std::string& x, const std::string& y) {
  return static_cast<double>(Wide(abs(Wide(Wide(x) - Wide(y)))));
}

}  // namespace tps::claims

// Eq. (2) in many digits: the textbook formula, whose cancellations cost digits that are there to be spent.
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstddef>

#include "verify/oracles/oracle.hpp"

namespace tps::oracles {
namespace {

template <typename Wide>
std::optional<double> time_in(const TimingQuery& query) {
  Wide speed_squared(0);
  Wide half_b(0);
  Wide gap = -Wide(query.L) * Wide(query.L);
  for (std::size_t k = 0; k < 3; ++k) {
    const Wide separation = Wide(query.u_B[k]) - Wide(query.u_A[k]);
    const Wide speed = Wide(query.v_B[k]) - Wide(query.v_A[k]);
    speed_squared += speed * speed;
    half_b += separation * speed;
    gap += separation * separation;
  }
  if (speed_squared == 0) return std::nullopt;
  const Wide discriminant = half_b * half_b - speed_squared * gap;
  if (query.kind == Kind::block) {
    if (half_b >= 0) return std::nullopt;
    if (gap <= 0) return 0.0;
    if (discriminant <= 0) return std::nullopt;
    return static_cast<double>(Wide((-half_b - sqrt(discriminant)) / speed_squared));
  }
  if (gap >= 0 && half_b >= 0) return 0.0;
  if (discriminant <= 0) return static_cast<double>(Wide(-half_b / speed_squared));
  return static_cast<double>(Wide((-half_b + sqrt(discriminant)) / speed_squared));
}

}  // namespace

std::optional<double> time_in_50_digits(const TimingQuery& query) {
  return time_in<boost::multiprecision::cpp_bin_float_50>(query);
}

std::optional<double> time_in_100_digits(const TimingQuery& query) {
  return time_in<boost::multiprecision::cpp_bin_float_100>(query);
}

}  // namespace tps::oracles

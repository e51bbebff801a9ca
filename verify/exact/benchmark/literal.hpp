// What the certified answers are compared with in time: eq. (2) as printed, in any scalar, from u, v and L,
// and the verdict and order that its numbers suggest.
#pragma once

#include <cmath>
#include <optional>

#include "verify/exact/timing_query.hpp"

namespace tps::exact::benchmark {

/// The smaller (blocking) or larger (tethering) root of eq. (2), by its textbook formula and the literal
/// discriminant; absent where the discriminant is negative or the root is.
template <typename Scalar>
std::optional<Scalar> literal_time(const TimingQuery& query) {
  using std::sqrt;
  Scalar a(0);
  Scalar h(0);
  Scalar c(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const Scalar r = Scalar(query.u_B[k]) - Scalar(query.u_A[k]);
    const Scalar v = Scalar(query.v_B[k]) - Scalar(query.v_A[k]);
    a += v * v;
    h += r * v;
    c += r * r;
  }
  c -= Scalar(query.L) * Scalar(query.L);
  const Scalar b = 2 * h;
  const Scalar discriminant = b * b - 4 * a * c;
  if (a == 0 || discriminant < 0) return std::nullopt;
  const Scalar root = sqrt(discriminant);
  const Scalar t = query.kind == Kind::block ? Scalar((-b - root) / (2 * a)) : Scalar((-b + root) / (2 * a));
  if (t < 0) return std::nullopt;
  return t;
}

}  // namespace tps::exact::benchmark

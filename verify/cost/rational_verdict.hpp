// The verdict by rational numbers: what exactness costs without a lift to integers.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include "verify/exact/timing_query.hpp"
#include "verify/exact/verdict.hpp"

namespace tps::cost {

/// Exact for every valid query.
inline TimingVerdict rational_verdict(const exact::TimingQuery& query) {
  using Number = boost::multiprecision::number<boost::multiprecision::cpp_rational_backend,
                                               boost::multiprecision::et_off>;
  Number a(0), h(0), c = -Number(query.L) * Number(query.L);
  for (std::size_t k = 0; k < 3; ++k) {
    const Number r = Number(query.u_B[k]) - Number(query.u_A[k]);
    const Number v = Number(query.v_B[k]) - Number(query.v_A[k]);
    a += v * v;
    h += r * v;
    c += r * r;
  }
  if (a == 0) return TimingVerdict::static_pair;
  const auto sign = [](const Number& x) {
    return x < 0 ? exact::Sign::negative : x > 0 ? exact::Sign::positive : exact::Sign::zero;
  };
  return exact::decide(query.kind, sign(h), sign(c), sign(h * h - a * c)).value();
}

}  // namespace tps::cost

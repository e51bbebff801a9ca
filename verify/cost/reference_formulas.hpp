// The two formulas that the reference itself offers (`--timing paper` and `stable`), on a query.
#pragma once

#include "reference/equations/eq2_collision_time.hpp"
#include "reference/equations/eq2_paper_time.hpp"
#include "verify/exact/timing_query.hpp"

namespace tps::cost {

template <typename Scalar>
Vector<Scalar, 3> in_scalar(const std::array<double, 3>& x) {
  return {Scalar(x[0]), Scalar(x[1]), Scalar(x[2])};
}

/// Eq. (2) as printed (docs/eq2.md).
template <typename Scalar>
CollisionTime<Scalar> printed_time(const exact::TimingQuery& q) {
  const auto answer =
      q.kind == exact::Kind::block ? paper_block_time<Scalar, 3> : paper_tether_time<Scalar, 3>;
  return answer(in_scalar<Scalar>(q.u_A), in_scalar<Scalar>(q.u_B), in_scalar<Scalar>(q.v_A),
                in_scalar<Scalar>(q.v_B), Scalar(q.L));
}

/// What the engine computes with unless told otherwise.
template <typename Scalar>
CollisionTime<Scalar> stable_time(const exact::TimingQuery& q) {
  const auto answer = q.kind == exact::Kind::block ? block_time<Scalar, 3> : tether_time<Scalar, 3>;
  return answer(in_scalar<Scalar>(q.u_A), in_scalar<Scalar>(q.u_B), in_scalar<Scalar>(q.v_A),
                in_scalar<Scalar>(q.v_B), Scalar(q.L));
}

}  // namespace tps::cost

// The proof of a time: adjacent doubles around it, with the signs of the polynomial there.
#pragma once

#include <optional>
#include <string>

#include "reference/equations/dyadic.hpp"
#include "verify/exact/timing_query.hpp"
#include "verify/exact/verdict.hpp"

namespace tps::vectors {

/// lo ≤ t ≤ hi: adjacent doubles, or lo = hi where t is one. The double after the largest is infinity, which
/// stands for 2^1024 where a sign is taken; the ones around an underflowing time are 0 and the smallest
/// subnormal.
///
/// The polynomial is a t² + 2 h t + c; for a `turning` it is a t + h, whose zero is closest approach; of a
/// plane it is −n·v t + L − n·r, how far the particle is beyond the limit.
/// Laws: (1) `nearest` is lo or hi, whichever is the correctly rounded time; (2) the signs at lo and hi, with
/// the branch that the verdict names, prove the bracket, and the sign at the midpoint proves `nearest`.
struct TimeBracket {
  double lo, hi, nearest;
  int sign_lo, sign_hi, sign_mid;
};

/// What a timing query's answer rests on: exact coefficients as "0x1a3p-104" (dyadic rationals; B = 2h), the
/// sign of the discriminant, the verdict, and the bracket where there is an event at t > 0.
struct TimingProof {
  exact::Verdict verdict;
  std::string A, B, C;
  int sign_D;
  std::optional<TimeBracket> bracket;
};

/// "0x1a3p-104".
std::string dyadic_text(const Dyadic& x);

/// Decided by integers; the filters of verify/exact answer too, and are judged by them.
/// REQUIRES valid(query). Throws std::logic_error if a filtered verdict or time contradicts the integers.
TimingProof prove(const exact::TimingQuery& query);

/// How much a relative error u in every term of the coefficients changes the exact t at most, in units of u:
/// (a t² + 2 Σ|r_k v_k| t + |r|² + L²) / (2 t √D) at a root, Σ|r_k v_k| / |h| at a `turning`, (Σ|n_k r_k| +
/// L) / (n·r − L) + Σ|n_k v_k| / |n·v| at a plane. Absent at t = 0 and beyond the doubles.
std::optional<double> condition(const exact::TimingQuery& query, const TimingProof& proof);

}  // namespace tps::vectors

// Comparisons of the numbers of a state as they are spelt: exact, in no scalar.
#pragma once

#include <vector>

#include "reference/text/hexfloat.hpp"
#include "reference/trace/state_data.hpp"

namespace tps {

/// The sign of a sum, −1, 0 or 1. REQUIRES hexadecimal floats.
int sign_of_sum(const std::vector<HexDigits>& terms);

/// Whether a ≤ b. REQUIRES normal times.
bool is_not_after(const HexTime& a, const HexTime& b);

/// Whether a ≤ b + dt, but for rounding: dt to 2^−digits of it, the sum to 2^−sum_digits of it.
/// REQUIRES normal times, dt > 0.
bool is_not_after_sum(const HexTime& a, const HexTime& b, double dt, int digits, int sum_digits);

/// Whether hi ≥ 0 and |lo| is at most half an ulp of hi in a scalar of that many bits (docs/trace.md): the
/// one spelling that a run writes, subnormal numbers aside.
bool is_normal_time(const HexTime& time, int digits);

/// Whether `t` is start_time + hi + lo.
bool is_sum(const Hex& t, double start_time, const HexTime& time);

/// Whether the numbers and words are those of an observation of clusters (run_in.hpp).
bool is_observation(const std::vector<Hex>& observation);

}  // namespace tps

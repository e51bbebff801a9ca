// Stage 3 of the order: the sign of the difference of two algebraic times.
#pragma once

#include "verify/exact/exact_root.hpp"

namespace tps::exact {

/// The sign of X + Y √A. REQUIRES A ≥ 0.
Sign sign_of_sum(const Integer& X, const Integer& Y, const Integer& A);

/// The sign of X + Y √A + Z √B by two nested squarings. REQUIRES A, B ≥ 0.
Sign sign_of_sum(const Integer& X, const Integer& Y, const Integer& A, const Integer& Z, const Integer& B);

/// The sign of first − second. REQUIRES both in the same unit of time.
Sign sign_of_difference(const AlgebraicTime& first, const AlgebraicTime& second);

}  // namespace tps::exact

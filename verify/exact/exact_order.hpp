// Stage 3 of the order: the sign of the difference of two algebraic times.
#pragma once

#include "verify/exact/exact_root.hpp"

namespace tps::exact {

/// The sign of X + Y √A. REQUIRES A ≥ 0.
Sign sign_of_sum(const Integer& X, const Integer& Y, const Integer& A);

/// The sign of X + Y √A + Z √B by two nested squarings. REQUIRES A, B ≥ 0.
Sign sign_of_sum(const Integer& X, const Integer& Y, const Integer& A, const Integer& Z, const Integer& B);

/// A time multiplied by a positive integer, or written in a unit that is smaller by that factor.
AlgebraicTime stretched(const AlgebraicTime& time, const Integer& factor);

/// The sign of offset + first − second. REQUIRES all in the same unit of time.
Sign sign_of_difference(const AlgebraicTime& first, const AlgebraicTime& second, const Integer& offset);

}  // namespace tps::exact

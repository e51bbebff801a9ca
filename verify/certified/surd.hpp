// Numbers with one square root, exactly. Heavy header: only sources of this folder include it.
#pragma once

#include <optional>
#include <variant>

#include "verify/certified/numbers.hpp"

namespace tps::certified {

/// The square root of a rational, where it is rational.
std::optional<Rational> rational_root(const Rational& x);

/// a + b √D. REQUIRES b ≠ 0, D > 0 and no square of a rational: so it is irrational, and is zero never.
///
/// Landing times are such numbers, and everything rational in them stays one: where a ball cannot tell a
/// coordinate from zero, or from the middle of two doubles, these can.
struct Surd {
  Rational a, b, D;
};

/// What an operation on them gives: rational where the root cancels.
using SurdOrRational = std::variant<Rational, Surd>;

SurdOrRational simplified(const Rational& a, const Rational& b, const Rational& D);

/// x over the root of another: the same number as a + b' √D. Absent where √x.D is no multiple of √D.
std::optional<Surd> over_root(const Surd& x, const Rational& D);

/// REQUIRES x.D = y.D.
SurdOrRational sum(const Surd& x, const Surd& y);
SurdOrRational product(const Surd& x, const Surd& y);

Surd inverse(const Surd& x);

/// Exactly.
Sign sign(const Surd& x);

/// √x where it is p + q √D with p and q rational. REQUIRES x > 0.
std::optional<SurdOrRational> root_within(const Surd& x);

}  // namespace tps::certified

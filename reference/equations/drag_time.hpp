// The time that the clock of a scene with drag stands for, in any scalar. An addition to the paper, of which
// a superimposed differential equation is an outlook; docs/effects.md, "Drag".
#pragma once

#include <cmath>
#include <optional>
#include <type_traits>

namespace tps {

/// t = −ln(1 − γs)/γ, the inverse of s = (1 − e^{−γt})/γ: under dv/dt = −γv a free particle is at u + v s.
///
/// @param gamma  γ > 0, in 1/time; @param s ≥ 0, in time
/// @return t in units of time, s or more to rounding; absent where γs, rounded, is 1 or more: a particle
/// comes to rest at s = 1/γ, which is never reached.
/// Laws: (1) s = 0 gives 0; (2) t is not below s, and rises with it, to rounding; (3) γ divided and s
/// multiplied by 2^k multiply t by 2^k, bitwise; (4) the clock of t is s, 1 − e^{−γt} = γs. Accuracy: γs is
/// rounded once, which is magnified by z/((1 − z)(−ln(1 − z))), z = γs: 1 for small z, without bound
/// towards 1. The engine's drag_time() (reference/engine/drag_clock.hpp) takes γs exactly.
template <typename Scalar>
std::optional<Scalar> drag_time(const Scalar& gamma, const std::type_identity_t<Scalar>& s) {
  using std::log1p;
  const Scalar z = gamma * s;
  if (z >= Scalar(1)) return std::nullopt;
  return Scalar(-log1p(Scalar(-z)) / gamma);
}

}  // namespace tps

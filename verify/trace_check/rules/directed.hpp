// Semantics 2: the last rounding of a response is directed, so that a pair that has rebounded never
// approaches and one that was pulled never parts (docs/engine.md, "Directed rounding").
#pragma once

#include <algorithm>

#include "reference/equations/square_root.hpp"
#include "verify/trace_check/context.hpp"
#include "verify/trace_check/responses.hpp"

namespace tps::check {

/// How far directed rounding may have moved a velocity of either side.
template <typename W>
struct DirectedSlack {
  W of_i{0}, of_j{0};
};

/// Where v_n' as it should be is right by more than its rounding, nothing is moved. Else one component of the
/// lighter body goes as far as v_n' is wrong, by √D of that at most as it is the one along which û is
/// largest, and two numbers further; components that tie share that. `v_after` is v_AB', `stored` what its
/// stored components may be off by; where v_n' is wrong by more than `most_wrong` no rounding made it so, and
/// nothing may be moved. Whatever the check does not know of the axis, the program did: it moves by no more
/// than its own roundings, `most_moved` of v_n'.
template <typename Number>
DirectedSlack<Work<Number>> directed_slack(const Context<Number>& c, const BodiesNow<Number>& b, bool outer,
                                           const Vec<Work<Number>>& v_after, const Work<Number>& stored,
                                           const Work<Number>& largest_after, const Work<Number>& most_wrong,
                                           const Work<Number>& most_moved) {
  using W = Work<Number>;
  constexpr int kDirected = 2;
  if (c.semantics < kDirected) return {};
  const W root = square_root(W(c.model.scene.dimension));
  const W v_n = dot(v_after, b.axis());
  const W wrong = (outer ? v_n : W(-v_n)) + root * stored;
  if (wrong < W(0) || (outer ? v_n : W(-v_n)) > most_wrong) return {};
  const W slack = root * std::min(wrong, most_moved) + W(4) * c.u() * largest_after;
  const W rounded = W(1) - W(2 + b.loads) * c.u();  // masses of bodies are
  DirectedSlack<W> result;
  if (b.inverse_i >= b.inverse_j * rounded) result.of_i = slack;
  if (b.inverse_j >= b.inverse_i * rounded) result.of_j = slack;
  return result;
}

}  // namespace tps::check

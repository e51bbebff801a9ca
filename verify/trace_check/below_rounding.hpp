// Rebounds that approach more slowly than the trace's scalar can tell: their number is not to be trusted.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "verify/trace_check/bodies_now.hpp"
#include "verify/trace_check/context.hpp"

namespace tps::check {

/// Counts what docs/decisions.md, N63, calls below rounding: |v_n| ≤ 2u(|v_i| + |v_j|) + (2 + 2DX/|r|)u|v|, X
/// the largest coordinate. It is no fault of the program: a collapse looks like this to any scalar.
class BelowRounding {
 public:
  template <typename Number>
  void look(const Context<Number>& c, const BodiesNow<Number>& b) {
    using W = Work<Number>;
    using std::abs;
    const W turn = W(2) + W(2 * c.model.scene.dimension) * W(b.reach_i + b.reach_j) / b.distance();
    const W rounding = c.u() * (W(2) * (length(b.v_i) + length(b.v_j)) + turn * b.speed());
    if (abs(b.v_n()) > rounding) return;
    if (count_++ == 0) first_ = c.model.events + 1;
  }

  /// Takes over what was counted behind it.
  void take_over(const BelowRounding& later) {
    if (count_ == 0) first_ = later.first_;
    count_ += later.count_;
  }

  std::optional<std::string> note() const {
    if (count_ == 0) return std::nullopt;
    return fmt::format(
        "{} of the rebounds, the first at event {}, approached more slowly than the trace's scalar can tell: "
        "their number "
        "is not to be trusted from there on",
        count_, first_);
  }

 private:
  std::uint64_t count_ = 0, first_ = 0;
};

}  // namespace tps::check

// Mistakes in timing queries and orders.
#include <algorithm>
#include <array>

#include "properties/conform/quadratic.hpp"

namespace tps::properties::conform {
namespace {

using Times = std::function<std::optional<Mistaken>(const Quadratic&, const Given&)>;

/// Of a query that has roots.
Mistake with_roots(std::string name, std::vector<Op> ops, Times answer) {
  return {std::move(name), std::move(ops),
          [answer = std::move(answer)](const Given& g) -> std::optional<Mistaken> {
            const Quadratic q(g);
            return q.has_roots() ? answer(q, g) : std::nullopt;
          }};
}

/// Ties have no other order, and of queries that never happen this says nothing.
std::optional<Mistaken> exchanged(const Given& g) {
  std::array<std::optional<double>, 2> t;
  for (const bool second : {false, true}) {
    const Json& in = g.in().at(second ? "second" : "first");
    const Quadratic q{Given(in)};
    const bool block = in.at("kind") == "block";
    if (!q.has_roots() || (block && q.h >= 0)) continue;
    t[second ? 1 : 0] = std::max(0.0, block ? q.smaller() : q.larger());
  }
  if (!t[0] && !t[1]) return std::nullopt;
  if (t[0] && t[1] && std::fabs(*t[0] - *t[1]) <= 1e-12 * std::fabs(*t[0])) return std::nullopt;
  return Mistaken{{}, t[0] && (!t[1] || *t[0] < *t[1]) ? "after" : "before"};
}

}  // namespace

void add_timing_mistakes(std::vector<Mistake>& mistakes) {
  const std::vector<Op> both{Op::block_time, Op::tether_time}, block{Op::block_time}, tether{Op::tether_time};
  const auto plain = [&](std::string name, std::vector<Op> ops, auto answer) {
    mistakes.push_back(with_roots(std::move(name), std::move(ops), answer));
  };
  plain("the larger root", block, [](const Quadratic& q, const Given&) { return at(q.larger()); });
  plain("the smaller root", tether, [](const Quadratic& q, const Given&) { return at(q.smaller()); });
  mistakes.push_back({"the smaller non-negative root without a test for approach, as printed (D1)", both,
                      [](const Given& g) { return std::optional(at(Quadratic(g).literal())); }});
  plain("twice the time: the quadratic divided by a instead of 2a", both,
        [](const Quadratic& q, const Given&) -> std::optional<Mistaken> {
          const bool is_block = q.h < 0 && q.c > 0 && q.smaller() > 0;
          const double t = is_block ? q.smaller() : q.larger();
          return t == 0 ? std::nullopt : std::optional(at(2 * t));  // twice 0 tells nothing
        });
  mistakes.push_back(
      {"L taken as it is instead of squared", both, [](const Given& g) -> std::optional<Mistaken> {
         const Quadratic q(g.r(), g.v(), std::sqrt(g.number("L")));
         return q.has_roots() ? std::optional(at(q.c > 0 ? q.smaller() : q.larger())) : std::nullopt;
       }});
  mistakes.push_back(
      {"L doubled, as if it were a radius", both, [](const Given& g) -> std::optional<Mistaken> {
         const Quadratic q(g.r(), g.v(), 2 * g.number("L"));
         return q.has_roots() ? std::optional(at(q.c > 0 ? q.smaller() : q.larger())) : std::nullopt;
       }});
  mistakes.push_back(
      {"the relative velocity with the wrong sign", both, [](const Given& g) -> std::optional<Mistaken> {
         const Quadratic q(g.r(), -1.0 * g.v(), g.number("L"));
         if (!q.has_roots()) return std::nullopt;
         return at(q.h < 0 && q.c > 0 ? q.smaller() : q.larger());
       }});
  plain("the time of closest approach", both,
        [](const Quadratic& q, const Given&) { return at(-q.h / q.a); });
  plain("a time before now", both, [](const Quadratic& q, const Given&) -> std::optional<Mistaken> {
    return q.smaller() < 0 ? std::optional(at(q.smaller())) : std::nullopt;
  });
  const auto lost = [&](Op op, bool (*is_beyond)(const Quadratic&)) {
    mistakes.push_back({"no event for a pair that is at its limit or beyond it",
                        {op},
                        [is_beyond](const Given& g) -> std::optional<Mistaken> {
                          const Quadratic q(g);
                          const double L = g.number("L");
                          const bool is_at = std::fabs(q.c) <= 1e-9 * L * L;
                          return is_at || is_beyond(q) ? std::optional(at(std::nullopt)) : std::nullopt;
                        }});
  };
  lost(Op::block_time, [](const Quadratic& q) { return q.c < 0 && q.h < 0; });
  lost(Op::tether_time, [](const Quadratic& q) { return q.c > 0 && q.h >= 0; });
  mistakes.push_back({"first and second exchanged", {Op::order}, exchanged});
}

}  // namespace tps::properties::conform

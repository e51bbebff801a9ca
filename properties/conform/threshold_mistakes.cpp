// Thresholds in the places where eq. (2) compares with 0: a, h, c or D taken as 0 when it is small.
#include "properties/conform/quadratic.hpp"

namespace tps::properties::conform {
namespace {

/// The largest that anybody is thought to take.
constexpr double kThreshold = 1e-6;

bool is_small(double x) {
  return x != 0 && std::fabs(x) <= kThreshold;
}

using Answer = std::optional<Mistaken> (*)(const Quadratic&);

std::optional<Mistaken> slow_is_static(const Quadratic& q) {
  if (!is_small(q.a)) return std::nullopt;
  return at(std::nullopt, {"static", "receding"});
}

std::optional<Mistaken> hardly_approaching_recedes(const Quadratic& q) {
  if (!(q.h < 0 && is_small(q.h))) return std::nullopt;
  return at(std::nullopt, {"receding", "static"});
}

std::optional<Mistaken> near_is_in_contact(const Quadratic& q) {
  if (!(q.h < 0 && q.c > 0 && is_small(q.c))) return std::nullopt;
  return at(0, {"contact", "overlap", "hit"});
}

std::optional<Mistaken> shallow_is_missed(const Quadratic& q) {
  if (!(q.h < 0 && q.c > 0 && q.D > 0 && is_small(q.D))) return std::nullopt;
  return at(std::nullopt, {"miss", "tangent", "receding"});
}

std::optional<Mistaken> hardly_turned_is_pulled(const Quadratic& q) {
  if (!(q.c >= 0 && q.h < 0 && is_small(q.h))) return std::nullopt;
  return at(0, {"taut", "overstretched", "hit"});
}

std::optional<Mistaken> near_is_taut(const Quadratic& q) {
  if (!(q.h >= 0 && q.c < 0 && is_small(q.c))) return std::nullopt;
  return at(0, {"taut", "overstretched", "hit"});
}

}  // namespace

void add_threshold_mistakes(std::vector<Mistake>& mistakes) {
  const auto add = [&](Op op, Answer answer) {
    mistakes.push_back({"a threshold where the paper has 0", {op}, [answer](const Given& g) {
                          return answer(Quadratic(g));
                        }});
  };
  for (const Answer answer :
       {slow_is_static, hardly_approaching_recedes, near_is_in_contact, shallow_is_missed})
    add(Op::block_time, answer);
  for (const Answer answer : {slow_is_static, hardly_turned_is_pulled, near_is_taut})
    add(Op::tether_time, answer);
}

}  // namespace tps::properties::conform

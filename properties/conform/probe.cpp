#include "properties/conform/probe.hpp"

#include <algorithm>
#include <cmath>

#include "properties/conform/expected.hpp"
#include "reference/text/hexfloat.hpp"

namespace tps::properties::conform {
namespace {

Answer answer_to(Implementation& subject, const Question& question) {
  Answer answer = subject.ask(question);
  if (answer.status == Answer::Status::failed) throw FailedProbe{answer.reason, question};
  return answer;
}

Json vector(double x, double y) {
  return {to_hex<double>(x), to_hex<double>(y)};
}

/// A number that goes through the subject unchanged: an impulse of zero, or the load of two equal velocities.
std::optional<double> returned(Implementation& subject, double x) {
  const Json v = vector(x, 0), zero = vector(0, 0);
  const Json masses{{"m_A", "0x1p+0"}, {"m_B", "0x1p+0"}, {"v_A", v}, {"v_B", v}};
  for (const auto& [op, key] : {std::pair{Op::apply_impulse, "v_A"}, std::pair{Op::load, "v_load"}}) {
    if (!subject.may_offer(op)) continue;
    Json in = masses;
    if (op == Op::apply_impulse) in["dp"] = zero;
    const Answer answer = answer_to(subject, {op, in});
    if (answer.status != Answer::Status::answered || !answer.out.is_object()) continue;
    const auto numbers = numbers_of(answer.out.value(key, Json()));
    if (numbers && !numbers->empty()) return numbers->front();
  }
  return std::nullopt;
}

/// r·v of perpendicular r and v is 0, as long as both products are rounded: .1·.3 − .3·.1. Fused, one of them
/// is not, and in one of two mirror images the pair seems to approach. Who is wrong about both is wrong for
/// another reason.
std::optional<bool> contracts(Implementation& subject) {
  if (!subject.may_offer(Op::block_time)) return std::nullopt;
  int approaching = 0;
  for (const double side : {1.0, -1.0}) {
    const Json in{{"u_A", vector(0, 0)},
                  {"u_B", vector(side * 0.1, side * 0.3)},
                  {"v_A", vector(0, 0)},
                  {"v_B", vector(0.3, -0.1)},
                  {"L", to_hex<double>(0x1p-10)}};
    const Answer answer = answer_to(subject, {Op::block_time, in});
    if (answer.status != Answer::Status::answered || !answer.out.is_object()) return std::nullopt;
    const Json verdict = answer.out.value("verdict", Json());
    if (verdict != "receding" && verdict != "hit" && verdict != "miss") return std::nullopt;
    approaching += verdict != "receding" ? 1 : 0;
  }
  return approaching == 2 ? std::nullopt : std::optional(approaching == 1);
}

}  // namespace

std::optional<FailedProbe> probe(Implementation& subject, Environment& environment) {
  const Format format = subject.format();
  const double all_bits = 1 + std::ldexp(1.0, 1 - std::min(format.bits, 53));
  const double subnormal = std::ldexp(1.0, -format.max_exponent - 2);
  try {
    if (const auto back = returned(subject, all_bits)) environment.exact = *back == all_bits;
    if (const auto back = format.bits <= 53 ? returned(subject, subnormal) : std::nullopt)
      environment.flushes = *back == 0;
    environment.contracts = contracts(subject);
  } catch (const FailedProbe& failed) {
    return failed;
  }
  return std::nullopt;
}

}  // namespace tps::properties::conform

// The time of the clock s under drag, docs/effects.md.

#include "properties/generators/cases.hpp"
#include "properties/generators/numbers.hpp"
#include "properties/law.hpp"
#include "properties/laws/compare.hpp"
#include "properties/laws/drag_clock.hpp"

namespace tps::properties::drag {
namespace {

/// γs small, of any size, near 1 on either side.
void a_clock(Case& c, const Format& format) {
  c.dimension = 2;
  c.hazard = one_of<std::string>({"general", "small", "middle", "near_the_end", "beyond", "start"});
  const double gamma = magnitude(format);
  // Arguments are drawn before the call: their order is the compiler's, and cases are the same with any.
  const auto below = [&](int power) { return std::ldexp(1 + coefficient(format), -power); };
  double z = below(whole(1, 8));
  if (c.hazard == "small") z = below(whole(8, format.bits + 8));
  if (c.hazard == "near_the_end") z = 1 - std::ldexp(1.0, -whole(2, format.bits));
  if (c.hazard == "beyond") z = 1 + coefficient(format);
  c.set("gamma", gamma);
  const double s = c.hazard == "general" ? magnitude(format) : c.hazard == "start" ? 0 : z / gamma;
  c.set("s", format.rounded(s));
  c.set("second.s", format.rounded(s * (1 + std::ldexp(1.0, -whole(0, format.bits)))));
  c.set("power", whole(-20, 21));
}

/// What rounding may do to t: γs is rounded once and its own error counted once more, 2u of z; a logarithm
/// good to 2 ulps and a quotient, 4u. Boost's logarithms in 50 and 100 digits promise nothing, and are off by
/// 12u at γ = 1/2, s = 5/8: they have 32u.
struct Clock {
  Clock(Interview& ask, const Case& c, const char* key = "s")
      : gamma(c.number("gamma")), s(c.number(key)), z(gamma * s), u(ask.u()) {
    answer = ask.drag_time(c.number("gamma"), c.number(key));
    const Wide most = z * (1 + 2 * u * kSlack);
    may_be_reached = z * (1 - 2 * u * kSlack) < 1;
    must_be_reached = most < 1;
    if (!answer.t || !must_be_reached) return;
    exact = time_of_clock(gamma, z);
    const int of_logarithm = ask.format().bits <= 113 ? 4 : 32;
    error = time_of_clock(gamma, most) * (1 + of_logarithm * u * kSlack) - exact;
  }

  Wide gamma, s, z, u;
  Time answer;
  bool may_be_reached = false, must_be_reached = false;
  Wide exact{0}, error{0};
};

Outcome at_the_start_both_are_zero(Interview& ask, const Case& c) {
  const Time answer = ask.drag_time(c.number("gamma"), 0);
  return same("the time of s = 0", answer, Time{"reached", Wide(0)});
}

Outcome is_the_inverse(Interview& ask, const Case& c) {
  const Clock k(ask, c);
  if (!k.answer.t || !k.must_be_reached) return outside("s is not before 1/γ");
  return at_most("the error of t = −ln(1 − γs)/γ", abs(Wide(*k.answer.t - k.exact)), k.error);
}

Outcome reached_before_the_end_alone(Interview& ask, const Case& c) {
  const Clock k(ask, c);
  if (k.may_be_reached && !k.must_be_reached) return outside("rounding may decide");
  const std::string expected = k.must_be_reached ? "reached" : "never";
  if (const Outcome verdict = same("the verdict", k.answer.verdict, expected);
      verdict.kind != Outcome::Kind::holds)
    return verdict;
  if (k.answer.t.has_value() == k.must_be_reached) return {};
  return broken(k.answer.verdict + (k.answer.t ? " has a time" : " has no time"));
}

Outcome rises_with_s(Interview& ask, const Case& c) {
  Case ordered = c;
  if (c.number("second.s") < c.number("s")) std::swap(ordered.numbers["s"], ordered.numbers["second.s"]);
  const Clock k(ask, ordered), later(ask, ordered, "second.s");
  if (!k.must_be_reached || !later.must_be_reached || !k.answer.t || !later.answer.t)
    return outside("not two times before 1/γ");
  return at_most("how much the later clock is before the earlier one", Wide(*k.answer.t - *later.answer.t),
                 k.error + later.error);
}

/// −ln(1 − z) is between z and z/(1 − z).
Outcome between_its_limits(Interview& ask, const Case& c) {
  const Clock k(ask, c);
  if (!k.answer.t || !k.must_be_reached) return outside("s is not before 1/γ");
  return all_of(at_most("s − t", Wide(k.s - *k.answer.t), k.error),
                at_most("t − s/(1 − γs)", Wide(*k.answer.t - k.s / (1 - k.z)), k.error));
}

Outcome powers_of_two(Interview& ask, const Case& c) {
  const Clock k(ask, c);
  const int power = c.integer("power");
  const Time scaled = ask.drag_time(std::ldexp(c.number("gamma"), -power), std::ldexp(c.number("s"), power));
  const Time expected{k.answer.verdict,
                      k.answer.t ? std::optional<Wide>(ldexp(*k.answer.t, power)) : std::nullopt};
  const Outcome bitwise = same("γ divided and s multiplied by 2^k", scaled, expected);
  if (bitwise.kind == Outcome::Kind::holds || !scaled.t || !expected.t || !k.must_be_reached) return bitwise;
  return abs(Wide(*scaled.t - *expected.t)) <= 2 * ldexp(k.error, power) ? to_rounding(bitwise.why) : bitwise;
}

}  // namespace

void add_laws(std::vector<Law>& laws) {
  const auto add = [&laws](const char* id, const char* number, const char* sentence, const auto& check) {
    laws.push_back({{id, number, sentence, "docs/effects.md"}, {Op::drag_time}, cases(a_clock), check});
  };
  add("DragLaws.Law1AtTheStartBothAreZero", "drag law 1", "s = 0 is t = 0, bitwise",
      at_the_start_both_are_zero);
  add("DragLaws.Law2IsTheInverse", "drag law 2",
      "t is −ln(1 − γs)/γ: its clock is s, with γs off by 2u of itself and t by 4u", is_the_inverse);
  add("DragLaws.Law3ReachedBeforeTheEndAlone", "drag law 3",
      "there is a time where γs < 1, and none where it is not, but where rounding may decide",
      reached_before_the_end_alone);
  add("DragLaws.Law4RisesWithS", "drag law 4", "a later clock is not at an earlier time, to rounding",
      rises_with_s);
  add("DragLaws.Law5BetweenItsLimits", "drag law 5", "s ≤ t ≤ s/(1 − γs), to rounding", between_its_limits);
  add("DragLaws.Law6PowersOfTwo", "drag law 6",
      "γ divided and s multiplied by 2^k multiply t by 2^k, bitwise", powers_of_two);
}

}  // namespace tps::properties::drag

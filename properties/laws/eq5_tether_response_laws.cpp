// The response at a tethering distance: eq. (4) where a retraction suffices, else eq. (5); applied by eq.
// (3). docs/eq5.md.
#include <optional>

#include "properties/generators/cases.hpp"
#include "properties/generators/numbers.hpp"
#include "properties/generators/pairs.hpp"
#include "properties/law.hpp"
#include "properties/laws/response_errors.hpp"

namespace tps::properties::tether_response {
namespace {

/// A pair that separates: where the generated one approaches, its velocities are exchanged.
void pulled_pair(Case& c, const Format& format) {
  put_pair(c, format);
  c.numbers.erase("L");
  const PairState p = c.pair();
  double h = 0;
  for (std::size_t k = 0; k < 3; ++k) h += (p.u_B[k] - p.u_A[k]) * (p.v_B[k] - p.v_A[k]);
  if (h < 0) c.set(PairState{p.u_A, p.u_B, p.v_B, p.v_A});
  c.set(masses(format));
  c.set("c_retract", coefficient(format));
  c.set("c_revolve", coefficient(format));
  c.set("theta_revolve_deg", revolve_angle(format));
}

struct Pull {
  Pull(Interview& ask, const Case& c)
      : m(c.masses()),
        c_retract(c.number("c_retract")),
        c_revolve(c.number("c_revolve")),
        theta(c.number("theta_revolve_deg")),
        x(c.pair()) {
    if (x.v_n < 0) throw Unanswered{outside("the pair approaches")};
    if (!turns(x) && x.tangential > 0) throw Unanswered{outside("hardly any motion across the axis")};
    answer = ask.tether_response(c.pair(), m, c_retract, c_revolve, theta);
    const Wide equation =
        answer.kind == "retract" ? collision_error(x, c_retract, ask.u()) : revolution_error(x, ask.u());
    const Wide applied =
        ask.u() * (2 * norm(answer.dp) / reduced_mass(m) + norm(answer.after.v_A) + norm(answer.after.v_B));
    error = equation + applied * kSlack;
    after = answer.after.v_B - answer.after.v_A;
  }

  Masses m;
  double c_retract, c_revolve, theta;
  Encounter x;
  TetherAnswer answer;
  WideVector after;
  Wide error;  ///< of `after`
};

Outcome the_answer_is_that_of_its_equation(Interview& ask, const Case& c) {
  const Pull k(ask, c);
  if (k.answer.kind == "retract") {
    const WideVector expected = k.x.v - ((1 + Wide(k.c_retract)) * k.x.v_n) * k.x.n;
    return at_most("the error of v_AB' by eq. (4)", norm(k.after - expected), k.error);
  }
  if (k.answer.kind != "revolve")
    return broken("the kind is " + k.answer.kind + "; allowed: retract, revolve");
  if (!turns(k.x))
    return outside("rounding decides, as the condition allows where c_retract |v_n| is as small");
  return at_most("the error of v_AB' by eq. (5)", norm(k.after - revolved(k.x, k.c_revolve, k.theta)),
                 k.error);
}

// v_n errs by 8u |v_AB| (v_AB 1u, û 3.5u, the scalar product 3u), |v_ŵ| by 15u |v_AB| and 2.5u of itself, tan
// θ by 6u, each product by 1u.
std::optional<std::string> certain_kind(Interview& ask, const Pull& k) {
  const Wide tangent = tan(radians(k.theta));
  const Wide closing = Wide(k.c_retract) * k.x.v_n;
  const Wide needed = tangent * k.x.tangential;
  const Wide error = ask.u() *
                     (9 * Wide(k.c_retract) * k.x.speed + tangent * (15 * k.x.speed + 10 * k.x.tangential)) *
                     kSlack;
  if (abs(Wide(closing - needed)) <= error) return std::nullopt;
  return closing > needed ? "retract" : "revolve";
}

Outcome the_condition_decides(Interview& ask, const Case& c) {
  const Pull k(ask, c);
  const std::optional<std::string> certain = certain_kind(ask, k);
  if (!certain) return outside("rounding may decide between (4) and (5)");
  return same("the kind, and that of the condition", k.answer.kind, *certain);
}

Outcome closes_at_theta_or_more(Interview& ask, const Case& c) {
  const Pull k(ask, c);
  if (k.x.tangential == 0 || k.x.speed == 0) return outside("no motion across the axis");
  const Wide normal = dot(k.after, k.x.n);
  const Wide tangential = norm(k.after - normal * k.x.n);
  const Wide angle = radians(k.theta);
  // Where the answer took eq. (4) rounding may have decided: then its angle is θ to the error of the
  // condition.
  const Wide condition = ask.u() * (15 * k.x.speed / k.x.tangential + 25) * k.x.speed * kSlack;
  const Wide excess = normal * cos(angle) + tangential * sin(angle);
  return at_most("v_n' cos θ + |v_ŵ'| sin θ", excess, 2 * k.error + condition);
}

// As eq. (3): Δp/m errs by 1u, Δp times a rounded 1/m by 2u, the sum by 1u.
Outcome momentum_is_conserved(Interview& ask, const Case& c) {
  const Pull k(ask, c);
  const auto gained = [&](const char* who, const Wide& inverse, const WideVector& before,
                          const WideVector& after, const WideVector& dp) {
    const Wide error = ask.u() * (2 * inverse * norm(dp) + norm(after)) * kSlack;
    return at_most(std::string("the error of v_") + who + "' = v_" + who + " ± Δp/m",
                   norm(after - before - inverse * dp), error);
  };
  const PairState p = c.pair();
  return all_of(gained("A", inverse_mass(k.m.A), wide(p.v_A), k.answer.after.v_A, k.answer.dp),
                gained("B", inverse_mass(k.m.B), wide(p.v_B), k.answer.after.v_B, opposite(k.answer.dp)));
}

Outcome energy_never_rises(Interview& ask, const Case& c) {
  const Pull k(ask, c);
  return at_most("the relative speed afterwards", norm(k.after), k.x.speed + k.error);
}

Outcome the_names_may_be_exchanged(Interview& ask, const Case& c) {
  const Pull k(ask, c);
  const TetherAnswer other =
      ask.tether_response(swapped(c.pair()), swapped(k.m), k.c_retract, k.c_revolve, k.theta);
  if (other.kind != k.answer.kind) {
    const Outcome kinds = same("the kind with the names exchanged", other.kind, k.answer.kind);
    return certain_kind(ask, k) ? kinds : to_rounding(kinds.why + ", between which rounding may decide");
  }
  // A body's velocity errs by no more than the relative one may: its share of (4) or (5), and its own eq.
  // (3).
  return all_of(same_to("v_A' with the names exchanged", other.after.v_B, k.answer.after.v_A, 2 * k.error),
                same_to("v_B' with the names exchanged", other.after.v_A, k.answer.after.v_B, 2 * k.error));
}

}  // namespace

void add_laws(std::vector<Law>& laws) {
  const auto add = [&laws](const char* id, const char* number, const char* sentence, const auto& check) {
    laws.push_back({{id, number, sentence, "docs/eq5.md"}, {Op::tether_response}, cases(pulled_pair), check});
  };
  add("TetherResponseLaws.Law1TheAnswerIsThatOfItsEquation", "tether response law 1",
      "a retraction is eq. (4) with c_retract, a revolution is eq. (5)", the_answer_is_that_of_its_equation);
  add("TetherResponseLaws.Law2ClosesAtThetaOrMore", "tether response law 2",
      "afterwards the pair closes at θ from perpendicular or more", closes_at_theta_or_more);
  add("TetherResponseLaws.Law3TheConditionDecides", "tether response law 3",
      "it retracts where |c_retract v_n| > tan θ |v_ŵ| beyond rounding, and revolves where it is less",
      the_condition_decides);
  add("TetherResponseLaws.Law4MomentumIsConserved", "tether response law 4",
      "v_A' = v_A + Δp/m_A and v_B' = v_B − Δp/m_B, to u (2|Δp|/m + |v'|)", momentum_is_conserved);
  add("TetherResponseLaws.Law5EnergyNeverRises", "tether response law 5",
      "the relative speed, and with it the kinetic energy, never rises", energy_never_rises);
  add("TetherResponseLaws.Law6TheNamesMayBeExchanged", "tether response law 6",
      "A and B may be exchanged, bitwise", the_names_may_be_exchanged);
}

}  // namespace tps::properties::tether_response

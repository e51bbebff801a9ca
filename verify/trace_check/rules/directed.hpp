// Directed rounding of responses (D22): what it may have changed, and that it left the right sign.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include "verify/trace_check/bodies_now.hpp"
#include "verify/trace_check/context.hpp"

namespace tps::check {

/// How far the velocity of each side may be from its equation because of directed rounding.
template <typename W>
struct DirectedChange {
  W i{0}, j{0};
};

/// The lighter side's change along the largest component of r that turns the wrong sign of v_n'.
///
/// `after_i`, `after_j`: velocities by the equations, each off by up to `error_i`, `error_j`. Where r·v' has
/// the right sign beyond those errors, nothing was changed. Else what was stored had r·v' wrong by at most
/// its wrong part here and the errors times |r|₁; divided by |r_k| that is the change, and then one rounding
/// outwards and one number further, 4u of the velocity. Bodies' masses were added up: equal ones but for
/// rounding may either be the lighter.
template <typename Number>
DirectedChange<Work<Number>> directed_change(const Context<Number>& c, const BodiesNow<Number>& b, bool outer,
                                             const std::array<Work<Number>, 2>& inverse_masses,
                                             const Vec<Work<Number>>& after_i,
                                             const Vec<Work<Number>>& after_j, const Work<Number>& error_i,
                                             const Work<Number>& error_j) {
  using W = Work<Number>;
  using std::abs;
  if (!c.may_direct()) return {};
  const Vec<W> v = after_j - after_i;
  const W r_k = largest(b.r);
  const W sum = dot(b.r, v);
  const W doubt = (abs(b.r[0]) + abs(b.r[1]) + abs(b.r[2])) * (error_i + error_j) + b.blur * length(v);
  const W wrong = outer ? sum : W(-sum);
  if (wrong < -doubt || !(r_k > W(0))) return {};
  const W change = (std::max(W(0), wrong) + doubt) / r_k +
                   W(4) * c.u() * (largest(after_i) + largest(after_j)) + W(2) * c.model.precision.smallest;
  const W spare = W(4) * c.u() * W(1 + b.loads);
  const bool i_is_lighter = inverse_masses[0] >= inverse_masses[1] * (W(1) - spare);
  const bool j_is_lighter = inverse_masses[1] >= inverse_masses[0] * (W(1) - spare);
  return {i_is_lighter ? change : W(0), j_is_lighter ? change : W(0)};
}

namespace detail {

/// A stored number as a fraction.
template <typename Number>
boost::multiprecision::cpp_rational exactly(const Number& x) {
  using boost::multiprecision::cpp_int;
  using std::frexp;
  using std::ldexp;
  constexpr int digits = std::numeric_limits<Number>::digits;
  int exponent = 0;
  const Number fraction = frexp(x, &exponent);
  const cpp_int numerator = static_cast<cpp_int>(Number(ldexp(fraction, digits)));
  exponent -= digits;
  if (exponent >= 0) return cpp_int(numerator << static_cast<unsigned>(exponent));
  return {numerator, cpp_int(cpp_int(1) << static_cast<unsigned>(-exponent))};
}

/// The sign of (u_j − u_i)·(v_j − v_i): by working precision where that is beyond doubt, else by fractions.
template <typename Number>
int exact_sign(const Vec<Number>& u_i, const Vec<Number>& u_j, const Vec<Number>& v_i,
               const Vec<Number>& v_j) {
  using W = Work<Number>;
  using std::abs;
  W sum(0), size(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const W term = (W(u_j[k]) - W(u_i[k])) * (W(v_j[k]) - W(v_i[k]));
    sum += term;
    size += abs(term);
  }
  if (abs(sum) > W(16) * std::numeric_limits<W>::epsilon() * size + (std::numeric_limits<W>::min)())
    return sum > W(0) ? 1 : -1;
  boost::multiprecision::cpp_rational exact = 0;
  for (std::size_t k = 0; k < 3; ++k)
    exact += (exactly(u_j[k]) - exactly(u_i[k])) * (exactly(v_j[k]) - exactly(v_i[k]));
  return exact.sign();
}

}  // namespace detail

/// A trace of semantics 2 says that no pair leaves its response the wrong way: that is asked of its numbers.
template <typename Number>
void judge_direction(const Context<Number>& c, const EventLine<Number>& event, bool outer) {
  if (!c.must_direct()) return;
  const InvolvedParticle<Number>* i = event.of(event.i);
  const InvolvedParticle<Number>* j = event.of(event.j);
  if (i == nullptr || j == nullptr || !i->position_before || !j->position_before) return;
  const int sign = detail::exact_sign<Number>(*i->position_before, *j->position_before, i->velocity_after,
                                              j->velocity_after);
  const bool rests = i->velocity_after == j->velocity_after;
  c.tally.demand(Rule::impulse, outer ? sign < 0 || rests : sign >= 0, [&](Finding& f) {
    f.message = fmt::format(
        "{} leave their {} limit {} by the last bits of their velocities; semantics 2 "
        "rounds responses so that they do not (D22)",
        c.pair(event.i, event.j), outer ? "outer" : "inner", outer ? "outwards" : "inwards");
    f.equation = "(3)";
  });
}

}  // namespace tps::check

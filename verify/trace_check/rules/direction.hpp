// Semantics 2, directed rounding of responses (D22): the stored velocities leave the limit the right way,
// exactly.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include "reference/version.hpp"
#include "verify/trace_check/context.hpp"

namespace tps::check {

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
int exact_sign(const Vec<Number>& u_i, const Vec<Number>& u_j, const Vec<Number>& v_i, const Vec<Number>& v_j,
               const Vec<Number>& image = {}, const Vec<Number>& edges = {}) {
  using W = Work<Number>;
  using std::abs;
  W sum(0), size(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const W v = W(v_j[k]) - W(v_i[k]);
    for (const W& term : {W((W(u_j[k]) - W(u_i[k])) * v), W(W(image[k]) * W(edges[k]) * v)}) {
      sum += term;
      size += abs(term);
    }
  }
  if (abs(sum) > W(16) * std::numeric_limits<W>::epsilon() * size + (std::numeric_limits<W>::min)())
    return sum > W(0) ? 1 : -1;
  boost::multiprecision::cpp_rational exact = 0;
  for (std::size_t k = 0; k < 3; ++k)
    exact += (exactly(u_j[k]) - exactly(u_i[k]) + exactly(image[k]) * exactly(edges[k])) *
             (exactly(v_j[k]) - exactly(v_i[k]));
  return exact.sign();
}

}  // namespace detail

/// A trace of semantics 2 says that no pair leaves its response the wrong way: that is asked of its numbers.
template <typename Number>
void judge_direction(const Context<Number>& c, const EventLine<Number>& event, bool outer) {
  if (c.minimal || c.semantics < kDirectedSemantics) return;
  const InvolvedParticle<Number>* i = event.of(event.i);
  const InvolvedParticle<Number>* j = event.of(event.j);
  if (i == nullptr || j == nullptr || !i->position_before || !j->position_before) return;
  const Vec<Number> image = c.model.nearest_image(event.i, event.j, event.t);
  const int sign =
      detail::exact_sign<Number>(*i->position_before, *j->position_before, i->velocity_after,
                                 j->velocity_after, image, c.model.edges.value_or(Vec<Number>{}));
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

#include "verify/exact/four_queries.hpp"

#if defined(__AVX2__) && defined(__FMA__)

#include "verify/exact/four_doubles.hpp"
#include "verify/exact/newton_step.hpp"

namespace tps::exact {
namespace {

using Vector = std::array<Four, 3>;

template <typename Number>
TPS_IN_EVERY_COPY Four gathered(const TimingQuery* queries, Number number) {
  return _mm256_set_pd(number(queries[3]), number(queries[2]), number(queries[1]), number(queries[0]));
}

TPS_IN_EVERY_COPY Vector gathered(const TimingQuery* queries, Vec3 TimingQuery::*vector) {
  const auto component = [&](std::size_t k) {
    return gathered(queries, [&](const TimingQuery& query) { return (query.*vector)[k]; });
  };
  return {component(0), component(1), component(2)};
}

/// sign_within() of each.
TPS_IN_EVERY_COPY FourAnswers::Signs signs_within(Four x, Four bound) {
  return {(x < -bound).mask(), (x > bound).mask()};
}

}  // namespace

bool has_registers_of_four() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}

FourAnswers four_answers(const TimingQuery* queries) {
  const Vector u_A = gathered(queries, &TimingQuery::u_A), u_B = gathered(queries, &TimingQuery::u_B);
  const Vector v_A = gathered(queries, &TimingQuery::v_A), v_B = gathered(queries, &TimingQuery::v_B);
  const Four L = gathered(queries, [](const TimingQuery& query) { return query.L; });
  const Four side =
      gathered(queries, [](const TimingQuery& query) { return query.kind == Kind::block ? -1.0 : 1.0; });
  FourAnswers answers;

  const CoefficientsIn<Four> q = coefficients_at_home(u_A, u_B, v_A, v_B, L);
  answers.h = signs_within(q.h, q.h_error);
  answers.c = signs_within(q.c, q.c_error);
  answers.D = signs_within(q.D, q.D_error);
  answers.in_range = q.in_range.mask();

  const auto r = exact_difference(u_B, u_A), v = exact_difference(v_B, v_A);
  const auto rounded = [](Four t, const NewtonStep<Four>& step, double(&times)[4]) {
    const RoundedEnds<Four> ends = rounded_ends(t, step.correction, step.error);
    ends.low.store(times);
    return (usual_size(t) & step.holds & (ends.low == ends.high)).mask();
  };
  const Four hit = approximate_hit(q, side), turning = approximate_turning(q);
  answers.hit_is_proven = rounded(hit, step_to_hit(state_at(r, v, hit), L, side, Four(1.0)), answers.hit);
  answers.turning_is_proven =
      rounded(turning, step_to_turning(state_at(r, v, turning), Four(1.0)), answers.turning);
  return answers;
}

}  // namespace tps::exact

#else  // another processor, or a compiler that was not told of this one

namespace tps::exact {

bool has_registers_of_four() {
  return false;
}
FourAnswers four_answers(const TimingQuery*) {
  return {};
}

}  // namespace tps::exact

#endif

#include "verify/cost/exact_answer.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "verify/exact/lifted_query.hpp"

namespace tps::cost {
namespace {

namespace mp = boost::multiprecision;
using exact::Integer;
using exact::LiftedQuadratic;
using exact::Verdict;
using Wide = mp::number<mp::cpp_bin_float<1024, mp::digit_base_2>, mp::et_off>;

constexpr double kNothing = -1000;  ///< above the 2^-1020 or so to which the time itself is known

double log2_of(const Wide& x) {
  int exponent = 0;
  const Wide significand = frexp(x, &exponent);
  return exponent + std::log2(static_cast<double>(significand));
}

/// The time in units of 2^time_exponent: each step but the conversions is rounded once, and nothing cancels.
Wide time_of(exact::Kind kind, Verdict verdict, const LiftedQuadratic& q) {
  const Wide a(q.a), h(q.h), c(q.c);
  if (verdict == Verdict::turning) return -h / a;
  const Wide root = sqrt(Wide(q.D));
  if (kind == exact::Kind::block) return c / (root - h);
  return q.h > 0 ? Wide(-c / (root + h)) : Wide((root - h) / a);
}

/// (a t² + 2 Σ|r_k v_k| t + |r|² + L²) / (2 t √D) at a root, Σ|r_k v_k| / |h| at a turning.
double condition_of(const exact::TimingQuery& query, const exact::LiftUnits& units, const LiftedQuadratic& q,
                    Verdict verdict, const Wide& t) {
  Integer H = 0, M = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Integer r = exact::lifted(query.u_B[k], units.length) - exact::lifted(query.u_A[k], units.length);
    const Integer v = exact::lifted(query.v_B[k], units.speed) - exact::lifted(query.v_A[k], units.speed);
    H += abs(Integer(r * v));
    M += r * r;
  }
  const Integer L = exact::lifted(query.L, units.length);
  M += L * L;
  if (verdict == Verdict::turning) return static_cast<double>(Wide(H) / Wide(abs(q.h)));
  const Wide moved = Wide(q.a) * t * t + 2 * Wide(H) * t + Wide(M);
  return static_cast<double>(Wide(moved / (2 * t * sqrt(Wide(q.D)))));
}

bool rests_on_discriminant(Verdict verdict) {
  return verdict == Verdict::hit || verdict == Verdict::miss || verdict == Verdict::turning;
}

}  // namespace

struct ExactAnswer::Time {
  Wide t;
};

ExactAnswer::ExactAnswer(const TimingQuery& query) : verdict_(Verdict::static_pair) {
  if (exact::is_static(query)) return;
  const exact::LiftUnits units = exact::units_of(query);
  const LiftedQuadratic q = exact::lifted_quadratic(query, units);
  verdict_ = exact::verdict_of(query.kind, q);
  if (rests_on_discriminant(verdict_) && q.D != 0 && q.c > 0) {
    const Integer L = exact::lifted(query.L, units.length);
    log2_from_tangency_ = log2_of(Wide(abs(q.D)) / Wide(q.a * L * L));
  }
  if (!occurs() || at_once()) return;
  const Wide t = time_of(query.kind, verdict_, q);
  condition_ = condition_of(query, units, q, verdict_, t);
  time_ = std::make_unique<Time>(Time{ldexp(t, q.time_exponent)});
  int exponent = 0;
  static_cast<void>(frexp(time_->t, &exponent));
  in_range_ = exponent > std::numeric_limits<double>::min_exponent &&
              exponent < std::numeric_limits<double>::max_exponent;
}

ExactAnswer::~ExactAnswer() = default;
ExactAnswer::ExactAnswer(ExactAnswer&&) noexcept = default;
ExactAnswer& ExactAnswer::operator=(ExactAnswer&&) noexcept = default;

double ExactAnswer::log2_error(const ExactNumber& number) const {
  Wide t(0);
  for (const double part : number.parts) t += Wide(part);
  const Wide error = abs(Wide(ldexp(t, number.exponent) - time_->t)) / time_->t;
  return error == 0 ? kNothing : std::max(kNothing, log2_of(error));
}

}  // namespace tps::cost

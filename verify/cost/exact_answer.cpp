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

/// What a t² + 2 h t + c is a sum of, in the units of its coefficients.
struct Terms {
  Integer H, rr, LL;  ///< Σ|r_k v_k|, |r|², L²
};

Terms terms_of(const exact::TimingQuery& query, const exact::LiftUnits& units) {
  Terms terms{0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const Integer r = exact::lifted(query.u_B[k], units.length) - exact::lifted(query.u_A[k], units.length);
    const Integer v = exact::lifted(query.v_B[k], units.speed) - exact::lifted(query.v_A[k], units.speed);
    terms.H += abs(Integer(r * v));
    terms.rr += r * r;
  }
  const Integer L = exact::lifted(query.L, units.length);
  terms.LL = L * L;
  return terms;
}

/// (a t² + 2 H t + M) / (2 t √D) at a root, H / |h| at a turning.
double condition_of(const Terms& terms, const LiftedQuadratic& q, Verdict verdict, const Wide& t) {
  if (verdict == Verdict::turning) return static_cast<double>(Wide(terms.H) / Wide(abs(q.h)));
  const Wide moved = Wide(q.a) * t * t + 2 * Wide(terms.H) * t + Wide(terms.rr + terms.LL);
  return static_cast<double>(Wide(moved / (2 * t * sqrt(Wide(q.D)))));
}

Magnitudes magnitudes_of(const Terms& terms, const LiftedQuadratic& q) {
  const Wide M(terms.rr + terms.LL);
  const Wide aM = Wide(q.a) * M;
  const auto share = [](const Wide& x, const Wide& of) {
    return of == 0 ? 0.0 : static_cast<double>(Wide(abs(x) / of));
  };
  const Integer hh = q.h * q.h;
  const Wide sum = Wide(abs(q.h)) + (q.D > 0 ? sqrt(Wide(q.D)) : Wide(0));
  return {share(Wide(q.h), Wide(terms.H)),
          share(Wide(q.c), M),
          share(Wide(q.D), aM),
          share(Wide(hh), aM),
          share(Wide(terms.rr), M),
          share(Wide(terms.LL), M),
          share(Wide(Integer(q.a * terms.rr - hh)), aM),
          share(sum * sum, aM)};
}

Wide value_of(const ExactNumber& number) {
  Wide t(0);
  for (const double part : number.parts) t += Wide(part);
  return ldexp(t, number.exponent);
}

bool rests_on_discriminant(Verdict verdict) {
  return verdict == Verdict::hit || verdict == Verdict::miss || verdict == Verdict::turning;
}

}  // namespace

struct ExactAnswer::Time {
  Wide t;
  Wide a, h, c, H, M;  ///< the quadratic, in units in which t is …
  int exponent;        ///< … 2^exponent times its root
};

ExactAnswer::ExactAnswer(const TimingQuery& query) : verdict_(Verdict::static_pair) {
  if (exact::is_static(query)) return;
  const exact::LiftUnits units = exact::units_of(query);
  const LiftedQuadratic q = exact::lifted_quadratic(query, units);
  const Terms terms = terms_of(query, units);
  verdict_ = exact::verdict_of(query.kind, q);
  magnitudes_ = magnitudes_of(terms, q);
  if (rests_on_discriminant(verdict_) && q.D != 0 && q.c > 0) {
    const Integer L = exact::lifted(query.L, units.length);
    log2_from_tangency_ = log2_of(Wide(abs(q.D)) / Wide(q.a * L * L));
  }
  if (!occurs() || at_once()) return;
  const Wide t = time_of(query.kind, verdict_, q);
  condition_ = condition_of(terms, q, verdict_, t);
  time_ = std::make_unique<Time>(Time{ldexp(t, q.time_exponent), Wide(q.a), Wide(q.h), Wide(q.c),
                                      Wide(terms.H), Wide(terms.rr + terms.LL), q.time_exponent});
  int exponent = 0;
  static_cast<void>(frexp(time_->t, &exponent));
  in_range_ = exponent > std::numeric_limits<double>::min_exponent &&
              exponent < std::numeric_limits<double>::max_exponent;
}

ExactAnswer::~ExactAnswer() = default;
ExactAnswer::ExactAnswer(ExactAnswer&&) noexcept = default;
ExactAnswer& ExactAnswer::operator=(ExactAnswer&&) noexcept = default;

double ExactAnswer::log2_error(const ExactNumber& number) const {
  const Wide error = abs(Wide(value_of(number) - time_->t)) / time_->t;
  return error == 0 ? kNothing : std::max(kNothing, log2_of(error));
}

double ExactAnswer::residual(const ExactNumber& number) const {
  const Time& q = *time_;
  const Wide t = ldexp(value_of(number), -q.exponent);
  const Wide f = (q.a * t + 2 * q.h) * t + q.c;
  return static_cast<double>(Wide(abs(f) / ((q.a * t + 2 * q.H) * t + q.M)));
}

}  // namespace tps::cost

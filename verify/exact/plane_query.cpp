#include "verify/exact/plane_query.hpp"

#include <algorithm>

#include "verify/exact/double_filter.hpp"
#include "verify/exact/double_word_filter.hpp"
#include "verify/exact/lifted_query.hpp"
#include "verify/exact/plane_time.hpp"

namespace tps::exact {
namespace {

Verdict verdict_of(Sign gap, Sign w) {
  if (w != Sign::negative) return Verdict::receding;
  if (gap == Sign::positive) return Verdict::hit;
  return gap == Sign::zero ? Verdict::contact : Verdict::overlap;
}

/// In double, where the sums are beyond their rounding: a difference, a product and two additions a term,
/// and one more for L, are below 6u of the sum of sizes.
std::optional<Verdict> verdict_in_double(const TimingQuery& query) {
  double gap = -query.L, w = 0;
  double gap_size = query.L, w_size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double of_r = query.normal[k] * (query.u_B[k] - query.u_A[k]);
    const double of_v = query.normal[k] * (query.v_B[k] - query.v_A[k]);
    gap += of_r;
    gap_size += std::fabs(of_r);
    w += of_v;
    w_size += std::fabs(of_v);
  }
  constexpr double u = unit_roundoff;
  const Sign of_w = sign_within(w, 8 * u * w_size + underflow_allowance);
  if (of_w == Sign::uncertain) return std::nullopt;
  if (of_w == Sign::positive) return Verdict::receding;
  const Sign of_gap = sign_within(gap, 8 * u * gap_size + underflow_allowance);
  if (of_gap == Sign::uncertain) return std::nullopt;
  return verdict_of(of_gap, of_w);
}

}  // namespace

LiftedPlane lifted_plane(const TimingQuery& query, const LiftUnits& units) {
  // Components are not above 2 in size, but a unit may be.
  int unit = 0;
  for (const double component : query.normal) unit = std::min(unit, unit_of(component));
  LiftedPlane plane{-(lifted(query.L, units.length) << static_cast<unsigned>(-unit)), 0, unit};
  for (std::size_t k = 0; k < 3; ++k) {
    const Integer n = lifted(query.normal[k], unit);
    plane.gap += n * (lifted(query.u_B[k], units.length) - lifted(query.u_A[k], units.length));
    plane.w += n * (lifted(query.v_B[k], units.speed) - lifted(query.v_A[k], units.speed));
  }
  return plane;
}

Verdict plane_verdict_of(const LiftedPlane& plane) {
  return verdict_of(sign_of(plane.gap), sign_of(plane.w));
}

Verdict plane_verdict(const TimingQuery& query, Counters& counters) {
  ++counters.verdict.calls;
  if (is_static(query)) return Verdict::static_pair;
  if (const std::optional<Verdict> verdict = verdict_in_double(query)) return *verdict;
  ++counters.verdict.uncertain;
  ++counters.verdict.exact;
  const LiftedPlane plane = lifted_plane(query, units_of(query));
  counters.largest_bits = std::max({counters.largest_bits, bits_of(plane.gap), bits_of(plane.w)});
  return plane_verdict_of(plane);
}

TPS_WITH_FMA std::optional<RefinedTime> refined_plane_time(const TimingQuery& query) {
  constexpr double u = unit_roundoff;
  const std::array<DoubleWord, 3> r = exact_difference(query.u_B, query.u_A);
  const std::array<DoubleWord, 3> v = exact_difference(query.v_B, query.v_A);
  DoubleWord gap{-query.L, 0}, towards{0, 0};
  double gap_size = query.L, towards_size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const DoubleWord of_r = r[k] * query.normal[k];
    const DoubleWord of_v = v[k] * -query.normal[k];
    gap = gap + of_r;
    towards = towards + of_v;
    gap_size += std::fabs(of_r.hi);
    towards_size += std::fabs(of_v.hi);
  }
  const bool in_range = gap_size > 0x1p-400 && gap_size < 0x1p400 && towards_size > 0x1p-400 &&
                        towards_size < 0x1p400 && towards.hi > 0x1p-40 * towards_size;
  if (!in_range) return std::nullopt;
  const double t = gap.hi / towards.hi;
  if (!(t > 0x1p-300 && t < 0x1p300)) return std::nullopt;
  const DoubleWord residual = gap - towards * t;
  const double correction = residual.hi / towards.hi;
  // Products 2u², three sums 3u² each, and what follows: docs/exact.md, "Planes".
  const double error = u * u * (16 * gap_size + 24 * towards_size * t) / towards.hi +
                       4 * u * std::fabs(correction) + underflow_allowance;
  return RefinedTime{t, correction, error};
}

AlgebraicTime plane_time(const TimingQuery& query, const LiftUnits& units) {
  const LiftedPlane plane = lifted_plane(query, units);
  return {-plane.w, -plane.gap, 0, 0, units.length - units.speed};
}

}  // namespace tps::exact

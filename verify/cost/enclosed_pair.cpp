#include "verify/cost/enclosed_pair.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tps::cost {
namespace {

AffineForm dot(const AffineVector& x, const AffineVector& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

}  // namespace

AffineVector operator+(const AffineVector& x, const AffineVector& y) {
  return {x[0] + y[0], x[1] + y[1], x[2] + y[2]};
}

AffineVector operator-(const AffineVector& x, const AffineVector& y) {
  return {x[0] - y[0], x[1] - y[1], x[2] - y[2]};
}

AffineVector operator*(const AffineForm& factor, const AffineVector& x) {
  return {factor * x[0], factor * x[1], factor * x[2]};
}

PairMotion::PairMotion(AffineVector r_at_base, AffineVector v_AB, double distance, long bits)
    : L(distance),
      r(std::move(r_at_base)),
      v(std::move(v_AB)),
      a(dot(v, v)),
      h(dot(r, v)),
      c(dot(r, r) - AffineForm(L, bits) * AffineForm(L, bits)),
      D(h * h - a * c) {}

AffineForm PairMotion::root(bool blocks) const {
  const AffineForm s = sqrt(D);
  return (blocks ? -h - s : s - h) * inverse(a);
}

double PairMotion::earliest_contact(double base) const {
  constexpr double kSlack = 0x1p-30;  // beyond the roundings of this line
  const double distance = std::sqrt(std::max(0.0, c.lower() + L * L)) * (1 - kSlack);
  const double gap = std::max(0.0, distance - L * (1 + kSlack)) * (1 - kSlack);
  const double speed = std::sqrt(a.upper()) * (1 + kSlack);
  const double time = base + gap / speed * (1 - kSlack);
  return gap > 0 ? time - kSlack * (std::fabs(base) + gap / speed) : base;
}

Response response_of(const Limit& limit, const PairMotion& m, long bits) {
  const AffineForm one(1, bits), c(limit.c, bits);
  const AffineForm per_L = inverse(AffineForm(limit.distance, bits));
  const AffineForm root = sqrt(m.D);
  const AffineVector u = per_L * (m.r + m.root(limit.blocks) * m.v);
  const AffineForm v_n = limit.blocks ? -(root * per_L) : root * per_L;
  const AffineVector normal = v_n * u;
  if (limit.blocks) return {"rebound", (one + c) * normal};

  const AffineForm tangent = tan_degrees(limit.theta_revolve_deg, bits);
  const AffineForm v_n_squared = m.D * per_L * per_L;
  const AffineForm v_w_squared = m.a - v_n_squared;
  // c_retract v_n > tan θ |v_w|, squared: neither side is negative.
  const CertainSign retracts = (c * c * v_n_squared - tangent * tangent * v_w_squared).sign();
  if (retracts == CertainSign::positive) return {"retract", (one + c) * normal};
  if (retracts != CertainSign::negative || v_w_squared.sign() != CertainSign::positive) return {};
  if (limit.c_revolve == 0) return {"revolve", m.v};
  // v_revolve = v_w − tan θ |v_w| û has length |v_w| / cos θ.
  const AffineForm speed = speed_ratio(limit.c_revolve, limit.theta_revolve_deg, bits) * sqrt(m.a) *
                           cos_degrees(limit.theta_revolve_deg, bits);
  const AffineVector revolved = (speed * inverse(sqrt(v_w_squared))) * (m.v - normal) - (speed * tangent) * u;
  return {"revolve", m.v - revolved};
}

}  // namespace tps::cost

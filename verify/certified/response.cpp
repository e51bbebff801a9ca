#include "verify/certified/response.hpp"

#include <cmath>

namespace tps::certified {

Real inverse_mass(double mass) {
  return std::isinf(mass) ? Real(0) : Real(1) / Real::of(mass);
}

Collision collision(RealVector r, RealVector v, const Real& inverse_A, const Real& inverse_B) {
  const Real rr = dot(r, r);
  const Real vr = dot(v, r);
  RealVector w = v - (vr / rr) * r;
  return {std::move(r), std::move(v), Real(1) / (inverse_A + inverse_B), rr, vr, std::move(w)};
}

RealVector collision_impulse(const Collision& pair, double c) {
  return ((Real(1) + Real::of(c)) * pair.mu * (pair.vr / pair.rr)) * pair.r;
}

RealVector revolution_impulse(const Collision& pair, double c_revolve, double theta_deg) {
  const Real cos_squared = cos_squared_degrees(theta_deg);
  const Real after_squared = squared_speed_ratio(c_revolve, theta_deg) * dot(pair.v, pair.v);  // |v'|²
  const Real ww = dot(pair.w, pair.w);
  const Real across = sqrt(after_squared * cos_squared / ww);
  // One root of a ratio, not two: where w and tan θ |w| û cancel in a component, they do so exactly.
  const Real slope = sqrt((Real(1) - cos_squared) / cos_squared * (ww / pair.rr));
  return pair.mu * (pair.v - across * (pair.w - slope * pair.r));
}

TetherDecision tether_decision(const Collision& pair, double c_retract, double theta_deg) {
  const Real c = Real::of(c_retract);
  const Real across_squared = dot(pair.w, pair.w);
  // Both sides squared, times |r|² cos²θ: no root is left, and only the angle may be irrational.
  const Real cos_squared = cos_squared_degrees(theta_deg);
  const Real closing = c * c * pair.vr * pair.vr * cos_squared;
  const Real needed = (Real(1) - cos_squared) * across_squared * pair.rr;
  const Sign excess = sign(closing - needed);
  const bool radial = sign(across_squared) == Sign::zero;
  return {radial || excess == Sign::positive, excess == Sign::zero || excess == Sign::uncertain};
}

RealVector load_velocity(const Real& inverse_A, const Real& inverse_B, const RealVector& v_A,
                         const RealVector& v_B) {
  const Real sum = inverse_A + inverse_B;
  return (inverse_B / sum) * v_A + (inverse_A / sum) * v_B;
}

}  // namespace tps::certified

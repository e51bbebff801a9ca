/* Eqs. (2), (3), (4), (6) behind the header, in double or with -DREAL=float -DBITS=24 in float:
 * cc -O2 -shared -fPIC -I REPOSITORY adapter.c -o adapter.so -lm; tps conform --library ./adapter.so */
#include <tgmath.h>

#include "properties/c_abi/tps_implementation.h"

#ifndef REAL
#define REAL double
#define BITS 53
#endif
typedef REAL real;
#define EACH(expression) for (int k = 0; k < 3; ++k) expression

static real dot(const real a[3], const real b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
static tps_status say(tps_time *answer, tps_verdict verdict, int occurs, real t) {
  *answer = (tps_time){verdict, occurs, t};
  return t - t == 0 ? TPS_ANSWERED : TPS_REFUSED; /* neither infinite nor undefined */
}

/* a, h, c and D of a t^2 + 2 h t + c (docs/eq2.md says why so) */
typedef struct { real a, h, c, D; } quadratic;
static quadratic quadratic_of(const tps_pair *p, real L) {
  real r[3], v[3];
  EACH(r[k] = (real)p->u_B[k] - (real)p->u_A[k]);
  EACH(v[k] = (real)p->v_B[k] - (real)p->v_A[k]);
  const real across[3] = {r[1] * v[2] - r[2] * v[1], r[2] * v[0] - r[0] * v[2], r[0] * v[1] - r[1] * v[0]};
  const real a = dot(v, v), h = dot(r, v), distance = sqrt(dot(r, r)), c = (distance - L) * (distance + L);
  return (quadratic){a, h, c, h * h < a * L * L ? h * h - a * c : a * L * L - dot(across, across)};
}
static tps_status block_time(const tps_pair *pair, double L, tps_time *t) {
  const quadratic q = quadratic_of(pair, (real)L);
  if (q.a == 0 || q.h >= 0) return say(t, q.a == 0 ? TPS_STATIC : TPS_RECEDING, 0, 0);
  if (q.c <= 0) return say(t, q.c < 0 ? TPS_OVERLAP : TPS_CONTACT, 1, 0);
  if (q.D <= 0) return say(t, q.D < 0 ? TPS_MISS : TPS_TANGENT, 0, 0);
  return say(t, TPS_HIT, 1, q.c / (-q.h + sqrt(q.D)));
}
static tps_status tether_time(const tps_pair *pair, double L, tps_time *t) {
  const quadratic q = quadratic_of(pair, (real)L);
  if (q.a == 0) return say(t, TPS_STATIC, 0, 0);
  if (q.c >= 0 && q.h >= 0) return say(t, q.c > 0 ? TPS_OVERSTRETCHED : TPS_TAUT, 1, 0);
  if (q.c > 0 && q.D <= 0) return say(t, TPS_TURNING, 1, -q.h / q.a);
  return say(t, TPS_HIT, 1, q.h > 0 ? -q.c / (q.h + sqrt(q.D)) : (-q.h + sqrt(q.D)) / q.a);
}
static real reduced(real m_A, real m_B) { return 1 / (1 / m_A + 1 / m_B); }
static tps_status apply_impulse(int n, double m_A, double m_B, const double v_A[3], const double v_B[3], const double dp[3],
                                double new_A[3], double new_B[3]) {
  for (int k = 0; k < n; ++k) new_A[k] = (real)v_A[k] + (real)dp[k] / (real)m_A, new_B[k] = (real)v_B[k] - (real)dp[k] / (real)m_B;
  return TPS_ANSWERED;
}
static tps_status collision_impulse(const tps_pair *p, double m_A, double m_B, double c, double dp[3]) {
  real n[3], v[3];
  EACH(n[k] = (real)p->u_B[k] - (real)p->u_A[k]);
  EACH(v[k] = (real)p->v_B[k] - (real)p->v_A[k]);
  const real distance = sqrt(dot(n, n));
  EACH(n[k] /= distance);
  const real v_n = dot(v, n);
  EACH(dp[k] = (1 + (real)c) * reduced((real)m_A, (real)m_B) * (v_n * n[k]));
  return TPS_ANSWERED;
}
static tps_status load(int n, double m_A, double m_B, const double v_A[3], const double v_B[3], double v[3]) {
  const real w_A = 1 / (1 + (real)m_B / (real)m_A), w_B = 1 / (1 + (real)m_A / (real)m_B);
  for (int k = 0; k < n; ++k) v[k] = w_A * (real)v_A[k] + w_B * (real)v_B[k];
  return TPS_ANSWERED;
}
static const tps_implementation table = {TPS_IMPLEMENTATION_VERSION, "C", BITS, block_time, tether_time, 0, apply_impulse,
                                         collision_impulse, 0, 0, load, 0, 0};
const tps_implementation *tps_get_implementation(void) { return &table; }

/* A whole implementation behind tps_implementation.h, in double: what a library of yours may look like. It offers all
 * operations but `order` and `group`, the three of effects beyond the paper among them. Built a second time with TPS_EXAMPLE_BUG it forgets 1 in (1 + c): see how the
 * laws find that (docs/properties.md). Build without contraction to fused multiply-adds: -ffp-contract=off.
 */
#include <math.h>
#include <stddef.h>

#include "properties/c_abi/tps_implementation.h"

#ifdef TPS_EXAMPLE_BUG
static double one_plus(double c) { return c; }
#else
static double one_plus(double c) { return 1 + c; }
#endif

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static double length(const double a[3]) { return sqrt(dot(a, a)); }

static void difference(const double a[3], const double b[3], double result[3]) {
  for (int k = 0; k < 3; ++k) result[k] = a[k] - b[k];
}

static double reduced_mass(double m_A, double m_B) { return 1 / (1 / m_A + 1 / m_B); }

/* Eq. (2): a t^2 + 2 h t + c = 0. */
typedef struct approach {
  double a, h, c, D;
} approach;

static approach approach_of(const tps_pair *pair, double L) {
  double r[3], v[3];
  difference(pair->u_B, pair->u_A, r);
  difference(pair->v_B, pair->v_A, v);
  const double rr = dot(r, r), distance = sqrt(rr);
  const double x = r[1] * v[2] - r[2] * v[1], y = r[2] * v[0] - r[0] * v[2], z = r[0] * v[1] - r[1] * v[0];
  approach q;
  q.a = dot(v, v);
  q.h = dot(r, v);
  q.c = distance < 2 * L ? (distance - L) * (distance + L) : rr - L * L;
  q.D = q.h * q.h < q.a * L * L ? q.h * q.h - q.a * q.c : q.a * L * L - (x * x + y * y + z * z);
  return q;
}

static tps_status answer_time(tps_time *answer, tps_verdict verdict, double t) {
  answer->verdict = verdict;
  answer->occurs = 1;
  answer->t = t;
  return TPS_ANSWERED;
}

static tps_status answer_never(tps_time *answer, tps_verdict verdict) {
  answer->verdict = verdict;
  answer->occurs = 0;
  return TPS_ANSWERED;
}

static tps_status block_time(const tps_pair *pair, double L, tps_time *answer) {
  const approach q = approach_of(pair, L);
  if (q.a == 0) return answer_never(answer, TPS_STATIC);
  if (q.h >= 0) return answer_never(answer, TPS_RECEDING);
  if (q.c < 0) return answer_time(answer, TPS_OVERLAP, 0);
  if (q.c == 0) return answer_time(answer, TPS_CONTACT, 0);
  if (q.D < 0) return answer_never(answer, TPS_MISS);
  if (q.D == 0) return answer_never(answer, TPS_TANGENT);
  return answer_time(answer, TPS_HIT, q.c / (-q.h + sqrt(q.D)));
}

static tps_status tether_time(const tps_pair *pair, double L, tps_time *answer) {
  const approach q = approach_of(pair, L);
  if (q.a == 0) return answer_never(answer, TPS_STATIC);
  if (q.c < 0)
    return answer_time(answer, TPS_HIT, q.h <= 0 ? (-q.h + sqrt(q.D)) / q.a : -q.c / (q.h + sqrt(q.D)));
  if (q.h >= 0) return answer_time(answer, q.c == 0 ? TPS_TAUT : TPS_OVERSTRETCHED, 0);
  if (q.c == 0) return answer_time(answer, TPS_HIT, -2 * q.h / q.a);
  if (q.D > 0) return answer_time(answer, TPS_HIT, (-q.h + sqrt(q.D)) / q.a);
  return answer_time(answer, TPS_TURNING, -q.h / q.a);
}

static tps_status apply_impulse(int dimension, double m_A, double m_B, const double v_A[3], const double v_B[3],
                                const double dp[3], double new_A[3], double new_B[3]) {
  for (int k = 0; k < dimension; ++k) {
    new_A[k] = v_A[k] + dp[k] / m_A;
    new_B[k] = v_B[k] - dp[k] / m_B;
  }
  return TPS_ANSWERED;
}

/* The axis of a collision, and the relative velocity along and across it. */
typedef struct frame {
  double u_hat[3], v_AB[3], v_n, v_w[3];
} frame;

static frame frame_of(const tps_pair *pair) {
  frame f;
  double r[3];
  difference(pair->u_B, pair->u_A, r);
  difference(pair->v_B, pair->v_A, f.v_AB);
  const double distance = length(r);
  for (int k = 0; k < 3; ++k) f.u_hat[k] = r[k] / distance;
  f.v_n = dot(f.v_AB, f.u_hat);
  for (int k = 0; k < 3; ++k) f.v_w[k] = f.v_AB[k] - f.v_n * f.u_hat[k];
  return f;
}

static tps_status collision_impulse(const tps_pair *pair, double m_A, double m_B, double c, double dp[3]) {
  const frame f = frame_of(pair);
  for (int k = 0; k < 3; ++k) dp[k] = one_plus(c) * reduced_mass(m_A, m_B) * (f.v_n * f.u_hat[k]);
  return TPS_ANSWERED;
}

static double tan_degrees(double theta) {
  const double to_radians = 3.14159265358979323846 / 180;
  if (theta == 45) return 1;
  return theta > 45 ? 1 / tan((90 - theta) * to_radians) : tan(theta * to_radians);
}

static tps_status revolution_impulse(const tps_pair *pair, double m_A, double m_B, double c_revolve,
                                     double theta_revolve_deg, double dp[3]) {
  const frame f = frame_of(pair);
  const double across = length(f.v_w);
  if (across == 0) return TPS_REFUSED;
  double v_revolve[3];
  for (int k = 0; k < 3; ++k) v_revolve[k] = f.v_w[k] - tan_degrees(theta_revolve_deg) * across * f.u_hat[k];
  const double speed = pow(c_revolve, theta_revolve_deg / 180) * length(f.v_AB);
  const double size = length(v_revolve);
  for (int k = 0; k < 3; ++k) dp[k] = reduced_mass(m_A, m_B) * (f.v_AB[k] - speed * (v_revolve[k] / size));
  return TPS_ANSWERED;
}

static tps_status tether_response(const tps_pair *pair, double m_A, double m_B, double c_retract, double c_revolve,
                                  double theta_revolve_deg, tps_response *kind, double dp[3], double new_A[3],
                                  double new_B[3]) {
  const frame f = frame_of(pair);
  const double across = length(f.v_w);
  const int retracts = across == 0 || fabs(c_retract * f.v_n) > tan_degrees(theta_revolve_deg) * across;
  *kind = retracts ? TPS_RETRACT : TPS_REVOLVE;
  if (retracts) {
    collision_impulse(pair, m_A, m_B, c_retract, dp);
  } else {
    revolution_impulse(pair, m_A, m_B, c_revolve, theta_revolve_deg, dp);
  }
  return apply_impulse(3, m_A, m_B, pair->v_A, pair->v_B, dp, new_A, new_B);
}

static tps_status load(int dimension, double m_A, double m_B, const double v_A[3], const double v_B[3],
                       double v_load[3]) {
  for (int k = 0; k < dimension; ++k) v_load[k] = 1 / (1 + m_B / m_A) * v_A[k] + 1 / (1 + m_A / m_B) * v_B[k];
  return TPS_ANSWERED;
}

static tps_status restitution_impulse(int dimension, double m_A, double m_B, const double v_A[3], const double v_B[3],
                                      const double dp[3], double dp_AB[3]) {
  for (int k = 0; k < dimension; ++k) dp_AB[k] = dp[k] - reduced_mass(m_A, m_B) * (v_B[k] - v_A[k]);
  return TPS_ANSWERED;
}

static tps_status wall_time(const tps_pair *pair, double L, const double normal[3], tps_time *answer) {
  double r[3], v[3];
  difference(pair->u_B, pair->u_A, r);
  difference(pair->v_B, pair->v_A, v);
  const double gap = dot(normal, r) - L, towards = -dot(normal, v);
  if (v[0] == 0 && v[1] == 0 && v[2] == 0) return answer_never(answer, TPS_STATIC);
  if (towards <= 0) return answer_never(answer, TPS_RECEDING);
  if (gap <= 0) return answer_time(answer, gap < 0 ? TPS_OVERLAP : TPS_CONTACT, 0);
  return answer_time(answer, TPS_HIT, gap / towards);
}

static tps_status drag_time(double gamma, double s, tps_time *answer) {
  if (gamma * s >= 1) return answer_never(answer, TPS_MISS);
  return answer_time(answer, TPS_HIT, -log1p(-gamma * s) / gamma);
}

static void cross(const double a[3], const double b[3], double result[3]) {
  for (int k = 0; k < 3; ++k) result[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

static tps_status rough_impulse(const tps_rough_pair *q, tps_contact *contact, double dp[3], double new_A[3],
                                double new_B[3], double new_spin_A[3], double new_spin_B[3]) {
  const frame f = frame_of(&q->pair);
  const double K = q->pair.dimension == 2 ? 1. / 2 : 2. / 5; /* I/(m R^2) of a disc, of a sphere */
  double surface[3], turned[3], slip[3], across[3], turn[3];
  for (int k = 0; k < 3; ++k) surface[k] = q->R_A * q->spin_A[k] + q->R_B * q->spin_B[k];
  cross(surface, f.u_hat, turned);
  difference(f.v_w, turned, slip);
  collision_impulse(&q->pair, q->m_A, q->m_B, q->c, dp);
  const double held = (1 + q->beta0) * K / (1 + K) * reduced_mass(q->m_A, q->m_B), speed = length(slip);
  const double most = q->mu * length(dp);
  *contact = held * speed <= most ? TPS_STICKS : TPS_SLIDES;
  for (int k = 0; k < 3; ++k) {
    across[k] = *contact == TPS_STICKS ? held * slip[k] : most / speed * slip[k];
    dp[k] += across[k];
  }
  cross(f.u_hat, across, turn);
  for (int k = 0; k < 3; ++k) {
    new_spin_A[k] = q->spin_A[k] + turn[k] / (K * q->m_A * q->R_A);
    new_spin_B[k] = q->spin_B[k] + turn[k] / (K * q->m_B * q->R_B);
  }
  return apply_impulse(3, q->m_A, q->m_B, q->pair.v_A, q->pair.v_B, dp, new_A, new_B);
}

const tps_implementation *tps_get_implementation(void) {
  static const tps_implementation table = {
      .version = TPS_IMPLEMENTATION_VERSION,
      .name = "example in C",
      .bits = 53,
      .block_time = block_time,
      .tether_time = tether_time,
      .apply_impulse = apply_impulse,
      .collision_impulse = collision_impulse,
      .revolution_impulse = revolution_impulse,
      .tether_response = tether_response,
      .load = load,
      .restitution_impulse = restitution_impulse,
      .wall_time = wall_time,
      .drag_time = drag_time,
      .rough_impulse = rough_impulse,
  };
  return &table;
}

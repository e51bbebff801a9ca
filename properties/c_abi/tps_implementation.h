/* An implementation of the tethered particle system as a shared library, in plain C.
 *
 * A library that `tps properties --library FILE` can load exports one function, tps_get_implementation(),
 * which returns a table of operations. An operation that is not offered is a null pointer. Operations and
 * their symbols are those of docs/protocol.md; every number is in one consistent set of units. Vectors have
 * three components; in the plane (dimension 2) the third is 0 on the way in and ignored on the way out.
 * Masses are above 0 and may be INFINITY, one of two at most. The functions are called one at a time, from
 * one thread, and keep nothing.
 *
 * This header may be copied: it needs nothing else.
 */
#ifndef TPS_IMPLEMENTATION_H
#define TPS_IMPLEMENTATION_H

#ifdef __cplusplus
extern "C" {
#endif

/* Grows when the table does. A library with a table of version 1, which ends before wall_time, is still taken. */
#define TPS_IMPLEMENTATION_VERSION 2

/* What an operation returns. */
typedef enum tps_status {
  TPS_ANSWERED = 0,
  TPS_REFUSED = 1 /* there is no answer, or it is beyond the range of the numbers computed with */
} tps_status;

typedef enum tps_verdict {
  TPS_STATIC = 0,
  TPS_RECEDING = 1,
  TPS_OVERLAP = 2,
  TPS_CONTACT = 3,
  TPS_MISS = 4,
  TPS_TANGENT = 5,
  TPS_HIT = 6,
  TPS_TAUT = 7,
  TPS_OVERSTRETCHED = 8,
  TPS_TURNING = 9
} tps_verdict;

typedef enum tps_limit { TPS_BLOCK = 0, TPS_TETHER = 1 } tps_limit;

typedef enum tps_order { TPS_BEFORE = 0, TPS_AFTER = 1, TPS_EQUAL = 2, TPS_NONE = 3 } tps_order;

typedef enum tps_response { TPS_RETRACT = 0, TPS_REVOLVE = 1 } tps_response;

typedef enum tps_contact { TPS_STICKS = 0, TPS_SLIDES = 1 } tps_contact;

/* Two particles: positions u, velocities v. */
typedef struct tps_pair {
  int dimension; /* 2 or 3 */
  double u_A[3], u_B[3], v_A[3], v_B[3];
} tps_pair;

/* When do they reach the distance L? */
typedef struct tps_query {
  tps_limit kind;
  tps_pair pair;
  double L; /* above 0 */
} tps_query;

typedef struct tps_time {
  tps_verdict verdict;
  int occurs; /* whether t is there */
  double t;   /* at least 0 */
} tps_time;

typedef struct tps_body {
  double m;
  double u[3], v[3];
} tps_body;

/* A collision of bodies i and j of a group, at their inner limit. */
typedef struct tps_collision {
  int i, j;
  double c; /* in [0, 1] */
} tps_collision;

/* Particles that turn: spins are angular velocities, in the plane the third component alone. */
typedef struct tps_rough_pair {
  tps_pair pair;
  double spin_A[3], spin_B[3];
  double m_A, m_B;
  double R_A, R_B; /* radii, above 0 */
  double c;        /* restitution along the axis, in [0, 1] */
  double mu;       /* coefficient of friction, at least 0 */
  double beta0;    /* restitution across the axis, in [-1, 1] */
} tps_rough_pair;

typedef struct tps_implementation {
  int version;      /* TPS_IMPLEMENTATION_VERSION */
  const char* name; /* for reports */
  int bits;         /* significant bits of the numbers computed with: 53 for double, 24 for float */

  tps_status (*block_time)(const tps_pair* pair, double L, tps_time* answer);  /* eq. (2) */
  tps_status (*tether_time)(const tps_pair* pair, double L, tps_time* answer); /* eq. (2) */
  tps_status (*order)(const tps_query* first, const tps_query* second, tps_order* answer);

  /* eq. (3): v_A' = v_A + dp/m_A, v_B' = v_B - dp/m_B */
  tps_status (*apply_impulse)(int dimension, double m_A, double m_B, const double v_A[3], const double v_B[3],
                              const double dp[3], double new_A[3], double new_B[3]);
  /* eq. (4) */
  tps_status (*collision_impulse)(const tps_pair* pair, double m_A, double m_B, double c, double dp[3]);
  /* eq. (5) */
  tps_status (*revolution_impulse)(const tps_pair* pair, double m_A, double m_B, double c_revolve,
                                   double theta_revolve_deg, double dp[3]);
  /* (4) where a retraction suffices, else (5), applied by (3) */
  tps_status (*tether_response)(const tps_pair* pair, double m_A, double m_B, double c_retract,
                                double c_revolve, double theta_revolve_deg, tps_response* kind, double dp[3],
                                double new_A[3], double new_B[3]);
  /* eq. (6) */
  tps_status (*load)(int dimension, double m_A, double m_B, const double v_A[3], const double v_B[3],
                     double v_load[3]);
  /* eq. (7) */
  tps_status (*restitution_impulse)(int dimension, double m_A, double m_B, const double v_A[3],
                                    const double v_B[3], const double dp[3], double dp_AB[3]);
  /* Loads the collisions in order, then unwinds: `loaded` and `restituted` have a row for each body. */
  tps_status (*group)(int dimension, int body_count, const tps_body* bodies, int collision_count,
                      const tps_collision* collisions, double (*loaded)[3], double (*restituted)[3]);

  /* Since version 2: effects beyond the paper (docs/effects.md). */

  /* B before a plane through A with this normal of length 1, at the distance L; verdicts as those of block_time */
  tps_status (*wall_time)(const tps_pair* pair, double L, const double normal[3], tps_time* answer);
  /* t = -ln(1 - gamma s)/gamma; where gamma s >= 1 it does not occur. The verdict is not read. */
  tps_status (*drag_time)(double gamma, double s, tps_time* answer);
  /* Eq. (4) along the axis, Walton's friction across it. */
  tps_status (*rough_impulse)(const tps_rough_pair* pair, tps_contact* contact, double dp[3], double new_A[3],
                              double new_B[3], double new_spin_A[3], double new_spin_B[3]);
} tps_implementation;

/* The one symbol of the library. What it returns lives as long as the library. */
const tps_implementation* tps_get_implementation(void);

#ifdef __cplusplus
}
#endif

#endif /* TPS_IMPLEMENTATION_H */

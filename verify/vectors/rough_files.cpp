// The strata of rough_impulse: rebounds of discs and spheres that turn.
#include <cmath>
#include <nlohmann/json.hpp>

#include "verify/vectors/stratum.hpp"

namespace tps::vectors {
namespace rough_files {
namespace {

constexpr int kCommitted = 24;

using Numbers = std::vector<double>;

/// R_A + R_B need not be |u_B − u_A|: the operation takes both as they are.
struct Rebound {
  Numbers u_A, u_B, v_A, v_B, spin_A, spin_B;
  double m_A, m_B, R_A, R_B, c, mu, beta0;
};

Rebound plain_in(Random& random, int dimension) {
  const int turns = dimension == 2 ? 1 : 3;
  return {.u_A = numbers_within(random, dimension, 2),
          .u_B = numbers_within(random, dimension, 2),
          .v_A = numbers_within(random, dimension, 1),
          .v_B = numbers_within(random, dimension, 1),
          .spin_A = numbers_within(random, turns, 2),
          .spin_B = numbers_within(random, turns, 2),
          .m_A = random.uniform(0.5, 2),
          .m_B = random.uniform(0.5, 2),
          .R_A = random.uniform(0.2, 1),
          .R_B = random.uniform(0.2, 1),
          .c = random.uniform(0, 1),
          .mu = random.uniform(0, 2),
          .beta0 = random.uniform(-1, 1)};
}

Rebound plain(Random& random) {
  return plain_in(random, 3);
}
Rebound planar(Random& random) {
  return plain_in(random, 2);
}

/// So rough that surfaces hold each other.
Rebound sticking(Random& random) {
  Rebound x = plain(random);
  x.mu = std::ldexp(1.0, random.integer(10, 40));
  return x;
}

/// So smooth that they slide.
Rebound sliding(Random& random) {
  Rebound x = plain(random);
  const double size = random.uniform(1, 2);
  x.mu = std::ldexp(size, -random.integer(5, 40));
  return x;
}

/// The ends of the ranges: without friction, without restitution across, perfectly rough.
Rebound coefficients(Random& random) {
  Rebound x = plain(random);
  x.c = random.integer(0, 1);
  x.beta0 = random.integer(-1, 1);
  const double mus[] = {0, 0.5, 1e300};
  x.mu = mus[random.integer(0, 2)];
  return x;
}

/// Ratios up to 1e15, and walls.
Rebound masses(Random& random) {
  Rebound x = plain(random);
  for (double* m : {&x.m_A, &x.m_B}) {
    const double significand = random.uniform(1, 2);
    *m = std::ldexp(significand, random.integer(-25, 24));
  }
  const int wall = random.integer(0, 3);
  if (wall == 0) x.m_A = HUGE_VAL;
  if (wall == 1) x.m_B = HUGE_VAL;
  return x;
}

/// Rolling surfaces: g_t is what cancels.
Rebound rolling(Random& random) {
  Rebound x = plain_in(random, 2);
  x.u_A = {0, 0};
  x.u_B = {random.uniform(0.5, 2), 0};
  const double slip = x.R_A * x.spin_A[0] + x.R_B * x.spin_B[0];
  x.v_B[1] = x.v_A[1] + slip;
  return x;
}

/// Small integers along (3, 4): û is (3, 4)/5, and both limits of friction are rational.
Rebound integers(Random& random) {
  Rebound x = plain_in(random, 2);
  x.u_A = {0, 0};
  x.u_B = {3, 4};
  for (Numbers* vector : {&x.v_A, &x.v_B, &x.spin_A, &x.spin_B}) {
    for (double& component : *vector) component = random.integer(-4, 4);
  }
  for (double* number : {&x.m_A, &x.m_B, &x.R_A, &x.R_B}) *number = std::ldexp(1.0, random.integer(-2, 2));
  x.c = random.integer(0, 2) / 2.0;
  x.mu = random.integer(0, 8) / 4.0;
  x.beta0 = random.integer(-2, 2) / 2.0;
  return x;
}

/// Both limits equal: μ (1 + c) |v_n| = κ (1 + β₀) |g_t|, κ = 1/3, with v_n = 1, g_t = 3 (1 + c) μ/(1 + β₀).
Rebound boundary(Random& random) {
  Rebound x = integers(random);
  x.u_B = {static_cast<double>(random.integer(1, 4)), 0};
  x.beta0 = random.coin() ? 0 : 1;
  x.mu = random.integer(1, 8) / 4.0;
  x.v_B[0] = x.v_A[0] - 1;
  const double surface = x.R_A * x.spin_A[0] + x.R_B * x.spin_B[0];  // S × û is along y
  x.v_B[1] = x.v_A[1] + surface + 3 * (1 + x.c) * x.mu / (1 + x.beta0);
  return x;
}

/// That boundary with one number changed in its last bit, a zero by what would be the last bit of 1.
Rebound near_boundary(Random& random) {
  Rebound x = boundary(random);
  double& number = random.coin() ? x.v_B[1] : x.v_B[0];
  const double towards = random.coin() ? 99 : -99;
  number = number == 0 ? std::copysign(0x1p-53, towards) : std::nextafter(number, towards);
  return x;
}

/// The speed along û, that of the surfaces across it, and the size of the terms of both.
struct Slip {
  double normal, across, terms;
};

double length(const Numbers& x) {
  double squared = 0;
  for (const double component : x) squared += component * component;
  return std::sqrt(squared);
}

Slip slip_of(const Rebound& x) {
  const std::size_t dimension = x.u_A.size();
  Numbers u(3, 0.0), v(3, 0.0), surface(3, 0.0);
  for (std::size_t k = 0; k < dimension; ++k) {
    u[k] = x.u_B[k] - x.u_A[k];
    v[k] = x.v_B[k] - x.v_A[k];
  }
  for (std::size_t k = 0; k < x.spin_A.size(); ++k)
    surface[dimension == 2 ? 2 : k] = x.R_A * x.spin_A[k] + x.R_B * x.spin_B[k];
  const double r = length(u);
  for (double& component : u) component /= r;
  const double normal = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  Numbers g_t(3);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    g_t[k] = v[k] - normal * u[k] - (surface[l] * u[m] - surface[m] * u[l]);
  }
  return {normal, length(g_t), length(v) + length(surface)};
}

/// The limits of friction differ by 2^-k of themselves, along any axis.
Rebound graded_boundary(Random& random) {
  for (;;) {
    Rebound x = plain_in(random, random.integer(2, 3));
    const double off = beside_one(random, 5, 45);
    const Slip slip = slip_of(x);
    if (std::fabs(slip.normal) < slip.terms / 8 || slip.across < slip.terms / 8) continue;
    const double kappa = x.u_A.size() == 2 ? 1.0 / 3 : 2.0 / 7;
    x.mu = kappa * (1 + x.beta0) * slip.across / ((1 + x.c) * std::fabs(slip.normal)) * off;
    return x;
  }
}

constexpr int kSpecial = 6;  ///< numbers that graded_coefficients() stands beside

/// One number beside one that is special by 2^-k, another one in each case and k in another decade in each
/// round: c at 0, where surfaces slide, or at 1, beta0 at -1 or 1, equal masses, equal spins.
Rebound graded_coefficients(Random& random, std::uint64_t number) {
  Rebound x = plain(random);
  const int decade = static_cast<int>(number / kSpecial % 4);
  const double little = std::ldexp(1.0, -5 - 10 * decade - random.integer(0, 9));
  switch (number % kSpecial) {
    case 0:
      x.c = little;
      x.mu = random.uniform(0.01, 0.05);
      break;
    case 1:
      x.c = 1 - little;
      break;
    case 2:
      x.beta0 = little - 1;
      break;
    case 3:
      x.beta0 = 1 - little;
      break;
    case 4:
      x.m_B = x.m_A * (1 + little);
      break;
    default:
      for (std::size_t k = 0; k < x.spin_A.size(); ++k) x.spin_B[k] = x.spin_A[k] * (1 + little);
  }
  return x;
}

Rebound float32(Random& random) {
  Rebound x = plain(random);
  for (Numbers* vector : {&x.u_A, &x.u_B, &x.v_A, &x.v_B, &x.spin_A, &x.spin_B}) {
    for (double& component : *vector) component = static_cast<float>(component);
  }
  for (double* number : {&x.m_A, &x.m_B, &x.R_A, &x.R_B, &x.c, &x.mu, &x.beta0})
    *number = static_cast<float>(*number);
  return x;
}

struct Family {
  const char* name;
  const char* why;
  Rebound (*rebound)(Random&);
};

constexpr Family families[] = {
    {"plain", "particles in a cube of edge 4, spins up to 2", plain},
    {"planar", "the same in the plane: discs", planar},
    {"sticking", "so rough that the surfaces hold each other", sticking},
    {"sliding", "so smooth that they slide", sliding},
    {"coefficients", "c, beta0 and mu at the ends of their ranges", coefficients},
    {"masses", "mass ratios up to 1e15, and infinite ones", masses},
    {"rolling", "surfaces that roll but for rounding", rolling},
    {"integers", "small integers and an axis (3, 4)/5: exact answers and zeros", integers},
    {"boundary", "both limits of friction are equal: either word passes", boundary},
    {"near_boundary", "one bit beside that boundary", near_boundary},
    {"float32", "every number exact in single precision", float32},
    {"graded_boundary", "the limits of friction differ by 2^-k of themselves, k from 5 to 45",
     graded_boundary},
};

/// A spin of the plane is a number.
Json spin(const Numbers& omega) {
  return omega.size() == 1 ? hex(omega[0]) : hex(omega);
}

Json input_of(const Rebound& x) {
  return {{"u_A", hex(x.u_A)},        {"u_B", hex(x.u_B)},        {"v_A", hex(x.v_A)}, {"v_B", hex(x.v_B)},
          {"spin_A", spin(x.spin_A)}, {"spin_B", spin(x.spin_B)}, {"m_A", hex(x.m_A)}, {"m_B", hex(x.m_B)},
          {"R_A", hex(x.R_A)},        {"R_B", hex(x.R_B)},        {"c", hex(x.c)},     {"mu", hex(x.mu)},
          {"beta0", hex(x.beta0)}};
}

}  // namespace
}  // namespace rough_files

void add_rough_strata(std::vector<Stratum>& strata) {
  const auto add = [&](const char* name, const char* why, auto rebound) {
    strata.push_back({Op::rough_impulse, name, why, rough_files::kCommitted,
                      [name, rebound](Random& random, std::uint64_t number) -> Problem {
                        return {rough_files::input_of(rebound(random, number)), {name}};
                      }});
  };
  for (const rough_files::Family& family : rough_files::families) {
    add(family.name, family.why, [&family](Random& random, std::uint64_t) { return family.rebound(random); });
  }
  add("graded_coefficients", "c, beta0, masses or spins beside special ones by 2^-k, k from 5 to 44",
      rough_files::graded_coefficients);
}

}  // namespace tps::vectors

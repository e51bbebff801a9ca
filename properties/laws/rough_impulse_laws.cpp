// A rebound of rough particles that turn, docs/effects.md.
#include "properties/generators/cases.hpp"
#include "properties/generators/numbers.hpp"
#include "properties/generators/pairs.hpp"
#include "properties/law.hpp"
#include "properties/laws/response_errors.hpp"

namespace tps::properties::rough {
namespace {

/// A pair that approaches (where the generated one separates, its velocities are exchanged), and surfaces
/// that hold or slide.
void rubbing_pair(Case& c, const Format& format) {
  put_pair(c, format);
  c.numbers.erase("L");
  const PairState p = c.pair();
  double h = 0;
  for (std::size_t k = 0; k < 3; ++k) h += (p.u_B[k] - p.u_A[k]) * (p.v_B[k] - p.v_A[k]);
  if (h > 0) c.set(PairState{p.u_A, p.u_B, p.v_B, p.v_A});
  c.set(masses(format));
  for (const char* who : {"_A", "_B"}) {
    c.set(std::string("R") + who, magnitude(format));
    c.set(std::string("spin") + who, coin() ? vector(format, c.dimension) : Vec3{});
  }
  c.set("c", coefficient(format));
  c.set("mu", one_of({0., .25, 1., 1024.}));
  const double sign = coin() ? 1 : -1;
  c.set("beta0", sign * coefficient(format));
}

RoughQuestion question(const Case& c) {
  return {c.pair(),        c.vector("spin_A"), c.vector("spin_B"), c.masses(),       c.number("R_A"),
          c.number("R_B"), c.number("c"),      c.number("mu"),     c.number("beta0")};
}

/// In the plane a case's spin is its first number.
WideVector spin_of(const Vec3& spin, int dimension) {
  return dimension == 2 ? wide({0, 0, spin[0]}) : wide(spin);
}

/// Both limits of friction and the impulse in real arithmetic, and their errors as docs/effects.md counts
/// them
/// ("Bound of J_t"): 18u G of g_t, 8u more of what multiplies it, (1 + c) m (9|v_AB| + 10|v_n|) u of |J_n|.
struct Friction {
  Friction(const RoughQuestion& q, int dimension, const Wide& u)
      : x(q.pair), mu(reduced_mass(q.m)), K(dimension == 2 ? Wide(1) / 2 : Wide(2) / 5) {
    const WideVector spin_A = spin_of(q.spin_A, dimension), spin_B = spin_of(q.spin_B, dimension);
    const WideVector surface = Wide(q.R_A) * spin_A + Wide(q.R_B) * spin_B;
    const Wide G = x.speed + Wide(q.R_A) * norm(spin_A) + Wide(q.R_B) * norm(spin_B);
    g_t = x.w - cross(surface, x.n);
    slip = norm(g_t);
    const Wide factor = K / (1 + K) * (1 + Wide(q.beta0)) * mu, push = (1 + Wide(q.c)) * mu;
    normal = push * x.v_n;
    holding = factor * slip;
    most = Wide(q.mu) * abs(normal);
    holding_error = factor * (18 * G + 8 * slip) * u * kSlack;
    most_error = Wide(q.mu) * push * (9 * x.speed + 10 * abs(x.v_n)) * u * kSlack;
    const Wide turned = slip > 0 ? std::min(Wide(2), Wide(36 * G / slip * u)) : Wide(2);
    sliding_error = most_error + turned * most * kSlack;
    normal_error = mu * collision_error(x, q.c, u);
  }

  bool is_open() const { return abs(Wide(holding - most)) <= holding_error + most_error; }
  WideVector across(bool sticks) const {
    if (slip == 0) return wide({});
    return Wide((sticks ? holding : most) / slip) * g_t;
  }
  /// Of Δp. Where rounding decides between the limits, the impulse is that of either to the error of both.
  Wide error(bool sticks) const {
    const Wide open = is_open() ? Wide(holding_error + most_error) : Wide(0);
    return normal_error + (sticks ? holding_error : sliding_error) + open;
  }

  Encounter x;
  Wide mu, K;
  WideVector g_t;
  Wide slip, normal, holding, most;
  Wide holding_error, most_error, sliding_error, normal_error;
};

struct Rub {
  Rub(Interview& ask, const Case& c)
      : q(question(c)), dimension(c.dimension), u(ask.u()), f(q, dimension, u), answer(ask.rough_impulse(q)) {
    if (f.x.v_n > 0) throw Unanswered{outside("the pair separates")};
    sticks = answer.kind == "sticks";
  }

  RoughQuestion q;
  int dimension;
  Wide u;
  Friction f;
  RoughAnswer answer;
  bool sticks = false;
};

Outcome is_a_kind(const Rub& k) {
  if (k.sticks || k.answer.kind == "slides") return {};
  return broken("the kind is " + k.answer.kind + "; allowed: sticks, slides");
}

Outcome the_impulse_is_of_both_equations(Interview& ask, const Case& c) {
  const Rub k(ask, c);
  const WideVector expected = k.f.normal * k.f.x.n + k.f.across(k.sticks);
  return all_of(is_a_kind(k), at_most("the error of Δp", norm(k.answer.dp - expected), k.f.error(k.sticks)));
}

Outcome the_smaller_limit_decides(Interview& ask, const Case& c) {
  const Rub k(ask, c);
  if (k.f.is_open()) return outside("rounding may decide between the limits");
  const std::string expected = k.f.holding < k.f.most ? "sticks" : "slides";
  return same("the kind, and that of the smaller limit", k.answer.kind, expected);
}

// As eq. (3): Δp/m errs by 1u, Δp times a rounded 1/m by 2u, the sum by 1u.
Outcome momentum_is_conserved(Interview& ask, const Case& c) {
  const Rub k(ask, c);
  const auto gained = [&](const char* who, const Wide& inverse, const Vec3& before, const WideVector& after,
                          const WideVector& dp) {
    return at_most(std::string("the error of v_") + who + "' = v_" + who + " ± Δp/m",
                   norm(after - wide(before) - inverse * dp),
                   k.u * (2 * inverse * norm(dp) + norm(after)) * kSlack);
  };
  return all_of(gained("A", inverse_mass(k.q.m.A), k.q.pair.v_A, k.answer.after.v_A, k.answer.dp),
                gained("B", inverse_mass(k.q.m.B), k.q.pair.v_B, k.answer.after.v_B, opposite(k.answer.dp)));
}

/// What û × Δp/(K m R) does to a spin; û errs by 5u, the part of Δp across by as much and its own u, product
/// and quotient by 8u, rounded up to 20u of |Δp|/(K m R); the sum by 2u.
struct Turned {
  Turned(const Rub& k, const Vec3& spin, const WideVector& after_in, double mass, double radius)
      : inverse(inverse_mass(mass) / (k.f.K * Wide(radius))),
        before(spin_of(spin, k.dimension)),
        after(after_in),
        error(k.u * (20 * norm(k.answer.dp) * inverse + 2 * norm(after)) * kSlack) {}

  Wide inverse;
  WideVector before, after;
  Wide error;
};

Outcome angular_momentum_about_the_contact_is_conserved(Interview& ask, const Case& c) {
  const Rub k(ask, c);
  const WideVector turn = cross(k.f.x.n, k.answer.dp);
  const auto turns = [&](const char* who, const Turned& t) {
    return at_most(std::string("the error of ω_") + who + "' = ω_" + who + " + û × Δp/(K m R)",
                   norm(t.after - t.before - t.inverse * turn), t.error);
  };
  return all_of(turns("A", {k, k.q.spin_A, k.answer.spin_A, k.q.m.A, k.q.R_A}),
                turns("B", {k, k.q.spin_B, k.answer.spin_B, k.q.m.B, k.q.R_B}));
}

/// What has infinite mass and turns does work, as a moving wall does.
bool is_driven(const RoughQuestion& q) {
  return (std::isinf(q.m.A) && q.spin_A != Vec3{}) || (std::isinf(q.m.B) && q.spin_B != Vec3{});
}

Outcome energy_never_grows(Interview& ask, const Case& c) {
  const Rub k(ask, c);
  if (is_driven(k.q)) return outside("what has infinite mass turns, and does work");
  const WideVector relative = k.answer.after.v_B - k.answer.after.v_A;
  const Wide of_velocities =
      k.u * (norm(k.answer.after.v_A) + norm(k.answer.after.v_B) + 2 * norm(k.answer.dp) / k.f.mu) * kSlack;
  const Wide of_relative = of_velocities + k.f.error(k.sticks) / k.f.mu;
  const Wide speed = norm(relative);
  Wide gained = k.f.mu / 2 * (speed * speed - k.f.x.speed * k.f.x.speed);
  Wide error = k.f.mu * of_relative * (speed + k.f.x.speed + of_relative);
  const auto add_spin = [&](const Turned& t, double mass, double radius) {
    if (std::isinf(mass)) return;
    const Wide inertia = k.f.K * Wide(mass) * Wide(radius) * Wide(radius);
    const Wide before = norm(t.before), after = norm(t.after);
    const Wide of_spin = t.error + k.f.error(k.sticks) * t.inverse;
    gained += inertia / 2 * (after * after - before * before);
    error += inertia * of_spin * (after + before + of_spin);
  };
  add_spin({k, k.q.spin_A, k.answer.spin_A, k.q.m.A, k.q.R_A}, k.q.m.A, k.q.R_A);
  add_spin({k, k.q.spin_B, k.answer.spin_B, k.q.m.B, k.q.R_B}, k.q.m.B, k.q.R_B);
  return at_most("the gain in energy of motion and spin", gained, error);
}

/// Two answers to what real arithmetic answers alike; `sign` is that of a spin.
Outcome same_rub(const std::string& how, const Rub& k, const RoughAnswer& other, const Wide& sign) {
  if (other.kind != k.answer.kind) {
    const Outcome kinds = same("the kind " + how, other.kind, k.answer.kind);
    return k.f.is_open() ? to_rounding(kinds.why + ", between which rounding may decide") : kinds;
  }
  const Wide error = 2 * k.f.error(k.sticks);
  const auto of_velocity = [&](double mass, const WideVector& v) {
    return Wide(error * inverse_mass(mass) +
                2 * k.u * kSlack * (2 * inverse_mass(mass) * norm(k.answer.dp) + norm(v)));
  };
  const Turned A(k, k.q.spin_A, k.answer.spin_A, k.q.m.A, k.q.R_A);
  const Turned B(k, k.q.spin_B, k.answer.spin_B, k.q.m.B, k.q.R_B);
  const auto spins = [&](const char* who, const WideVector& found, const Turned& t) {
    return same_to(std::string("ω_") + who + "' " + how, sign * found, t.after,
                   2 * t.error + error * t.inverse);
  };
  return all_of(
      same_to("Δp " + how, other.dp, k.answer.dp, error),
      same_to("v_A' " + how, other.after.v_A, k.answer.after.v_A, of_velocity(k.q.m.A, k.answer.after.v_A)),
      same_to("v_B' " + how, other.after.v_B, k.answer.after.v_B, of_velocity(k.q.m.B, k.answer.after.v_B)),
      spins("A", other.spin_A, A), spins("B", other.spin_B, B));
}

Outcome the_names_may_be_exchanged(Interview& ask, const Case& c) {
  const Rub k(ask, c);
  const RoughQuestion q{swapped(k.q.pair), k.q.spin_B, k.q.spin_A, swapped(k.q.m), k.q.R_B,
                        k.q.R_A,           k.q.c,      k.q.mu,     k.q.beta0};
  const RoughAnswer other = ask.rough_impulse(q);
  return same_rub(
      "with the names exchanged", k,
      {other.kind, opposite(other.dp), {other.after.v_B, other.after.v_A}, other.spin_B, other.spin_A}, 1);
}

/// Δp and velocities are mirrored with the axis, spins turn the other way about every other one.
Outcome the_first_axis_may_be_mirrored(Interview& ask, const Case& c) {
  const Rub k(ask, c);
  const auto mirror = [](const Vec3& x) { return Vec3{-x[0], x[1], x[2]}; };
  const auto mirror_back = [](const WideVector& x) { return WideVector{-x.x, x.y, x.z}; };
  const auto turn_back = [&](const Vec3& x) {
    return c.dimension == 2 ? Vec3{-x[0], x[1], 0} : Vec3{x[0], -x[1], -x[2]};
  };
  const PairState& p = k.q.pair;
  const RoughQuestion q{{mirror(p.u_A), mirror(p.u_B), mirror(p.v_A), mirror(p.v_B)},
                        turn_back(k.q.spin_A),
                        turn_back(k.q.spin_B),
                        k.q.m,
                        k.q.R_A,
                        k.q.R_B,
                        k.q.c,
                        k.q.mu,
                        k.q.beta0};
  const RoughAnswer other = ask.rough_impulse(q);
  return same_rub("with the first axis mirrored", k,
                  {other.kind,
                   mirror_back(other.dp),
                   {mirror_back(other.after.v_A), mirror_back(other.after.v_B)},
                   mirror_back(other.spin_A),
                   mirror_back(other.spin_B)},
                  -1);
}

}  // namespace

void add_laws(std::vector<Law>& laws) {
  const auto add = [&laws](const char* id, const char* number, const char* sentence, const auto& check) {
    laws.push_back(
        {{id, number, sentence, "docs/effects.md"}, {Op::rough_impulse}, cases(rubbing_pair), check});
  };
  add("RoughLaws.Law1TheImpulseIsOfBothEquations", "rough law 1",
      "along û Δp is that of eq. (4), across it min(μ |J_n|, κ (1 + β₀) m |g_t|) along g_t",
      the_impulse_is_of_both_equations);
  add("RoughLaws.Law2TheSmallerLimitDecides", "rough law 2",
      "surfaces stick where what holds them is the smaller limit beyond rounding, and slide where it is the "
      "larger",
      the_smaller_limit_decides);
  add("RoughLaws.Law3MomentumIsConserved", "rough law 3",
      "v_A' = v_A + Δp/m_A and v_B' = v_B − Δp/m_B, to u (2|Δp|/m + |v'|)", momentum_is_conserved);
  add("RoughLaws.Law4AngularMomentumAboutTheContactIsConserved", "rough law 4",
      "either spin changes by û × Δp/(K m R), to 20u |Δp|/(K m R) + 2u |ω'|: about the point of contact each "
      "particle's angular momentum is conserved",
      angular_momentum_about_the_contact_is_conserved);
  add("RoughLaws.Law5EnergyNeverGrows", "rough law 5",
      "where no infinite mass turns, the energy of motion and spins never grows, to rounding",
      energy_never_grows);
  add("RoughLaws.Law6TheNamesMayBeExchanged", "rough law 6",
      "A and B may be exchanged, spins, masses and radii with them, bitwise", the_names_may_be_exchanged);
  add("RoughLaws.Law7TheFirstAxisMayBeMirrored", "rough law 7",
      "the first axis may be mirrored, where spins about the others turn round, bitwise",
      the_first_axis_may_be_mirrored);
}

}  // namespace tps::properties::rough

// Rules bystanders, impulse and conservation for spins: who keeps one, how friction changes it, and the
// balances of angular momentum and of the whole energy. docs/check.md, "Friction".
#pragma once

#include "reference/equations/square_root.hpp"
#include "verify/trace_check/rules/conservation.hpp"

namespace tps::check {

/// A particle whose spin an event changes.
template <typename Number>
struct Turned {
  using W = Work<Number>;
  Vec<W> before, after, change;  ///< recorded; by û × Δp/(K m R)
  W inertia{0};
  W error{0};  ///< of after: all of it
};

/// Spins are copies between events, and stand only where friction acts on those who keep one.
template <typename Number>
void judge_spins_listed(const Context<Number>& c, const EventLine<Number>& event) {
  const Model<Number>& model = c.model;
  const bool rubs = event.kind == Kind::rebound && event.j >= 0 && model.rules.of(event.i, event.j).rubs;
  for (const InvolvedParticle<Number>& p : event.involved) {
    const bool turns = rubs && model.keeps_spin(p.particle);
    if (!turns && !p.spin_before && !p.spin_after) continue;
    c.tally.demand(Rule::bystanders, turns, [&](Finding& f) {
      f.particles = {model.id(p.particle)};
      f.message =
          fmt::format("particle {} is said to turn; no friction acts on its spin here", model.id(p.particle));
    });
    if (p.spin_before) {
      c.tally.demand(
          Rule::bystanders, *p.spin_before == model.spins[Model<Number>::at(p.particle)], [&](Finding& f) {
            f.particles = {model.id(p.particle)};
            const auto [found, right] =
                told_apart(*p.spin_before, model.spins[Model<Number>::at(p.particle)], 3);
            f.message = fmt::format("particle {} comes with spin {}, but left its last event with {}",
                                    model.id(p.particle), found, right);
          });
    }
    const bool moved =
        event.dp ? !(*event.dp == Vec<Number>{}) : !(p.velocity_after == model.flight(p.particle).velocity);
    if (turns && moved) {
      // A minimal trace may leave out what follows from the events before; a spin after friction does not.
      const bool is_whole = p.spin_after && (c.minimal || (p.spin_before && event.sticks));
      c.tally.demand(Rule::schema, is_whole, [&](Finding& f) {
        f.particles = {model.id(p.particle)};
        f.message =
            c.minimal ? "friction acts: \"spin\" in \"post\" is missing, by which the next rebound is judged"
                      : "friction acts: \"spin\" before and after and \"contact\" are missing";
      });
    }
  }
}

/// ω' = ω + û × Δp/(K m R): û errs by 5u, Δp's part across by that of Δp, products and quotient 7u; the sum
/// by u.
template <typename Number>
Turned<Number> turned_by(const Context<Number>& c, const EventLine<Number>& event, const BodiesNow<Number>& b,
                         int particle, const Vec<Work<Number>>& dp, const Work<Number>& dp_error) {
  using W = Work<Number>;
  const Model<Number>& model = c.model;
  const InvolvedParticle<Number>& p = *event.of(particle);
  const W K = inertia_ratio<W>(model.scene.dimension);
  const W R(model.radius(particle));
  const W inverse = model.inverse_masses[Model<Number>::at(particle)];
  Turned<Number> t;
  t.before = widened<W>(model.spins[Model<Number>::at(particle)]);
  t.after = p.spin_after ? widened<W>(*p.spin_after) : t.before;
  const W lever = inverse / (K * R);
  t.change = lever * cross(b.axis(), dp);
  t.inertia = K * R * R / inverse;
  t.error = W(20) * c.u() * lever * length(dp) + W(2) * c.u() * largest(t.after) +
            lever * (dp_error + W(2) * b.turn_of_axis() * length(dp)) + model.precision.smallest;
  return t;
}

/// Roundings of the balance of energy itself, in W, which alone are left where both bodies come to rest: at
/// most 64 in each of its terms (docs/check.md, "conservation"), and in J_t those of eq. (4) and of friction.
template <typename W>
struct OwnRoundings {
  W terms{0};     ///< μ |v|² and I ω² before and after, J_t |g_t|
  W surfaces{0};  ///< speeds of both bodies and of their surfaces, before and after

  W of(const W& error_of_impulse_in_u) const {
    return W(32) * std::numeric_limits<W>::epsilon() * (terms + error_of_impulse_in_u * surfaces);
  }
};

/// Spins after a rebound with friction, whether the surfaces stick, and what motion and spin have together.
template <typename Number>
void judge_friction(const Context<Number>& c, const EventLine<Number>& event, const BodiesNow<Number>& b,
                    const Expected<Work<Number>>& expected, const Rough<Work<Number>>& rough) {
  using W = Work<Number>;
  using std::abs;
  const Model<Number>& model = c.model;
  const bool acts = length(expected.response.dp) > W(0);
  if (event.sticks && acts) {
    c.tally.demand(Rule::impulse, rough.boundary || *event.sticks == rough.sticks, [&](Finding& f) {
      f.message =
          fmt::format("the surfaces of {} {}, but μ |J_n| is {} than what holds them", c.pair(b.i, b.j),
                      *event.sticks ? "stick" : "slide", rough.sticks ? "more" : "less");
    });
  }
  const Vec<W> dp = event.dp ? widened<W>(*event.dp) : expected.response.dp;
  const W dp_error = event.dp ? W(0) : W(expected.roundings) * expected.response.error;
  std::array<Turned<Number>, 2> turned;
  const std::array<int, 2> pair = {b.i, b.j};
  W gained(0), error_of_energy(0);
  OwnRoundings<W> own;
  Vec<W> angular{};
  for (std::size_t n = 0; n < 2; ++n) {
    if (!model.keeps_spin(pair[n])) continue;
    Turned<Number>& t = turned[n];
    t = turned_by(c, event, b, pair[n], dp, dp_error);
    const Vec<W> right = t.before + t.change;
    c.tally.within(Rule::impulse, as_double(W(W(20) * largest(t.after - right) / t.error)), 20,
                   [&](Finding& f) {
                     const auto [found, wanted] = told_apart(t.after, right, 3);
                     f.particles = {model.id(pair[n])};
                     f.message = fmt::format("particle {} leaves with spin {}, but ω + û × Δp/(K m R) is {}",
                                             model.id(pair[n]), found, wanted);
                   });
    gained += t.inertia / W(2) * (dot(t.after, t.after) - dot(t.before, t.before));
    own.terms += W(8) * t.inertia * (dot(t.after, t.after) + dot(t.before, t.before));
    own.surfaces += W(model.radius(pair[n])) * (length(t.after) + length(t.before));
    const W lever = t.inertia > W(0) ? W(model.radius(pair[n])) / t.inertia : W(0);
    const W off = t.error + lever * W(expected.roundings) * expected.response.error;
    error_of_energy += t.inertia * (length(t.after) * off + off * off);
    angular = angular + t.inertia * (t.after - t.before);
  }
  if (b.inverse_i == W(0) || b.inverse_j == W(0) || !acts) return;
  Balance<W> balance = balance_of(event, b);
  balance.exchanged = largest(dp);
  balance.directed = slack_of_parting(c, event, b, false, dp, dp_error, b.loads);
  detail::add_roundings(c, balance);
  const W stored = balance.rounding_i + balance.rounding_j;
  const Vec<W> of_i = W(W(1) / b.inverse_i) * (balance.after_i - balance.before_i);
  // Δp turns the spins at R_i and R_j, whose sum the pair's distance is to a rounding only: u of the
  // distance, and where the scalar is wider than the scene's doubles, half an ulp of a double.
  const W lever = W(model.radius(b.i)) + W(model.radius(b.j)) - b.distance();
  const Vec<W> L = angular - cross(b.r, of_i) - lever * cross(b.axis(), dp);
  const W bound = W(2) * b.distance() * stored + turned[0].inertia * turned[0].error * W(2) +
                  turned[1].inertia * turned[1].error * W(2);
  c.tally.within(Rule::conservation, as_double(W(W(3) * length(L) / bound)), 3, [&](Finding& f) {
    f.message = fmt::format("{} gain the angular momentum {}, orbit and spin together, beyond what Δp gives",
                            c.pair(b.i, b.j), shown(L, 3));
  });
  // Energy: of the relative motion, ½ m |v_AB|², and of both spins.
  const Vec<W> after = balance.after_j - balance.after_i;
  const W motion = b.mu / W(2) * (dot(after, after) - dot(b.v, b.v));
  const W normal = b.mu / W(2) *
                   (W(1) - W(model.rules.of(b.i, b.j).c_rebound) * W(model.rules.of(b.i, b.j).c_rebound)) *
                   b.v_n() * b.v_n();
  const W speed_error = square_root(W(model.scene.dimension)) *
                        (stored * (b.inverse_i + b.inverse_j) +
                         (b.inverse_i + b.inverse_j) * W(expected.roundings) * expected.response.error);
  own.terms += b.mu * (W(3) * dot(b.v, b.v) + dot(after, after));
  own.surfaces += length(b.v) + length(after);
  const W energy_bound = b.mu * (length(after) * speed_error + speed_error * speed_error) + error_of_energy +
                         own.of(expected.response.error / c.u()) + model.precision.smallest;
  const W off = motion + gained + normal + rough.lost;
  c.tally.within(Rule::conservation, as_double(W(W(3) * abs(off) / energy_bound)), 3, [&](Finding& f) {
    const auto [found, wanted] = told_apart(W(motion + gained), W(-normal - rough.lost));
    f.message = fmt::format("the energy of motion and spin of {} changes by {}; c, μ and β₀ make that {}",
                            c.pair(b.i, b.j), found, wanted);
  });
}

}  // namespace tps::check

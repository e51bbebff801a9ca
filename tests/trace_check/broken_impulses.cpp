// Impulses that are not those of eqs. (4) and (5). Velocities follow from them by eq. (3), and what a group
// keeps of them by eq. (7), so that nothing but the impulse is wrong.
#include <cmath>
#include <numbers>

#include "tests/trace_check/edits.hpp"

namespace tps::mutation {
namespace {

double reduced_mass(const Place& place) {
  return 1 / (1 / place.before.body_mass(place.i()) + 1 / place.before.body_mass(place.j()));
}

/// Collisions with an impulse far above rounding.
bool pushes(const Place& place) {
  if (!is_collision(place.event)) return false;
  const double change = length(numbers(place.event.at("dp"))) / reduced_mass(place);
  return change > 1e6 * epsilon(place.trace) * (1 + length(place.approach()));
}

bool pushes_by_eq4(const Place& place) {
  return pushes(place) && place.event.at("kind") != "revolve";
}

/// The same where the velocities after are those of the impulse, and nothing is stored.
bool pushes_by_eq4_alone(const Place& place) {
  return pushes_by_eq4(place) && !is_load(place.event);
}

/// What a condition needs to know of a revolution.
const TetheringLaw* revolves(const Place& place) {
  if (!pushes(place) || place.event.at("kind") != "revolve") return nullptr;
  return &*place.before.law(place.i(), place.j())->tethering;
}

Vec impulse(const Place& place) {
  return numbers(place.event.at("dp"));
}

/// Breaks a collision that meets a condition by giving it the impulse that `other` makes of its place.
template <typename Condition, typename Impulse>
Broken with_impulse(Trace& trace, std::uint64_t number, Condition meets, Impulse other) {
  const auto found = find_event(trace, number, meets);
  if (!found) return {};
  const Place place = place_of(trace, *found);
  set_impulse(trace, place, other(place));
  return number_of(trace, found->line);
}

Broken flipped(Trace& trace, std::uint64_t number) {
  return with_impulse(trace, number, pushes, [](const Place& p) { return Vec(-impulse(p)); });
}

Broken bounce_forgotten(Trace& trace, std::uint64_t number) {
  return with_impulse(
      trace, number, [](const Place& p) { return pushes_by_eq4(p) && coefficient(p) > 0; },
      [](const Place& p) { return Vec(impulse(p) / (1 + coefficient(p))); });
}

Broken c_off_by_1e6(Trace& trace, std::uint64_t number) {
  const double off = std::max(1e-6, 64 * epsilon(trace));
  return with_impulse(trace, number, pushes_by_eq4,
                      [off](const Place& p) { return Vec(impulse(p) * (1 + off / (1 + coefficient(p)))); });
}

/// A vector across the axis: of the motion where there is any, else of the first coordinate that has one.
Vec across(const Place& place) {
  const Vec u = place.axis();
  Vec w = place.approach() - u * place.normal_speed();
  for (std::size_t k = 0; k < u.size() && length(w) < 1e-3 * length(place.approach()); ++k) {
    Vec unit(0., u.size());
    unit[k] = 1;
    w = unit - u * u[k];
  }
  return w / length(w);
}

/// An impulse across the axis, as friction would give it.
Broken friction(Trace& trace, std::uint64_t number) {
  const double share = std::max(1e-6, 4096 * epsilon(trace));
  return with_impulse(trace, number, pushes_by_eq4, [share](const Place& p) {
    return Vec(impulse(p) + across(p) * (share * length(impulse(p))));
  });
}

/// Along the relative velocity, not along the line of centres.
Broken along_the_velocity(Trace& trace, std::uint64_t number) {
  const auto oblique = [](const Place& p) {
    return pushes_by_eq4(p) && length(p.approach()) > 1.01 * std::abs(p.normal_speed());
  };
  return with_impulse(trace, number, oblique, [](const Place& p) {
    return Vec(p.approach() * (length(impulse(p)) / length(p.approach()) * (p.normal_speed() < 0 ? -1 : 1)));
  });
}

/// |v_AB'| = c^x |v_AB| with an x that is not θ/π.
template <typename Exponent>
Broken with_exponent(Trace& trace, std::uint64_t number, Exponent exponent) {
  const auto lossy = [](const Place& p) { return revolves(p) != nullptr && revolves(p)->c_revolve < 1; };
  return with_impulse(trace, number, lossy, [&](const Place& p) {
    const TetheringLaw& law = *revolves(p);
    const double turn = law.theta_revolve_deg / 180;
    const Vec after = p.approach() - impulse(p) / reduced_mass(p);
    const double factor = exponent(turn, law.c_revolve);
    return Vec((p.approach() - after * (factor / std::pow(law.c_revolve, turn))) * reduced_mass(p));
  });
}

Broken exponent_of_a_half_turn(Trace& trace, std::uint64_t number) {
  return with_exponent(trace, number, [](double turn, double c) { return std::pow(c, 2 * turn); });
}

/// c θ/π read as a product, which is how the paper's print looks (decision D4).
Broken exponent_as_product(Trace& trace, std::uint64_t number) {
  return with_exponent(trace, number, [](double turn, double c) { return c * turn; });
}

Broken retracted_for_revolved(Trace& trace, std::uint64_t number) {
  const auto found = find_event(trace, number, [](const Place& p) {
    return revolves(p) != nullptr && std::abs(p.normal_speed()) > 1e-3 * length(p.approach());
  });
  if (!found) return {};
  const Place place = place_of(trace, *found);
  const double c = coefficient(place);
  set_impulse(trace, place, Vec(place.axis() * ((1 + c) * reduced_mass(place) * place.normal_speed())));
  trace.lines.change(found->line)["kind"] = "retract";
  settle(trace);
  return number_of(trace, found->line);
}

Broken revolved_for_retracted(Trace& trace, std::uint64_t number) {
  const auto found = find_event(trace, number, [](const Place& p) {
    return pushes(p) && p.event.at("kind") == "retract" &&
           length(p.approach()) > 1.001 * std::abs(p.normal_speed());
  });
  if (!found) return {};
  const Place place = place_of(trace, *found);
  const TetheringLaw& law = *place.before.law(place.i(), place.j())->tethering;
  const Vec u = place.axis();
  const Vec v = place.approach();
  const Vec tangential = v - u * place.normal_speed();
  const double slope = std::tan(law.theta_revolve_deg * std::numbers::pi / 180);
  const Vec direction = tangential - u * (slope * length(tangential));
  const double speed = std::pow(law.c_revolve, law.theta_revolve_deg / 180) * length(v);
  set_impulse(trace, place, Vec((v - direction * (speed / length(direction))) * reduced_mass(place)));
  trace.lines.change(found->line)["kind"] = "revolve";
  settle(trace);
  return number_of(trace, found->line);
}

/// More bounce than there was approach: energy from nowhere, momentum as it should be.
Broken energy_from_nowhere(Trace& trace, std::uint64_t number) {
  return with_impulse(trace, number, pushes_by_eq4_alone,
                      [](const Place& p) { return Vec(impulse(p) * (2.2 / (1 + coefficient(p)))); });
}

/// The velocity after a collision turned by a little: energy and momentum stay, angular momentum does not.
Broken turned_after(Trace& trace, std::uint64_t number) {
  const double angle = std::max(1e-6, 4096 * epsilon(trace));
  return with_impulse(trace, number, pushes_by_eq4_alone, [angle](const Place& p) {
    const Vec after = p.approach() - impulse(p) / reduced_mass(p);
    const Vec u = p.axis();
    const Vec w = across(p);
    const double along = dot(after, u);
    const double sideways = dot(after, w);
    const Vec turned = after + u * (along * (std::cos(angle) - 1) - sideways * std::sin(angle)) +
                       w * (sideways * (std::cos(angle) - 1) + along * std::sin(angle));
    return Vec((p.approach() - turned) * reduced_mass(p));
  });
}

}  // namespace

const std::vector<Mutation>& broken_impulses() {
  using enum check::Rule;
  static const std::vector<Mutation> list = {
      {"flipped", "an impulse pulls together what it should part", impulse, flipped},
      {"bounce_forgotten", "(1 + c) is 1", impulse, bounce_forgotten},
      {"c_off_by_1e6", "c is 1e-6 too large at one collision", impulse, c_off_by_1e6},
      {"friction", "an impulse has a part across the axis", impulse, friction},
      {"along_the_velocity", "an impulse is along the velocity, not along the line of centres", impulse,
       along_the_velocity},
      {"exponent_of_a_half_turn", "c_revolve to the power 2θ/π", impulse, exponent_of_a_half_turn},
      {"exponent_as_product", "c_revolve times θ/π", impulse, exponent_as_product},
      {"retracted_for_revolved", "a pair that should revolve is retracted", impulse, retracted_for_revolved},
      {"revolved_for_retracted", "a pair that should be retracted revolves", impulse, revolved_for_retracted},
      {"energy_from_nowhere", "a collision bounces with c = 1.2", conservation, energy_from_nowhere},
      {"turned_after", "the velocity after a collision is turned by 1e-6", conservation, turned_after},
  };
  return list;
}

}  // namespace tps::mutation

#include "properties/conform/response_margin.hpp"

#include <algorithm>
#include <map>

#include "properties/conform/effect_margins.hpp"
#include "properties/conform/mistakes.hpp"
#include "properties/laws/response_errors.hpp"

namespace tps::properties::conform {
namespace {

Vec3 vector_of(const Json& in, const char* key) {
  const std::vector<double> x = numbers_of(in.at(key)).value();
  return {x.at(0), x.at(1), x.size() > 2 ? x[2] : 0};
}

double number_of(const Json& in, const char* key) {
  return numbers_of(in.at(key)).value().at(0);
}

using Bounds = std::map<std::string, double>;

/// Δp of eq. (4): (1 + c) μ (8|v| + 13|v_n|).
double bound_of_collision(const Given& g, double c) {
  return (1 + c) * g.mu() * (8 * norm(g.v()) + 13 * std::fabs(g.v_n()));
}

/// v' = v ± Δp/m: 3(|v'| + |Δp|/m), and what Δp itself is off.
void add_velocities(Bounds& bounds, const Given& g, const Vec& dp, double off) {
  for (const char* which : {"v_A", "v_B"}) {
    const double m = g.number(which[2] == 'A' ? "m_A" : "m_B");
    bounds[which] = 3 * (norm(g.vec(which)) + 2 * norm(dp) / m) + off / m;
  }
}

/// In units u; empty for operations that K(k) judges alone.
Bounds bounds_of(Op op, const Given& g, const Json& out) {
  Bounds bounds;
  if (op == Op::apply_impulse) {
    add_velocities(bounds, g, g.vec("dp"), 0);
  } else if (op == Op::collision_impulse) {
    bounds["dp"] = bound_of_collision(g, g.number("c"));
  } else if (op == Op::tether_response && out.value("kind", Json()) == "retract") {
    const double c = g.number("c_retract");
    bounds["dp"] = bound_of_collision(g, c);
    add_velocities(bounds, g, ((1 + c) * g.mu() * g.v_n()) * g.n(), bounds["dp"]);
  } else if (op == Op::load) {
    const double w_A = 1 / (1 + g.number("m_B") / g.number("m_A")),
                 w_B = 1 / (1 + g.number("m_A") / g.number("m_B"));
    bounds["v_load"] = 6 * (w_A * norm(g.vec("v_A")) + w_B * norm(g.vec("v_B")));
  } else if (op == Op::rough_impulse) {
    return rough_bounds(g, out.value("kind", ""));
  } else if (op == Op::restitution_impulse) {
    bounds["dp_AB"] = 6 * (norm(g.vec("dp")) + g.mu() * norm(g.v()));
  }
  return bounds;
}

bool is_within(const ExpectedNumbers& expected, const Json& found, double bound) {
  const auto numbers = numbers_of(found);
  if (!numbers || numbers->size() != expected.ends.size()) return false;
  for (std::size_t n = 0; n < numbers->size(); ++n) {
    const double x = (*numbers)[n];
    const ExpectedNumbers::End& end = expected.ends[n];
    if (!(std::max(end.lo - x, x - end.hi) <= bound)) return false;
  }
  return true;
}

}  // namespace

bool within_bounds(const KnownQuestion& known, const Json& out, int bits) {
  const Bounds bounds = bounds_of(known.question.op, Given(known.question.in), out);
  const Expected expected = expected_of(known).front();
  const double u = std::ldexp(1.0, -std::min(bits, 53));
  return !bounds.empty() &&
         std::all_of(expected.numbers.begin(), expected.numbers.end(), [&](const auto& numbers) {
           const auto bound = bounds.find(numbers.key);
           return bound != bounds.end() && std::isfinite(bound->second) &&
                  is_within(numbers, out.value(numbers.key, Json()), u * bound->second);
         });
}

bool kind_is_open(const Question& question, int bits) {
  const Json& in = question.in;
  const Encounter x({vector_of(in, "u_A"), vector_of(in, "u_B"), vector_of(in, "v_A"), vector_of(in, "v_B")});
  const Wide angle = radians(number_of(in, "theta_revolve_deg"));
  const Wide slope = sin(angle) / cos(angle), c = number_of(in, "c_retract");
  const Wide apart = abs(Wide(c * abs(x.v_n) - slope * x.tangential));
  return apart <= 8 * ldexp(Wide(1), -bits) * (c + slope) * x.speed * kSlack;
}

}  // namespace tps::properties::conform

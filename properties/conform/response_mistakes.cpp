// Mistakes in eqs. (3) to (7).
#include "properties/conform/mistakes.hpp"

namespace tps::properties::conform {
namespace {

Vec rebound(const Given& g, double factor) {
  return (factor * g.mu() * g.v_n()) * g.n();
}

/// Eq. (5) with a ratio of speeds, a slope and a side of its own.
Vec revolution(const Given& g, double ratio, double slope, double side = 1) {
  const Vec direction = g.w() - (side * slope * norm(g.w())) * g.n();
  return g.mu() * (g.v() - (ratio * norm(g.v()) / norm(direction)) * direction);
}

/// v·û without the third component of either.
double v_n_of_two(const Given& g) {
  const Vec v = g.v(), n = g.n();
  return v[0] * n[0] + v[1] * n[1];
}

double right_ratio(const Given& g) {
  return std::pow(g.number("c_revolve"), g.angle() / M_PI);
}

using Impulse = std::function<Vec(const Given&)>;

/// "dp", and of a tether's response the velocities that eq. (3) makes of it.
Mistake impulse(std::string name, std::vector<Op> ops, Impulse dp, std::string word = {}) {
  return {std::move(name), std::move(ops), [dp = std::move(dp), word = std::move(word)](const Given& g) {
            const Vec pushed = dp(g);
            Mistaken answer{{{"dp", pushed}}, word};
            if (g.in().contains("c_retract")) {
              answer.numbers.emplace_back("v_A", g.vec("v_A") + (1 / g.number("m_A")) * pushed);
              answer.numbers.emplace_back("v_B", g.vec("v_B") - (1 / g.number("m_B")) * pushed);
            }
            return std::optional(std::move(answer));
          }};
}

Mistake velocities(std::string name, std::function<std::pair<Vec, Vec>(const Given&)> both) {
  return {std::move(name), {Op::apply_impulse}, [both = std::move(both)](const Given& g) {
            const auto [v_A, v_B] = both(g);
            return std::optional(Mistaken{{{"v_A", v_A}, {"v_B", v_B}}});
          }};
}

Mistake vector(std::string name, Op op, std::string key, Impulse of) {
  return {std::move(name), {op}, [key = std::move(key), of = std::move(of)](const Given& g) {
            return std::optional(Mistaken{{{key, of(g)}}});
          }};
}

}  // namespace

void add_response_mistakes(std::vector<Mistake>& m) {
  const auto pushed = [](const Given& g, double for_A, double for_B) {
    return std::pair{g.vec("v_A") + (for_A / g.number("m_A")) * g.vec("dp"),
                     g.vec("v_B") + (for_B / g.number("m_B")) * g.vec("dp")};
  };
  m.push_back(
      velocities("both particles pushed the same way", [=](const Given& g) { return pushed(g, 1, 1); }));
  m.push_back(velocities("A and B swapped", [=](const Given& g) { return pushed(g, -1, 1); }));
  m.push_back(velocities("half of Δp for each", [=](const Given& g) { return pushed(g, 0.5, -0.5); }));
  m.push_back(velocities("m_A and m_B swapped", [](const Given& g) {
    return std::pair{g.vec("v_A") + (1 / g.number("m_B")) * g.vec("dp"),
                     g.vec("v_B") - (1 / g.number("m_A")) * g.vec("dp")};
  }));
  m.push_back(velocities("Δp not divided by the mass", [](const Given& g) {
    return std::pair{g.vec("v_A") + g.vec("dp"), g.vec("v_B") - g.vec("dp")};
  }));

  const std::vector<Op> eq4{Op::collision_impulse}, eq5{Op::revolution_impulse};
  m.push_back(impulse("c instead of 1 + c", eq4, [](const Given& g) { return rebound(g, g.number("c")); }));
  m.push_back(impulse("c taken as 1", eq4, [](const Given& g) { return rebound(g, 2); }));
  m.push_back(impulse("c taken as 0", eq4, [](const Given& g) { return rebound(g, 1); }));
  m.push_back(impulse("A and B swapped", eq4, [](const Given& g) { return rebound(g, -1 - g.number("c")); }));
  m.push_back(
      impulse("1 − c instead of 1 + c", eq4, [](const Given& g) { return rebound(g, 1 - g.number("c")); }));
  m.push_back(impulse("the axis not a unit vector", eq4, [](const Given& g) {
    return (norm(g.r()) * norm(g.r())) * rebound(g, 1 + g.number("c"));
  }));
  m.push_back(impulse("the axis a unit vector once of twice", eq4,
                      [](const Given& g) { return norm(g.r()) * rebound(g, 1 + g.number("c")); }));
  m.push_back(impulse("the whole relative velocity instead of its normal part", eq4,
                      [](const Given& g) { return ((1 + g.number("c")) * g.mu()) * g.v(); }));
  m.push_back(impulse("m_A + m_B instead of the reduced mass", eq4, [](const Given& g) {
    return ((g.number("m_A") + g.number("m_B")) / g.mu()) * rebound(g, 1 + g.number("c"));
  }));
  m.push_back(impulse("m_A instead of the reduced mass", eq4, [](const Given& g) {
    return (g.number("m_A") / g.mu()) * rebound(g, 1 + g.number("c"));
  }));

  m.push_back(impulse("the smaller mass instead of the reduced mass", eq4, [](const Given& g) {
    return (std::min(g.number("m_A"), g.number("m_B")) / g.mu()) * rebound(g, 1 + g.number("c"));
  }));
  m.push_back(impulse("v_n of two components of three", eq4,
                      [](const Given& g) { return ((1 + g.number("c")) * g.mu() * v_n_of_two(g)) * g.n(); }));

  for (const Op op : {Op::revolution_impulse, Op::tether_response}) {
    const std::string word = op == Op::tether_response ? "revolve" : "";
    m.push_back(impulse(
        "the product c·θ/π as printed instead of the power (D4)", {op},
        [](const Given& g) {
          return revolution(g, g.number("c_revolve") * g.angle() / M_PI, std::tan(g.angle()));
        },
        word));
    m.push_back(impulse(
        "θ taken as radians", {op},
        [](const Given& g) {
          const double theta = g.number("theta_revolve_deg");
          return revolution(g, std::pow(g.number("c_revolve"), theta / M_PI), std::tan(theta));
        },
        word));
    m.push_back(impulse(
        "tan of θ taken as radians", {op},
        [](const Given& g) { return revolution(g, right_ratio(g), std::tan(g.number("theta_revolve_deg"))); },
        word));
    m.push_back(impulse(
        "outward instead of inward", {op},
        [](const Given& g) { return revolution(g, right_ratio(g), std::tan(g.angle()), -1); }, word));
    m.push_back(impulse(
        "c_revolve for every collision instead of a revolution", {op},
        [](const Given& g) { return revolution(g, g.number("c_revolve"), std::tan(g.angle())); }, word));
    m.push_back(impulse(
        "c_revolve to the power θ/2π", {op},
        [](const Given& g) { return revolution(g, std::sqrt(right_ratio(g)), std::tan(g.angle())); }, word));
    m.push_back(impulse(
        "|v_ŵ| instead of |v_AB|", {op},
        [](const Given& g) {
          return revolution(g, right_ratio(g) * norm(g.w()) / norm(g.v()), std::tan(g.angle()));
        },
        word));
    m.push_back(impulse(
        "c_revolve taken as 1", {op}, [](const Given& g) { return revolution(g, 1, std::tan(g.angle())); },
        word));
  }
  m.push_back(impulse("A and B swapped", eq5, [](const Given& g) {
    return -1.0 * revolution(g, right_ratio(g), std::tan(g.angle()));
  }));
  m.push_back(impulse(
      "retracts where it has to revolve", {Op::tether_response},
      [](const Given& g) { return rebound(g, 1 + g.number("c_retract")); }, "retract"));
  m.push_back(impulse(
      "revolves where retraction suffices", {Op::tether_response},
      [](const Given& g) { return revolution(g, right_ratio(g), std::tan(g.angle())); }, "revolve"));
  m.push_back(impulse(
      "c_revolve instead of c_retract", {Op::tether_response},
      [](const Given& g) { return rebound(g, 1 + g.number("c_revolve")); }, "retract"));

  m.push_back(vector("the mean of both velocities", Op::load, "v_load",
                     [](const Given& g) { return 0.5 * (g.vec("v_A") + g.vec("v_B")); }));
  m.push_back(vector("the weights swapped", Op::load, "v_load", [](const Given& g) {
    const double m_A = g.number("m_A"), m_B = g.number("m_B");
    return (1 / (1 + m_A / m_B)) * g.vec("v_A") + (1 / (1 + m_B / m_A)) * g.vec("v_B");
  }));
  m.push_back(vector("(7) without its subtraction", Op::restitution_impulse, "dp_AB",
                     [](const Given& g) { return g.vec("dp"); }));
  m.push_back(vector("added instead of subtracted", Op::restitution_impulse, "dp_AB",
                     [](const Given& g) { return g.vec("dp") + g.mu() * g.v(); }));
  m.push_back(vector("A and B swapped", Op::restitution_impulse, "dp_AB",
                     [](const Given& g) { return g.mu() * g.v() - g.vec("dp"); }));
}

}  // namespace tps::properties::conform

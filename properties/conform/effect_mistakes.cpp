// Mistakes in wall_time, drag_time and rough_impulse.
#include <algorithm>

#include "properties/conform/mistakes.hpp"

namespace tps::properties::conform {
namespace {

/// A time from a gap and a speed towards the plane; none where it is not approached.
std::optional<Mistaken> reached(double gap, double towards) {
  if (!(towards > 0)) return Mistaken{{{"t", Vec{}}}};
  return Mistaken{{{"t", Vec{std::max(0.0, gap / towards)}}}};
}

Mistake of_wall(std::string name, std::function<std::optional<Mistaken>(const Given&)> answer) {
  return {std::move(name), {Op::wall_time}, std::move(answer)};
}

Mistake of_drag(std::string name, std::function<double(double gamma, double s)> time) {
  return {std::move(name), {Op::drag_time}, [time = std::move(time)](const Given& g) {
            const double t = time(g.number("gamma"), g.number("s"));
            return std::isfinite(t) ? std::optional(Mistaken{{{"t", Vec{t}}}}) : std::nullopt;
          }};
}

/// What a rebound of rough particles is made of; each may be mistaken.
struct Slips {
  double spin_B = 1;        ///< factors of the spins in the velocity of the surfaces
  double mass = 1;          ///< of that of the contact
  bool whole_mass = false;  ///< μ instead of κμ
  double restitution = 1;   ///< of 1 + β₀
  double across = 1;        ///< of J_t
  bool limited = true;      ///< by μ |J_n|
};

Vec impulse(const Given& g, const Slips& slips) {
  const Vec n = g.n();
  const Vec S = g.number("R_A") * g.vec("spin_A") + (slips.spin_B * g.number("R_B")) * g.vec("spin_B");
  const Vec turned =
      n.size() == 2 ? Vec{-S[0] * n[1], S[0] * n[0]}
                    : Vec{S[1] * n[2] - S[2] * n[1], S[2] * n[0] - S[0] * n[2], S[0] * n[1] - S[1] * n[0]};
  const Vec slip = g.w() - turned;
  const double kappa = n.size() == 2 ? 1.0 / 3 : 2.0 / 7;
  const double contact = slips.whole_mass ? 1 : kappa;
  const double push = (1 + g.number("c")) * g.mu() * g.v_n();
  const double holding =
      slips.restitution * (1 + g.number("beta0")) * slips.mass * contact * g.mu() * norm(slip);
  const double most = slips.limited ? g.number("mu") * std::fabs(push) : HUGE_VAL;
  return push * n + (norm(slip) > 0 ? slips.across * std::min(holding, most) / norm(slip) : 0) * slip;
}

Mistake of_friction(std::string name, Slips slips) {
  return {std::move(name), {Op::rough_impulse}, [slips](const Given& g) {
            return std::optional(Mistaken{{{"dp", impulse(g, slips)}}});
          }};
}

}  // namespace

void add_effect_mistakes(std::vector<Mistake>& m) {
  const auto towards = [](const Given& g) { return -dot(g.vec("normal"), g.v()); };
  const auto height = [](const Given& g) { return dot(g.vec("normal"), g.r()); };
  m.push_back(of_wall("the centre instead of the surface of the particle",
                      [=](const Given& g) { return reached(height(g), towards(g)); }));
  m.push_back(of_wall("a particle that is at the plane or behind it lost", [=](const Given& g) {
    const double gap = height(g) - g.number("L");
    return gap <= 0 ? std::optional(Mistaken{{{"t", Vec{}}}}) : std::nullopt;
  }));
  m.push_back(of_wall("the normal turned round",
                      [=](const Given& g) { return reached(-height(g) - g.number("L"), -towards(g)); }));
  m.push_back(of_wall("the distance from the plane instead of the time to it", [=](const Given& g) {
    return reached(height(g) - g.number("L"), towards(g) > 0 ? 1 : 0);
  }));
  m.push_back(of_wall("the whole speed instead of that towards the plane", [=](const Given& g) {
    return reached(height(g) - g.number("L"), towards(g) > 0 ? norm(g.v()) : 0);
  }));

  m.push_back(of_drag("s itself", [](double, double s) { return s; }));
  m.push_back(of_drag("the logarithm not divided by γ",
                      [](double gamma, double s) { return -std::log1p(-gamma * s); }));
  m.push_back(of_drag("s of t instead of t of s",
                      [](double gamma, double s) { return -std::expm1(-gamma * s) / gamma; }));

  m.push_back(of_friction("without friction", {.across = 0}));
  m.push_back(of_friction("friction the other way", {.across = -1}));
  m.push_back(of_friction("B's spin with the other sign", {.spin_B = -1}));
  m.push_back(of_friction("B's spin left out", {.spin_B = 0}));
  m.push_back(of_friction("surfaces always hold", {.limited = false}));
  m.push_back(of_friction("the reduced mass instead of that of the contact", {.whole_mass = true}));
  m.push_back(of_friction("the mass of a sphere's contact for a disc", {.mass = 6.0 / 7}));
  m.push_back({"β₀ instead of 1 + β₀", {Op::rough_impulse}, [](const Given& g) -> std::optional<Mistaken> {
                 const double beta0 = g.number("beta0");
                 if (beta0 == -1) return std::nullopt;
                 return Mistaken{{{"dp", impulse(g, {.restitution = beta0 / (1 + beta0)})}}};
               }});
}

}  // namespace tps::properties::conform

#include "verify/certified/rough_response.hpp"

#include <array>

#include "verify/certified/enclosure.hpp"
#include "verify/certified/response.hpp"

namespace tps::certified {
namespace {

/// x × y: of two vectors of the plane one number.
RealVector cross(const RealVector& x, const RealVector& y) {
  const auto part = [&](std::size_t i, std::size_t j) { return x[i] * y[j] - x[j] * y[i]; };
  if (x.size() == 2) return {part(0, 1)};
  return {part(1, 2), part(2, 0), part(0, 1)};
}

/// ω × x, ω of one component in the plane.
RealVector turned(const RealVector& omega, const RealVector& x) {
  if (x.size() == 3) return cross(omega, x);
  return {Real(-1) * omega[0] * x[1], omega[0] * x[0]};
}

class RoughRebound {
 public:
  explicit RoughRebound(const operations::Input& input)
      : input_(input),
        pair_(collision(vector("u_B") - vector("u_A"), vector("v_B") - vector("v_A"), inverse_mass("m_A"),
                        inverse_mass("m_B"))),
        inverse_length_(Real(1) / sqrt(pair_.rr)) {}

  Response response() const {
    const RealVector surface = number("R_A") * vector("spin_A") + number("R_B") * vector("spin_B");
    const RealVector g = pair_.w - inverse_length_ * turned(surface, pair_.r);
    const Real gg = dot(g, g);
    const Real factor = (Real(1) + number("beta0")) * K() / (Real(1) + K()) * pair_.mu;  // holds: factor g
    // Both limits squared: no root but |r| is left.
    const Real normal = number("mu") * (Real(1) + number("c")) * pair_.mu;
    const Real most_squared = normal * normal * pair_.vr * pair_.vr / pair_.rr;
    const Sign excess = sign(factor * factor * gg - most_squared);
    const bool slides = excess == Sign::positive;
    Response response{slides ? "slides" : "sticks", excess == Sign::zero || excess == Sign::uncertain, {}};
    const RealVector across = (slides ? sqrt(most_squared / gg) : factor) * g;
    const RealVector dp = collision_impulse(pair_, input_.values.at("c")[0]) + across;
    response.values["dp"] = enclosure(dp);
    response.values["v_A"] = enclosure(vector("v_A") + inverse_mass("m_A") * dp);
    response.values["v_B"] = enclosure(vector("v_B") - inverse_mass("m_B") * dp);
    const RealVector moment = inverse_length_ / K() * cross(pair_.r, across);
    for (const auto& [spin, m, R] : {std::array{"spin_A", "m_A", "R_A"}, std::array{"spin_B", "m_B", "R_B"}})
      response.values[spin] = enclosure(vector(spin) + inverse_mass(m) / number(R) * moment);
    return response;
  }

 private:
  RealVector vector(const char* key) const { return lifted(input_.values.at(key)); }
  Real number(const char* key) const { return Real::of(input_.values.at(key)[0]); }
  Real inverse_mass(const char* key) const { return certified::inverse_mass(input_.values.at(key)[0]); }
  /// I/(m R²).
  Real K() const { return input_.dimension == 2 ? Real(Rational(1, 2)) : Real(Rational(2, 5)); }

  const operations::Input& input_;
  Collision pair_;
  Real inverse_length_;
};

}  // namespace

Response rough_response(const operations::Input& input) {
  return RoughRebound(input).response();
}

}  // namespace tps::certified

#include "verify/certified/certified_response.hpp"

#include "verify/certified/enclosure.hpp"
#include "verify/certified/response.hpp"
#include "verify/certified/rough_response.hpp"
#include "verify/operations/no_answer.hpp"

namespace tps::certified {
namespace {

/// The input of one operation, lifted.
class Lifted {
 public:
  explicit Lifted(const operations::Input& input) : input_(input) {}

  RealVector vector(const char* key) const { return lifted(input_.values.at(key)); }
  double number(const char* key) const { return input_.values.at(key)[0]; }
  Real inverse_A() const { return inverse_mass(number("m_A")); }
  Real inverse_B() const { return inverse_mass(number("m_B")); }
  Real reduced_mass() const { return Real(1) / (inverse_A() + inverse_B()); }
  const operations::Input& input() const { return input_; }
  RealVector v_AB() const { return vector("v_B") - vector("v_A"); }
  Collision pair() const {
    return collision(vector("u_B") - vector("u_A"), v_AB(), inverse_A(), inverse_B());
  }

 private:
  const operations::Input& input_;
};

void add_velocities(Response& response, const Lifted& in, const RealVector& dp) {
  response.values["v_A"] = enclosure(in.vector("v_A") + in.inverse_A() * dp);
  response.values["v_B"] = enclosure(in.vector("v_B") - in.inverse_B() * dp);
}

Response revolution(const Lifted& in) {
  const Collision pair = in.pair();
  if (sign(dot(pair.w, pair.w)) == Sign::zero) throw operations::NoAnswer(operations::kNothingAcross);
  const RealVector dp = revolution_impulse(pair, in.number("c_revolve"), in.number("theta_revolve_deg"));
  return {"", false, {{"dp", enclosure(dp)}}};
}

Response tether(const Lifted& in, const Collision& pair, bool retracts, bool boundary) {
  const RealVector dp =
      retracts ? collision_impulse(pair, in.number("c_retract"))
               : revolution_impulse(pair, in.number("c_revolve"), in.number("theta_revolve_deg"));
  Response response{retracts ? "retract" : "revolve", boundary, {{"dp", enclosure(dp)}}};
  add_velocities(response, in, dp);
  return response;
}

Response tether(const Lifted& in) {
  const Collision pair = in.pair();
  const TetherDecision decision =
      tether_decision(pair, in.number("c_retract"), in.number("theta_revolve_deg"));
  return tether(in, pair, decision.retracts, decision.boundary);
}

}  // namespace

std::optional<Response> other_response(operations::Op op, const operations::Input& input,
                                       const Response& first) {
  if (!first.boundary) return std::nullopt;
  if (op == operations::Op::rough_impulse) {  // at the boundary both limits are one impulse
    Response other = first;
    other.kind = first.kind == "sticks" ? "slides" : "sticks";
    return other;
  }
  const Lifted in(input);
  return settled([&]() -> std::optional<Response> {
    const Collision pair = in.pair();
    if (sign(dot(pair.w, pair.w)) != Sign::positive) return std::nullopt;
    return tether(in, pair, first.kind == "revolve", true);
  });
}

namespace {

/// At the working precision.
Response evaluated(operations::Op op, const Lifted& in) {
  Response response;
  switch (op) {
    case operations::Op::apply_impulse:
      add_velocities(response, in, in.vector("dp"));
      return response;
    case operations::Op::collision_impulse:
      response.values["dp"] = enclosure(collision_impulse(in.pair(), in.number("c")));
      return response;
    case operations::Op::revolution_impulse:
      return revolution(in);
    case operations::Op::tether_response:
      return tether(in);
    case operations::Op::load:
      response.values["v_load"] =
          enclosure(load_velocity(in.inverse_A(), in.inverse_B(), in.vector("v_A"), in.vector("v_B")));
      return response;
    case operations::Op::restitution_impulse:
      response.values["dp_AB"] = enclosure(in.vector("dp") - in.reduced_mass() * in.v_AB());
      return response;
    case operations::Op::rough_impulse:
      return rough_response(in.input());
    default:
      throw std::invalid_argument("the operation has no impulse or velocity to certify");
  }
}

}  // namespace

Response certified_response(operations::Op op, const operations::Input& input) {
  const Lifted in(input);
  return settled([&] { return evaluated(op, in); });
}

}  // namespace tps::certified

// The body of evaluate_in(): included by one source a scalar, by nothing else.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>

#include "reference/equations/eq1_distance.hpp"
#include "reference/equations/eq2_collision_time.hpp"
#include "reference/equations/eq2_paper_time.hpp"
#include "reference/equations/eq3_apply_impulse.hpp"
#include "reference/equations/eq6_load_velocity.hpp"
#include "reference/equations/eq7_restitution_impulse.hpp"
#include "reference/equations/tether_response.hpp"
#include "reference/text/hexfloat.hpp"
#include "reference/text/input_error.hpp"
#include "verify/eval/evaluate.hpp"

namespace tps::eval {

template <typename Scalar, int D>
class Evaluation {
 public:
  using Vec = Vector<Scalar, D>;

  Evaluation(const Input& input, std::string_view scalar) : input_(input), scalar_(scalar) {}

  Report of(Op op) {
    switch (op) {
      case Op::distance:
        distance();
        break;
      case Op::paper_time:
        paper();
        break;
      case Op::block_time:
      case Op::tether_time:
        timing(op);
        break;
      case Op::apply_impulse:
        results(apply_impulse<Scalar, D>(number("m_A"), number("m_B"), vector("v_A"), vector("v_B"),
                                         vector("dp")));
        break;
      case Op::collision_impulse:
        collision();
        break;
      case Op::revolution_impulse:
        revolve();
        break;
      case Op::tether_response:
        respond();
        break;
      case Op::load:
        load();
        break;
      case Op::restitution_impulse:
        restitution();
        break;
    }
    return report_;
  }

 private:
  // Input in this scalar: doubles lifted exactly, or rounded once more to float.
  Scalar lifted(const std::string& key, double x) const {
    const Scalar value = static_cast<Scalar>(x);
    const bool lost = std::isfinite(x) && x != 0 && (value == Scalar(0) || !finite(value));
    if (lost) refuse(fmt::format("{} is {}, which is outside the range of {}", key, x, scalar_));
    return value;
  }
  Scalar number(const std::string& key) const { return lifted(key, input_.values.at(key)[0]); }
  Vec vector(const std::string& key) const {
    Vec v;
    for (int k = 0; k < D; ++k) v[k] = lifted(key, input_.values.at(key)[static_cast<std::size_t>(k)]);
    return v;
  }

  static bool finite(const Scalar& x) {
    using std::abs;
    return abs(x) <= (std::numeric_limits<Scalar>::max)();  // false for NaN, too
  }
  [[noreturn]] void refuse(const std::string& message) const {
    throw InputError({{"numbers", 0, "", message + "; use a wider --scalar or other numbers"}});
  }

  // Output.
  static Number spelled(const Scalar& x) {
    if constexpr (std::is_floating_point_v<Scalar>) {
      return {fmt::format("{}", x), to_hex(x)};
    } else {
      return {x.str(std::numeric_limits<Scalar>::max_digits10), to_hex(x)};
    }
  }
  Quantity quantity(const char* key, const char* symbol, const char* formula, const Scalar& x) const {
    if (!finite(x))
      refuse(fmt::format("{} is not a finite {}: the numbers are beyond its range", symbol, scalar_));
    return {key, symbol, formula, {spelled(x)}, false, ""};
  }
  Quantity quantity(const char* key, const char* symbol, const char* formula, const Vec& x) const {
    Quantity q{key, symbol, formula, {}, true, ""};
    for (int k = 0; k < D; ++k) q.numbers.push_back(quantity(key, symbol, formula, Scalar(x[k])).numbers[0]);
    return q;
  }
  template <typename Value>
  void step(const char* key, const char* symbol, const char* formula, const Value& x) {
    report_.steps.push_back(quantity(key, symbol, formula, x));
  }
  template <typename Value>
  void result(const char* key, const char* symbol, const Value& x) {
    report_.results.push_back(quantity(key, symbol, "", x));
  }
  void word(const char* key, std::string_view value) {
    report_.results.push_back({key, key, "", {}, false, std::string(value)});
  }
  void time(const std::optional<Scalar>& t) {  // may lie beyond the range: ∞
    Quantity q{"t", "Δt", "", {}, false, ""};
    if (t) q.numbers.push_back(spelled(*t));
    report_.results.push_back(q);
  }
  void results(const PairVelocities<Scalar, D>& after) {
    result("v_A", "v_A'", after.v_A);
    result("v_B", "v_B'", after.v_B);
  }

  // The operations, in the order of the paper.
  void distance() {
    const Scalar dt = number("dt");
    const Vec r = (vector("u_B") + vector("v_B") * dt) - (vector("u_A") + vector("v_A") * dt);
    step("r", "r", "(u_B + v_B Δt) - (u_A + v_A Δt)", r);
    result("du", "Δu",
           distance_after<Scalar, D>(vector("u_A"), vector("u_B"), vector("v_A"), vector("v_B"), dt));
  }

  void paper() {
    const Vec u_A = vector("u_A"), u_B = vector("u_B"), v_A = vector("v_A"), v_B = vector("v_B");
    const PaperRoots<Scalar> q = paper_roots<Scalar, D>(u_A, u_B, v_A, v_B, number("L"));
    step("a", "a", "Σ(v_B - v_A)²", q.a);
    step("b", "b", "2 Σ(u_B - u_A)(v_B - v_A)", q.b);
    step("c", "c", "Σ(u_B - u_A)² - L²", q.c);
    step("discriminant", "b² - 4ac", "", q.discriminant);
    if (q.minus) step("minus", "root -", "(-b - √(b² - 4ac)) / 2a", *q.minus);
    if (q.plus) step("plus", "root +", "(-b + √(b² - 4ac)) / 2a", *q.plus);
    time(paper_time<Scalar, D>(u_A, u_B, v_A, v_B, number("L")));
  }

  void timing(Op op) {
    const Vec u_A = vector("u_A"), u_B = vector("u_B"), v_A = vector("v_A"), v_B = vector("v_B");
    const Scalar L = number("L");
    const Vec r = u_B - u_A;
    const Vec v = v_B - v_A;
    step("r", "r", "u_B - u_A", r);
    step("v", "v", "v_B - v_A", v);
    const CollisionTime<Scalar> at = op == Op::block_time ? block_time<Scalar, D>(u_A, u_B, v_A, v_B, L)
                                                          : tether_time<Scalar, D>(u_A, u_B, v_A, v_B, L);
    if (at.verdict != TimingVerdict::static_pair) {
      const ScaledQuery<Scalar, D> scaled = scaled_query<Scalar, D>(r, v, L);
      const bool as_given = scaled.L == L && scaled.r == r && scaled.v == v;
      const Approach<Scalar> q = approach<Scalar, D>(scaled.r, scaled.v, scaled.L);
      const char* note = as_given ? "" : "; r, L and v scaled by powers of two";
      step("a", "a", fmt::format("v·v{}", note).c_str(), q.a);
      step("h", "h", "r·v = b/2", q.h);
      step("c", "c", "r·r - L²", q.c);
      step("D", "D", "h² - ac", q.D);
    }
    word("verdict", tps::name(at.verdict));
    time(at.t);
  }

  CollisionFrame<Scalar, D> frame() {
    const CollisionFrame<Scalar, D> f =
        collision_frame<Scalar, D>(vector("u_A"), vector("u_B"), vector("v_A"), vector("v_B"));
    step("u_hat", "û", "(u_B - u_A) / |u_B - u_A|", f.u_hat);
    step("v_AB", "v_AB", "v_B - v_A", f.v_AB);
    step("v_n", "v_n", "Σ(v_AB û)", f.v_n);
    step("v_u", "v_û", "v_n û", f.v_u);
    step("v_w", "v_ŵ", "v_AB - v_û", f.v_w);
    reduced();
    return f;
  }
  void reduced() {
    step("mu", "μ", "1 / (1/m_A + 1/m_B)", reduced_mass<Scalar>(number("m_A"), number("m_B")));
  }

  void collision() {
    result("dp", "Δp", collision_impulse<Scalar, D>(frame(), number("m_A"), number("m_B"), number("c")));
  }

  void revolution_steps(const CollisionFrame<Scalar, D>& f) {
    const Scalar c = number("c_revolve"), theta = number("theta_revolve_deg");
    const Revolution<Scalar, D> q = revolution<Scalar, D>(f, c, theta);
    step("v_revolve", "v_revolve", "v_ŵ - tan θ |v_ŵ| û", q.v_revolve);
    step("u_hat_revolve", "û_revolve", "v_revolve / |v_revolve|", q.u_hat_revolve);
    step("speed_ratio", "c_revolve^(θ/π)", "", q.speed_ratio);
    step("v_AB_after", "v_AB'", "c_revolve^(θ/π) |v_AB| û_revolve", q.v_AB_after);
  }

  void revolve() {
    const CollisionFrame<Scalar, D> f = frame();
    if ((f.v_w.array() == Scalar(0)).all()) {
      throw InputError(
          {{"", 0, "",
            "v_ŵ, the velocity across û, is zero, so û_revolve is 0/0 and eq. (5) has no answer; "
            "tether_response retracts such a pair"}});
    }
    revolution_steps(f);
    result("dp", "Δp",
           revolution_impulse<Scalar, D>(f, number("m_A"), number("m_B"), number("c_revolve"),
                                         number("theta_revolve_deg")));
  }

  void respond() {
    using std::abs;
    const CollisionFrame<Scalar, D> f = frame();
    const Scalar m_A = number("m_A"), m_B = number("m_B"), c_retract = number("c_retract");
    const Scalar theta = number("theta_revolve_deg");
    step("closing", "|c_retract v_n|", "", Scalar(abs(c_retract * f.v_n)));
    step("needed", "tan θ |v_ŵ|", "", Scalar(tan_degrees<Scalar>(theta) * norm<Scalar, D>(f.v_w)));
    const TetherResponse<Scalar, D> answer =
        tether_response<Scalar, D>(f, m_A, m_B, c_retract, number("c_revolve"), theta);
    const bool revolves = answer.kind == TetherResponseKind::revolve;
    if (revolves) revolution_steps(f);
    word("kind", revolves ? "revolve" : "retract");
    result("dp", "Δp", answer.dp);
    results(apply_impulse<Scalar, D>(m_A, m_B, vector("v_A"), vector("v_B"), answer.dp));
  }

  void load() {
    result("v_load", "v_load",
           load_velocity<Scalar, D>(number("m_A"), number("m_B"), vector("v_A"), vector("v_B")));
  }

  void restitution() {
    step("v_AB", "v_AB", "v_B - v_A", Vec(vector("v_B") - vector("v_A")));
    reduced();
    result("dp_AB", "Δp_AB",
           restitution_impulse<Scalar, D>(number("m_A"), number("m_B"), vector("v_A"), vector("v_B"),
                                          vector("dp")));
  }

  const Input& input_;
  std::string_view scalar_;
  Report report_;
};

template <typename Scalar>
Report evaluate_in(const Operation& operation, const Input& input, std::string_view name) {
  if (input.dimension == 2) return Evaluation<Scalar, 2>(input, name).of(operation.op);
  return Evaluation<Scalar, 3>(input, name).of(operation.op);
}

}  // namespace tps::eval

// The body of evaluate_in(): included by one source a scalar, by nothing else.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "reference/equations/drag_time.hpp"
#include "reference/equations/eq1_distance.hpp"
#include "reference/equations/eq2_collision_time.hpp"
#include "reference/equations/eq2_paper_time.hpp"
#include "reference/equations/eq3_apply_impulse.hpp"
#include "reference/equations/eq6_load_velocity.hpp"
#include "reference/equations/eq7_restitution_impulse.hpp"
#include "reference/equations/rough_impulse.hpp"
#include "reference/equations/tether_response.hpp"
#include "reference/equations/wall_time.hpp"
#include "verify/operations/evaluate.hpp"
#include "verify/operations/no_answer.hpp"
#include "verify/operations/report_in.hpp"

namespace tps::operations {

template <typename Scalar, int D>
class Evaluation : private ReportIn<Scalar> {
 public:
  using Vec = Vector<Scalar, D>;

  Evaluation(const Input& input, std::string_view scalar, Detail detail)
      : ReportIn<Scalar>(scalar, detail), input_(input) {}

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
      case Op::wall_time:
        wall();
        break;
      case Op::drag_time:
        drag();
        break;
      case Op::rough_impulse:
        rough();
        break;
      case Op::order:
      case Op::group:
      case Op::next_event:
      case Op::simulate:
        throw std::invalid_argument(std::string(name(op)) + " takes more than numbers");
    }
    return this->report();
  }

 private:
  using ReportIn<Scalar>::step;
  using ReportIn<Scalar>::result;
  using ReportIn<Scalar>::word;
  using ReportIn<Scalar>::time;

  // Input in this scalar: doubles lifted exactly, or rounded once more to float.
  Scalar lifted(const std::string& key, double x) const {
    const Scalar value = static_cast<Scalar>(x);
    const bool lost = std::isfinite(x) && x != 0 && (value == Scalar(0) || !this->finite(value));
    if (lost) this->refuse(fmt::format("{} is {}, which is outside the range of {}", key, x, this->scalar()));
    return value;
  }
  Scalar number(const std::string& key) const { return lifted(key, input_.values.at(key)[0]); }
  Vec vector(const std::string& key) const {
    Vec v;
    for (int k = 0; k < D; ++k) v[k] = lifted(key, input_.values.at(key)[static_cast<std::size_t>(k)]);
    return v;
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
    if (this->shows_steps() && at.verdict != TimingVerdict::static_pair) {
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
    if (!this->shows_steps()) return;
    step("mu", "μ", "1 / (1/m_A + 1/m_B)", reduced_mass<Scalar>(number("m_A"), number("m_B")));
  }

  void collision() {
    result("dp", "Δp", collision_impulse<Scalar, D>(frame(), number("m_A"), number("m_B"), number("c")));
  }

  void revolution_steps(const CollisionFrame<Scalar, D>& f) {
    if (!this->shows_steps()) return;
    const Scalar c = number("c_revolve"), theta = number("theta_revolve_deg");
    const Revolution<Scalar, D> q = revolution<Scalar, D>(f, c, theta);
    step("v_revolve", "v_revolve", "v_ŵ - tan θ |v_ŵ| û", q.v_revolve);
    step("u_hat_revolve", "û_revolve", "v_revolve / |v_revolve|", q.u_hat_revolve);
    step("speed_ratio", "c_revolve^(θ/π)", "", q.speed_ratio);
    step("v_AB_after", "v_AB'", "c_revolve^(θ/π) |v_AB| û_revolve", q.v_AB_after);
  }

  void revolve() {
    const CollisionFrame<Scalar, D> f = frame();
    if ((f.v_w.array() == Scalar(0)).all()) throw NoAnswer(kNothingAcross);
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
    if (this->shows_steps()) {
      step("closing", "|c_retract v_n|", "", Scalar(abs(c_retract * f.v_n)));
      step("needed", "tan θ |v_ŵ|", "", Scalar(tan_degrees<Scalar>(theta) * norm<Scalar, D>(f.v_w)));
    }
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

  void wall() {
    const Vec u_A = vector("u_A"), u_B = vector("u_B"), v_A = vector("v_A"), v_B = vector("v_B");
    const Vec normal = vector("normal");
    const WallApproach<Scalar> q = wall_approach<Scalar, D>(u_A, u_B, v_A, v_B, number("L"), normal);
    step("gap", "gap", "n·(u_B - u_A) - L", q.gap);
    step("v_n", "v_n", "n·(v_B - v_A)", q.v_n);
    const CollisionTime<Scalar> at = wall_time<Scalar, D>(u_A, u_B, v_A, v_B, number("L"), normal);
    word("verdict", tps::name(at.verdict));
    time(at.t);
  }

  void drag() {
    step("z", "γs", "1 - e^(-γt)", Scalar(number("gamma") * number("s")));
    const std::optional<Scalar> t = drag_time<Scalar>(number("gamma"), number("s"));
    word("verdict", t ? "reached" : "never");
    time(t, "t");
  }

  Spin<Scalar, D> spin(const std::string& key) const {
    Spin<Scalar, D> omega;
    for (int k = 0; k < omega.size(); ++k)
      omega[k] = lifted(key, input_.values.at(key)[static_cast<std::size_t>(k)]);
    return omega;
  }

  void rough() {
    const Scalar m_A = number("m_A"), m_B = number("m_B"), R_A = number("R_A"), R_B = number("R_B");
    const CollisionFrame<Scalar, D> f = frame();
    const Vec normal = collision_impulse<Scalar, D>(f, m_A, m_B, number("c"));
    const Spin<Scalar, D> surface = R_A * spin("spin_A") + R_B * spin("spin_B");
    step("normal", "J_n", "(1 + c) μ v_û", normal);
    step("surface", "S", "R_A ω_A + R_B ω_B", surface);
    step("g_t", "g_t", "v_ŵ - S × û", Vec(f.v_w - turned<Scalar, D>(surface, f.u_hat)));
    const RoughImpulse<Scalar, D> across = rough_impulse<Scalar, D>(f, m_A, m_B, norm<Scalar, D>(normal),
                                                                    surface, number("mu"), number("beta0"));
    step("across", "J_t", "min(μ |J_n|, κ (1 + β0) m |g_t|) along g_t", across.dp);
    word("kind", across.sticks ? "sticks" : "slides");
    const Vec dp = normal + across.dp;
    result("dp", "Δp", dp);
    results(apply_impulse<Scalar, D>(m_A, m_B, vector("v_A"), vector("v_B"), dp));
    const auto after = [&](const char* key, const Scalar& m, const Scalar& R) {
      return Spin<Scalar, D>(spin(key) + spin_change<Scalar, D>(f.u_hat, across.dp, m, R));
    };
    result("spin_A", "ω_A'", after("spin_A", m_A, R_A));
    result("spin_B", "ω_B'", after("spin_B", m_B, R_B));
  }

  const Input& input_;
};

template <typename Scalar>
Report evaluate_in(const Operation& operation, const Input& input, std::string_view name, Detail detail) {
  if (input.dimension == 2) return Evaluation<Scalar, 2>(input, name, detail).of(operation.op);
  return Evaluation<Scalar, 3>(input, name, detail).of(operation.op);
}

}  // namespace tps::operations

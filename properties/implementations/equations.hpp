// The equations in one scalar as an implementation. Heavy header: one source a scalar includes it.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include "properties/implementation.hpp"
#include "reference/equations/drag_time.hpp"
#include "reference/equations/eq1_distance.hpp"
#include "reference/equations/eq2_collision_time.hpp"
#include "reference/equations/eq3_apply_impulse.hpp"
#include "reference/equations/eq6_load_velocity.hpp"
#include "reference/equations/eq7_restitution_impulse.hpp"
#include "reference/equations/rough_impulse.hpp"
#include "reference/equations/tether_response.hpp"
#include "reference/equations/wall_time.hpp"
#include "reference/text/hexfloat.hpp"
#include "reference/text/number_text.hpp"
#include "verify/eval/operations.hpp"

namespace tps::properties {

/// Of an operation that has neither.
inline const Json kNoVector = Json::array({0, 0, 0});

/// One question in D dimensions, or a planar one in space with z = 0.
template <typename Scalar, int D>
class Equations {
 public:
  using Vec = Vector<Scalar, D>;

  Equations(const Json& in, int dimension) : in_(in), dimension_(dimension) {}

  Answer answer(const std::string& op) {
    const eval::Operation* operation = eval::find_operation(op);
    if (operation == nullptr ? op != "group" : operation->op == eval::Op::paper_time)
      return {Answer::Status::skipped, {}, "not among the equations"};
    operation == nullptr ? group() : ask(operation->op);
    if (!refusal_.empty()) return {Answer::Status::refused, {}, refusal_};
    return {Answer::Status::answered, std::move(out_)};
  }

 private:
  void ask(eval::Op op) {
    using eval::Op;
    switch (op) {
      case Op::distance:
        out_["du"] =
            hex(distance_after<Scalar, D>(vec("u_A"), vec("u_B"), vec("v_A"), vec("v_B"), number("dt")));
        break;
      case Op::paper_time:
        break;
      case Op::block_time:
        time(block_time<Scalar, D>(vec("u_A"), vec("u_B"), vec("v_A"), vec("v_B"), number("L")));
        break;
      case Op::tether_time:
        time(tether_time<Scalar, D>(vec("u_A"), vec("u_B"), vec("v_A"), vec("v_B"), number("L")));
        break;
      case Op::apply_impulse:
        velocities(vec("dp"));
        break;
      case Op::collision_impulse:
        out_["dp"] = hex(collision_impulse<Scalar, D>(frame(), number("m_A"), number("m_B"), number("c")));
        break;
      case Op::revolution_impulse:
        revolve();
        break;
      case Op::tether_response:
        respond();
        break;
      case Op::load:
        out_["v_load"] = hex(load_velocity<Scalar, D>(number("m_A"), number("m_B"), vec("v_A"), vec("v_B")));
        break;
      case Op::restitution_impulse:
        out_["dp_AB"] = hex(
            restitution_impulse<Scalar, D>(number("m_A"), number("m_B"), vec("v_A"), vec("v_B"), vec("dp")));
        break;
      case Op::wall_time:
        time(
            wall_time<Scalar, D>(vec("u_A"), vec("u_B"), vec("v_A"), vec("v_B"), number("L"), vec("normal")));
        break;
      case Op::drag_time: {
        const std::optional<Scalar> t = drag_time<Scalar>(number("gamma"), number("s"));
        out_["verdict"] = t ? "reached" : "never";
        if (t) out_["t"] = hex(*t);
        break;
      }
      case Op::rough_impulse:
        rough();
        break;
    }
  }

  static Scalar scalar(const Json& value) {
    const std::string& text = value.get_ref<const std::string&>();
    return static_cast<Scalar>(text == "inf" ? HUGE_VAL : parse_hex_float(text).value);
  }
  Vec vec(const Json& value) const {
    Vec x = Vec::Zero();
    for (int k = 0; k < dimension_; ++k) x[k] = scalar(value.at(static_cast<std::size_t>(k)));
    return x;
  }
  Scalar number(const char* key) const { return scalar(in_.at(key)); }
  Vec vec(const char* key) const { return vec(in_.at(key)); }

  Json hex(const Scalar& x) {
    using std::abs;
    if (abs(x) <= (std::numeric_limits<Scalar>::max)()) return to_hex(x);
    refusal_ = "beyond the range of the scalar";
    return nullptr;
  }
  Json hex(const Vec& x) {
    Json list = Json::array();
    for (int k = 0; k < dimension_; ++k) list.push_back(hex(Scalar(x[k])));
    return list;
  }
  void time(const CollisionTime<Scalar>& at) {
    out_["verdict"] = std::string(name(at.verdict));
    if (at.t) out_["t"] = hex(*at.t);
  }

  CollisionFrame<Scalar, D> frame() const {
    return collision_frame<Scalar, D>(vec("u_A"), vec("u_B"), vec("v_A"), vec("v_B"));
  }
  void velocities(const Vec& dp) {
    const PairVelocities<Scalar, D> after =
        apply_impulse<Scalar, D>(number("m_A"), number("m_B"), vec("v_A"), vec("v_B"), dp);
    out_["v_A"] = hex(after.v_A);
    out_["v_B"] = hex(after.v_B);
  }
  void revolve() {
    const CollisionFrame<Scalar, D> f = frame();
    if (norm<Scalar, D>(f.v_w) == Scalar(0)) {
      refusal_ = "v_ŵ is zero, so û_revolve is 0/0";
      return;
    }
    out_["dp"] = hex(revolution_impulse<Scalar, D>(f, number("m_A"), number("m_B"), number("c_revolve"),
                                                   number("theta_revolve_deg")));
  }
  void respond() {
    const TetherResponse<Scalar, D> answer =
        tether_response<Scalar, D>(frame(), number("m_A"), number("m_B"), number("c_retract"),
                                   number("c_revolve"), number("theta_revolve_deg"));
    out_["kind"] = answer.kind == TetherResponseKind::revolve ? "revolve" : "retract";
    out_["dp"] = hex(answer.dp);
    velocities(answer.dp);
  }

  Spin<Scalar, D> spin(const char* key) const {
    const Json& value = in_.at(key);
    Spin<Scalar, D> omega = Spin<Scalar, D>::Zero();
    if (!value.is_array()) {  // in the plane, about z
      omega[omega.size() - 1] = scalar(value);
      return omega;
    }
    for (int k = 0; k < omega.size(); ++k) omega[k] = scalar(value.at(static_cast<std::size_t>(k)));
    return omega;
  }
  void rough() {
    const CollisionFrame<Scalar, D> f = frame();
    const Vec normal = collision_impulse<Scalar, D>(f, number("m_A"), number("m_B"), number("c"));
    // A planar question in space asks about discs at z = 0.
    const Scalar K = dimension_ == 2 ? inertia_ratio<Scalar, 2>() : inertia_ratio<Scalar, 3>();
    const Spin<Scalar, D> surface = number("R_A") * spin("spin_A") + number("R_B") * spin("spin_B");
    const RoughImpulse<Scalar, D> across = rough_impulse<Scalar, D>(
        f, number("m_A"), number("m_B"), norm<Scalar, D>(normal), surface, number("mu"), number("beta0"), K);
    out_["kind"] = across.sticks ? "sticks" : "slides";
    const Vec dp = normal + across.dp;
    out_["dp"] = hex(dp);
    velocities(dp);
    for (const auto& [key, m, R] : {std::array{"spin_A", "m_A", "R_A"}, std::array{"spin_B", "m_B", "R_B"}}) {
      const Spin<Scalar, D> after =
          spin(key) + spin_change<Scalar, D>(f.u_hat, across.dp, number(m), number(R), K);
      Json list = Json::array();
      for (int k = 0; k < after.size(); ++k) list.push_back(hex(Scalar(after[k])));
      out_[key] = dimension_ == 2 ? list.back() : list;
    }
  }

  Vec impulse_of(const Json& c, const CollisionFrame<Scalar, D>& f, const Scalar& m_i, const Scalar& m_j) {
    if (c.value("limit", "inner") != "outer")
      return collision_impulse<Scalar, D>(f, m_i, m_j, scalar(c.at("c")));
    return tether_response<Scalar, D>(f, m_i, m_j, scalar(c.at("c_retract")), scalar(c.at("c_revolve")),
                                      scalar(c.at("theta_revolve_deg")))
        .dp;
  }

  void group() {
    struct Node {
      std::vector<std::size_t> i, j;
      Scalar m_i, m_j;
      Vec dp;
    };
    std::vector<Scalar> m;
    std::vector<Vec> u, v;
    std::vector<std::vector<std::size_t>> members;
    for (const Json& body : in_.at("bodies")) {
      m.push_back(scalar(body.at("m")));
      u.push_back(vec(body.at("u")));
      v.push_back(vec(body.at("v")));
      members.push_back(m.back() == std::numeric_limits<Scalar>::infinity()
                            ? std::vector<std::size_t>{}
                            : std::vector<std::size_t>{members.size()});
    }
    std::vector<Node> nodes;
    for (const Json& c : in_.at("collisions")) {
      const auto i = c.at("i").get<std::size_t>(), j = c.at("j").get<std::size_t>();
      const CollisionFrame<Scalar, D> f = collision_frame<Scalar, D>(u[i], u[j], v[i], v[j]);
      const Vec dp = impulse_of(c, f, m[i], m[j]);
      nodes.push_back(
          {members[i], members[j], m[i], m[j], restitution_impulse<Scalar, D>(m[i], m[j], v[i], v[j], dp)});
      const Vec joint = load_velocity<Scalar, D>(m[i], m[j], v[i], v[j]);
      const Scalar mass = m[i] + m[j];
      std::vector<std::size_t> all = members[i];
      all.insert(all.end(), members[j].begin(), members[j].end());
      for (const std::size_t n : all) {
        v[n] = joint;
        m[n] = mass;
        members[n] = all;
      }
    }
    const auto list = [&] {
      Json velocities = Json::array();
      for (const Vec& each : v) velocities.push_back(hex(each));
      return velocities;
    };
    out_["loaded"] = list();
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
      for (const std::size_t n : node->i)
        v[n] = apply_impulse<Scalar, D>(node->m_i, node->m_j, v[n], v[n], node->dp).v_A;
      for (const std::size_t n : node->j)
        v[n] = apply_impulse<Scalar, D>(node->m_i, node->m_j, v[n], v[n], node->dp).v_B;
    }
    out_["restituted"] = list();
  }

  const Json& in_;
  int dimension_;
  Json out_ = Json::object();
  std::string refusal_;
};

template <typename Scalar>
class EquationsIn final : public Implementation {
 public:
  explicit EquationsIn(std::string name) : name_(std::move(name)) {}

  std::string name() const override { return "the equations in " + name_; }
  Format format() const override { return Format::of_bits(std::numeric_limits<Scalar>::digits); }
  Answer ask(const Question& question) override {
    const Json& in = question.in;
    const Json& vector = in.contains("bodies") ? in.at("bodies").at(0).at("v")
                         : in.contains("v_A")  ? in.at("v_A")
                                               : kNoVector;
    const auto dimension = static_cast<int>(vector.size());
    // Each combination takes seconds to compile: wide scalars have space alone.
    if constexpr (std::is_floating_point_v<Scalar>) {
      if (dimension == 2) return Equations<Scalar, 2>(in, dimension).answer(question.op);
    }
    return Equations<Scalar, 3>(in, dimension).answer(question.op);
  }

 private:
  std::string name_;
};

}  // namespace tps::properties

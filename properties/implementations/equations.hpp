// The equations in one scalar as an implementation. Heavy header: two sources include it.
#pragma once

#include <limits>
#include <type_traits>
#include <vector>

#include "properties/implementation.hpp"
#include "properties/implementations/ask_equation.hpp"
#include "reference/equations/eq3_apply_impulse.hpp"
#include "reference/equations/eq6_load_velocity.hpp"
#include "reference/equations/eq7_restitution_impulse.hpp"
#include "reference/equations/tether_response.hpp"
#include "reference/text/hexfloat.hpp"

namespace tps::properties {

/// A group in D dimensions, or a planar one in space with z = 0: loads by eq. (6), what they store by (7),
/// and its undoing.
template <typename Scalar, int D>
class GroupByEquations {
 public:
  using Vec = Vector<Scalar, D>;

  GroupByEquations(const Json& in, int dimension) : in_(in), dimension_(dimension) {}

  Answer answer() {
    group();
    if (!refusal_.empty()) return {Answer::Status::refused, {}, refusal_};
    return {Answer::Status::answered, std::move(out_)};
  }

 private:
  static Scalar scalar(const Json& value) { return static_cast<Scalar>(number_of(value)); }
  Vec vec(const Json& value) const {
    Vec x = Vec::Zero();
    for (int k = 0; k < dimension_; ++k) x[k] = scalar(value.at(static_cast<std::size_t>(k)));
    return x;
  }
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
    if (question.op != "group") return ask_equation(question, name_);
    const auto dimension = static_cast<int>(question.in.at("bodies").at(0).at("v").size());
    // Each combination takes seconds to compile: wide scalars have space alone.
    if constexpr (std::is_floating_point_v<Scalar>) {
      if (dimension == 2) return GroupByEquations<Scalar, 2>(question.in, dimension).answer();
    }
    return GroupByEquations<Scalar, 3>(question.in, dimension).answer();
  }

 private:
  std::string name_;
};

}  // namespace tps::properties

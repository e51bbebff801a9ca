#include "verify/vectors/response_condition.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace tps::vectors {
namespace {

double size(const std::vector<double>& x) {
  double largest = 0;
  for (const double component : x) largest = std::max(largest, std::fabs(component));
  if (largest == 0 || std::isinf(largest)) return largest;
  double sum = 0;
  for (const double component : x) sum += component / largest * (component / largest);
  return largest * std::sqrt(sum);
}

double size(const certified::EnclosedVector& x) {
  std::vector<double> nearest;
  for (const certified::Enclosure& e : x) nearest.push_back(e.nearest);
  return size(nearest);
}

std::vector<double> difference(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> z;
  for (std::size_t k = 0; k < x.size(); ++k) z.push_back(x[k] - y[k]);
  return z;
}

Json three_digits(double terms, double result) {
  return rounded_condition(std::max(1.0, terms / result));
}

/// Sizes of what the response is made of.
class Sizes {
 public:
  Sizes(Op op, const operations::Input& input, const certified::Response& response)
      : op_(op), input_(input), response_(response) {}

  double vector(const std::string& key) const { return size(input_.values.at(key)); }
  double number(const std::string& key) const { return input_.values.at(key)[0]; }
  double speed() const { return size(difference(input_.values.at("v_B"), input_.values.at("v_A"))); }
  double mu() const { return 1 / (1 / number("m_A") + 1 / number("m_B")); }

  /// Of the terms that Δp is computed from.
  double impulse_terms() const {
    if (input_.values.contains("dp")) return vector("dp");
    const double impulse = size(response_.values.at("dp"));
    const bool revolves = op_ == Op::revolution_impulse || response_.kind == "revolve";
    if (!revolves) return impulse * normal_cancellation();
    const double c = number("c_revolve");
    const double turn = number("theta_revolve_deg") / 180;
    return 2 * mu() * speed() * across_cancellation() * (1 + (c > 0 ? -std::log(c) * turn : 0));
  }

 private:
  struct Products {
    double sum = 0, absolute = 0, r_squared = 0;
  };
  Products products() const {
    const std::vector<double> r = difference(input_.values.at("u_B"), input_.values.at("u_A"));
    const std::vector<double> v = difference(input_.values.at("v_B"), input_.values.at("v_A"));
    const double length = size(r);
    Products p;
    for (std::size_t k = 0; k < r.size(); ++k) {
      p.sum += r[k] / length * v[k];
      p.absolute += std::fabs(r[k] / length * v[k]);
    }
    return p;
  }
  double normal_cancellation() const {
    const Products p = products();
    return p.absolute / std::fabs(p.sum);
  }
  /// |v| / |v_ŵ|.
  double across_cancellation() const {
    const std::vector<double> r = difference(input_.values.at("u_B"), input_.values.at("u_A"));
    const std::vector<double> v = difference(input_.values.at("v_B"), input_.values.at("v_A"));
    const double length = size(r);
    const double along = products().sum;
    std::vector<double> across;
    for (std::size_t k = 0; k < r.size(); ++k) across.push_back(v[k] - along * (r[k] / length));
    return size(v) / size(across);
  }

  Op op_;
  const operations::Input& input_;
  const certified::Response& response_;
};

/// Of rough_impulse: of Δp, and of what turns the particles.
struct RoughTerms {
  double whole, across;
};

/// With G = |v_AB| + R_A|ω_A| + R_B|ω_B|: eq. (4) has the terms (1 + c) m |v_AB|; of the smaller limit of
/// friction, holding surfaces take κ (1 + β₀) m G and sliding ones μ of eq. (4)'s and G/|g_t| of J_t for its
/// direction. Each twice: docs/effects.md counts up to 18 and 36 roundings of a term.
RoughTerms rough_terms(const Sizes& sizes, const operations::Input& input,
                       const certified::Response& response) {
  const double G = sizes.speed() + sizes.number("R_A") * sizes.vector("spin_A") +
                   sizes.number("R_B") * sizes.vector("spin_B");
  const double normal = (1 + sizes.number("c")) * sizes.mu() * sizes.speed();
  const double kappa = input.dimension == 2 ? 1.0 / 3 : 2.0 / 7;
  const double factor = kappa * (1 + sizes.number("beta0")) * sizes.mu();
  double across = 2 * factor * G;
  if (response.kind == "slides") {
    // J_t = μ |J_n| < factor |g_t|: its direction costs J_t G/|g_t| < factor G.
    across += 2 * sizes.number("mu") * normal;
  }
  return {2 * normal + across, across};
}

Json rough_conditions(const Sizes& sizes, const operations::Input& input,
                      const certified::Response& response) {
  const RoughTerms terms = rough_terms(sizes, input, response);
  const double K = input.dimension == 2 ? 0.5 : 0.4;
  Json result;
  for (const auto& [key, components] : response.values) {
    const std::string side = key.substr(key.size() - 1);
    double size_of_terms = terms.whole;
    if (key != "dp") {
      const bool is_spin = key.starts_with("spin");
      const double pushed = is_spin ? terms.across / (K * sizes.number("R_" + side)) : terms.whole;
      size_of_terms = sizes.vector(key) + pushed / sizes.number("m_" + side);
    }
    result[key] = three_digits(size_of_terms, size(components));
  }
  return result;
}

}  // namespace

Json conditions(Op op, const operations::Input& input, const certified::Response& response) {
  const Sizes sizes(op, input, response);
  if (op == Op::rough_impulse) return rough_conditions(sizes, input, response);
  Json result;
  for (const auto& [key, components] : response.values) {
    double terms = 0;
    if (key == "dp") {
      terms = sizes.impulse_terms();
    } else if (key == "v_A" || key == "v_B") {
      terms = sizes.vector(key) + sizes.impulse_terms() / sizes.number(key == "v_A" ? "m_A" : "m_B");
    } else if (key == "v_load") {
      terms = sizes.mu() *
              (sizes.vector("v_A") / sizes.number("m_B") + sizes.vector("v_B") / sizes.number("m_A"));
    } else {
      terms = sizes.vector("dp") + sizes.mu() * sizes.speed();
    }
    result[key] = three_digits(terms, size(components));
  }
  return result;
}

Json conditions(const operations::GroupInput& group, const certified::GroupResponse& response) {
  double fastest = 0;
  for (const operations::GroupInput::Body& body : group.bodies)
    fastest = std::max(fastest, size(body.velocity));
  const double terms = 4 * fastest * static_cast<double>(group.collisions.size() + 1);
  const auto smallest = [](const std::vector<certified::EnclosedVector>& velocities) {
    double least = HUGE_VAL;
    for (const certified::EnclosedVector& v : velocities)
      least = std::min(least, size(v) > 0 ? size(v) : least);
    return least;
  };
  return {{"loaded", three_digits(terms, smallest(response.loaded))},
          {"restituted", three_digits(terms, smallest(response.restituted))}};
}

}  // namespace tps::vectors

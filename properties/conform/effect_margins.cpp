#include "properties/conform/effect_margins.hpp"

#include <algorithm>
#include <cmath>

#include "properties/laws/drag_clock.hpp"
#include "properties/laws/plane_approach.hpp"

namespace tps::properties::conform {
namespace {

bool may_be(const Wide& x, const Wide& error, int sign) {
  return sign > 0 ? x + error > 0 : sign < 0 ? x - error < 0 : abs(x) <= error;
}

bool is_time_of_plane(const PlaneApproach& q, const std::optional<double>& t, const Wide& u) {
  if (!t) return may_be(q.towards, q.towards_error, -1) || may_be(q.towards, q.towards_error, 0);
  if (!(*t >= 0) || !may_be(q.towards, q.towards_error, 1)) return false;
  if (*t == 0) return may_be(q.gap, q.gap_error, -1) || may_be(q.gap, q.gap_error, 0);
  const Wide slowest = q.towards - q.towards_error;
  const Wide lo = (q.gap - q.gap_error) / (q.towards + q.towards_error);
  return Wide(*t) >= lo * (1 - 2 * u) &&
         (slowest <= 0 || Wide(*t) * slowest * (1 - 2 * u) <= q.gap + q.gap_error);
}

bool is_verdict_of_plane(const PlaneApproach& q, const std::string& verdict) {
  const bool approaches = may_be(q.towards, q.towards_error, 1);
  if (verdict == "receding")
    return may_be(q.towards, q.towards_error, -1) || may_be(q.towards, q.towards_error, 0);
  if (verdict == "hit") return approaches && may_be(q.gap, q.gap_error, 1);
  if (verdict == "contact") return approaches && may_be(q.gap, q.gap_error, 0);
  return verdict == "overlap" && approaches && may_be(q.gap, q.gap_error, -1);
}

/// Whether z off by `error` on either side explains the answer.
bool explains_drag(const Wide& gamma, const Wide& z, const Wide& error, const TimeAnswer& answer,
                   const Wide& u) {
  const Wide least = std::max(Wide(0), Wide(z - error)), most = z + error;
  const bool reached = answer.verdict ? *answer.verdict == "reached" : answer.t.has_value();
  if (answer.verdict && !reached && *answer.verdict != "never") return false;
  if (!reached) return !answer.t && most >= 1;
  if (!answer.t || least >= 1) return false;
  const Wide t(*answer.t);
  return t >= time_of_clock(gamma, least) * (1 - 4 * u) &&
         (most >= 1 || t <= time_of_clock(gamma, most) * (1 + 4 * u));
}

Vec crossed(const Vec& omega, const Vec& x) {
  if (x.size() == 2) return {-omega[0] * x[1], omega[0] * x[0]};
  return {omega[1] * x[2] - omega[2] * x[1], omega[2] * x[0] - omega[0] * x[2],
          omega[0] * x[1] - omega[1] * x[0]};
}

/// Both limits of friction and their errors in units u.
struct Friction {
  double slip, normal, holding, most;
  double of_slip, of_normal, of_holding, of_most;

  explicit Friction(const Given& g) {
    const Vec S = g.number("R_A") * g.vec("spin_A") + g.number("R_B") * g.vec("spin_B");
    const double speed = norm(g.v()), v_n = std::fabs(g.v_n()), kappa = K(g) / (1 + K(g));
    const double G =
        speed + g.number("R_A") * norm(g.vec("spin_A")) + g.number("R_B") * norm(g.vec("spin_B"));
    const double factor = kappa * (1 + g.number("beta0")) * g.mu(), push = (1 + g.number("c")) * g.mu();
    slip = norm(g.w() - crossed(S, g.n()));
    normal = push * v_n;
    holding = factor * slip;
    most = g.number("mu") * normal;
    of_slip = 18 * G;
    of_normal = push * (9 * speed + 10 * v_n);
    of_holding = factor * (of_slip + 8 * slip);
    of_most = g.number("mu") * of_normal;
  }
  static double K(const Given& g) { return g.vec("u_A").size() == 2 ? 0.5 : 0.4; }
};

}  // namespace

Margin margin_of_plane(const exact::TimingQuery& query, const TimeAnswer& answer, int bits) {
  const Wide u = ldexp(Wide(1), -std::min(bits, 53));
  if (exact::is_static(query)) {
    const bool is_right = !answer.t && answer.verdict.value_or("static") == "static";
    return is_right ? Margin::stable : Margin::none;
  }
  const PlaneApproach q({query.u_A, query.u_B, query.v_A, query.v_B}, query.L, query.normal, u);
  const bool explained =
      is_time_of_plane(q, answer.t, u) && (!answer.verdict || is_verdict_of_plane(q, *answer.verdict));
  return explained ? Margin::stable : Margin::none;
}

Margin margin_of_drag(const Json& in, const TimeAnswer& answer, int bits) {
  const Given given(in);
  const Wide u = ldexp(Wide(1), -std::min(bits, 53)), gamma(given.number("gamma"));
  const Wide z = gamma * Wide(given.number("s"));
  if (explains_drag(gamma, z, 2 * u * z, answer, u)) return Margin::stable;
  return explains_drag(gamma, z, 2 * u * z + u, answer, u) ? Margin::printed : Margin::none;
}

bool friction_is_open(const Question& question, int bits) {
  const Friction f{Given(question.in)};
  const double u = std::ldexp(1.0, -std::min(bits, 53));
  return std::fabs(f.holding - f.most) <= 1.02 * u * (f.of_holding + f.of_most);
}

std::map<std::string, double> rough_bounds(const Given& g, const std::string& kind) {
  const Friction f(g);
  const bool slides = kind == "slides";
  const double across = slides ? f.most : f.holding;
  // A direction errs by twice its vector's error over its length, at most by 2 (2^53 units).
  const double direction = f.slip > 0 ? std::min(0x1p54, 2 * f.of_slip / f.slip) : 0;
  const double of_across = slides ? f.of_most + f.most * direction : f.of_holding;
  std::map<std::string, double> bounds{{"dp", f.of_normal + of_across + 2 * (f.normal + across)}};
  for (const char* side : {"A", "B"}) {
    const std::string end(side);
    const double m = g.number(("m_" + end).c_str());
    const double turning = Friction::K(g) * m * g.number(("R_" + end).c_str());
    bounds["v_" + end] =
        3 * (norm(g.vec(("v_" + end).c_str())) + 2 * (f.normal + across) / m) + bounds["dp"] / m;
    bounds["spin_" + end] = (20 * across + of_across) / turning + 3 * norm(g.vec(("spin_" + end).c_str()));
  }
  return bounds;
}

}  // namespace tps::properties::conform

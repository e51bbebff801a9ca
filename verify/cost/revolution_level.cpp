// θ_revolve from 1e-6 degrees to 90 − 1e-6: eq. (5) on a pair that circles on its tether.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "verify/cost/model_level.hpp"
#include "verify/scenes/pair.hpp"

namespace tps::cost {
namespace {

constexpr double kMostBehind = 2000;

/// Without blocking, which chords of more than 60° would meet.
Scene circling(double theta_deg, double c_revolve) {
  PairParams params;
  params.theta = theta_deg;
  params.c_revolve = c_revolve;
  params.duration = 1e300;
  Scene scene = build_pair(params);
  scene.pairs.front().blocking.reset();
  return scene;
}

/// The pair seen from A: u_B − u_A and v_B − v_A.
struct Relative {
  double x, y, v, w;

  double energy() const { return v * v + w * w; }            ///< times μ/2
  double angular_momentum() const { return x * w - y * v; }  ///< times μ
  double angle() const { return std::atan2(y, x); }
};

Relative after(const Scene& scene, std::uint64_t events) {
  RunOptions options;
  options.max_events = events;
  const RunSummary run = run_scene(scene, options);
  const auto difference = [](const std::vector<std::string>& of_B, const std::vector<std::string>& of_A,
                             std::size_t k) { return std::stod(of_B.at(k)) - std::stod(of_A.at(k)); };
  const RunSummary::Final& A = run.final_states.at(0);
  const RunSummary::Final& B = run.final_states.at(1);
  return {difference(B.position, A.position, 0), difference(B.position, A.position, 1),
          difference(B.velocity, A.velocity, 0), difference(B.velocity, A.velocity, 1)};
}

RevolutionRow row_of(double theta_deg, double c_revolve) {
  const Scene scene = circling(theta_deg, c_revolve);
  const auto behind = static_cast<std::uint64_t>(std::clamp(std::round(180 / theta_deg), 2.0, kMostBehind));
  const double at_start = 1;  // |r| = |v| = 1, perpendicular
  const Relative first = after(scene, 1);
  const Relative second = after(scene, 2);
  const Relative last = after(scene, 1 + behind);
  RevolutionRow row{theta_deg, c_revolve, behind};
  const double bend = std::fabs(std::remainder(second.angle() - first.angle(), 2 * std::numbers::pi));
  row.events_a_turn = 2 * std::numbers::pi / bend;
  const double turns = static_cast<double>(behind) / row.events_a_turn;
  const auto lost_a_turn = [&](double before, double now) {
    return -std::expm1(std::log(now / before) / turns);
  };
  row.energy_a_turn = lost_a_turn(first.energy(), last.energy());
  row.momentum_a_turn = lost_a_turn(first.angular_momentum(), last.angular_momentum());
  row.momentum_at_first = 1 - std::fabs(first.angular_momentum()) / at_start;
  return row;
}

}  // namespace

void measure_revolution(ModelLevel& level, const ModelLevelOptions& options) {
  options.announce("revolution");
  for (const double c_revolve : {1.0, 0.5}) {
    for (const double theta : {1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.1, 1.0, 3.0, 10.0, 22.5, 30.0, 45.0, 60.0,
                               75.0, 85.0, 89.0, 89.99, 90 - 1e-4, 90 - 1e-6}) {
      level.revolution.push_back(row_of(theta, c_revolve));
    }
  }
}

}  // namespace tps::cost

// A program as the paper's loop has it: at each event everybody is advanced, and the clock is one double. It
// shares the equations with the engine, not its clocks, positions or queues.
#pragma once

#include <fmt/format.h>

#include <limits>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "reference/equations/eq2_collision_time.hpp"
#include "reference/equations/eq3_apply_impulse.hpp"
#include "reference/equations/tether_response.hpp"
#include "reference/scene/scene.hpp"
#include "reference/scene/write_scene.hpp"
#include "reference/text/hexfloat.hpp"

namespace tps::mutation {

class PaperLoop {
 public:
  using Vec3 = Vector<double, 3>;

  /// `product`: c_revolve θ/π in eq. (5) taken as a product.
  explicit PaperLoop(const Scene& scene, bool product = false)
      : scene_(scene), product_(product), t_(scene.start_time) {
    for (const Particle& p : scene.particles) {
      u_.emplace_back(p.position[0], p.position[1], p.position[2]);
      v_.emplace_back(p.velocity[0], p.velocity[1], p.velocity[2]);
    }
    for (const Tether& tether : scene.tethers) tethered_[{tether.i, tether.j}] = true;
  }

  /// The minimal trace of so many events.
  std::string trace(int events, const std::string& header_keys = "") {
    std::string text = fmt::format(R"({{"trace":1,"form":"minimal","scalar":"double"{},"scene":{}}})",
                                   header_keys, write_scene(scene_, SceneStyle::compact));
    text += '\n';
    int done = 0;
    for (; done < events && step(text); ++done) {
    }
    return text + fmt::format(R"({{"end":"max_events","events":{},"t":"{}"}})", done, to_hex<double>(t_)) +
           "\n";
  }

 private:
  struct Next {
    double dt = std::numeric_limits<double>::infinity();
    int i = -1, j = -1;
    bool outer = false;
  };

  std::optional<double> due(int i, int j, bool outer) const {
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
    const PairLaw& law = scene_.pairs.front();
    const bool responded = responded_.contains({i, j, outer});
    if (!outer) {
      if (responded) return std::nullopt;
      return block_time<double, 3>(u_[a], u_[b], v_[a], v_[b], law.blocking->distance).t;
    }
    const auto answer = tether_time<double, 3>(u_[a], u_[b], v_[a], v_[b], law.tethering->distance);
    if (!responded || answer.verdict == TimingVerdict::hit) return answer.t;
    return answer.verdict == TimingVerdict::turning ? std::optional(2 * *answer.t) : std::nullopt;
  }

  Next first() const {
    Next next;
    const int n = static_cast<int>(u_.size());
    for (int i = 0; i < n; ++i) {
      for (int j = i + 1; j < n; ++j) {
        for (const bool outer : {false, true}) {
          if (outer && !tethered_.contains({i, j})) continue;
          const std::optional<double> t = due(i, j, outer);
          if (t && *t < next.dt) next = {*t, i, j, outer};
        }
      }
    }
    return next;
  }

  bool step(std::string& text) {
    const Next next = first();
    if (next.i < 0) return false;
    for (std::size_t n = 0; n < u_.size(); ++n) u_[n] += v_[n] * next.dt;
    t_ += next.dt;
    const char* kind = respond(next);
    const auto velocity = [&](int n) {
      const Vec3& v = v_[static_cast<std::size_t>(n)];
      return fmt::format(R"("{}":{{"velocity":["{}","{}","{}"]}})", n, to_hex<double>(v[0]),
                         to_hex<double>(v[1]), to_hex<double>(v[2]));
    };
    text += fmt::format(R"({{"t":"{}","kind":"{}","i":{},"j":{},"post":{{{},{}}}}})", to_hex<double>(t_),
                        kind, next.i, next.j, velocity(next.i), velocity(next.j));
    text += '\n';
    return true;
  }

  const char* respond(const Next& next) {
    const auto a = static_cast<std::size_t>(next.i), b = static_cast<std::size_t>(next.j);
    const PairLaw& law = scene_.pairs.front();
    const double m = scene_.species.front().mass;
    const auto frame = collision_frame<double, 3>(u_[a], u_[b], v_[a], v_[b]);
    const char* kind = "rebound";
    Vec3 dp = Vec3::Zero();
    if (!next.outer) {
      if (frame.v_n < 0) dp = collision_impulse<double, 3>(frame, m, m, law.blocking->c_rebound);
    } else {
      const TetheringLaw& pull = *law.tethering;
      const auto answer =
          tether_response<double, 3>(frame, m, m, pull.c_retract, pull.c_revolve, pull.theta_revolve_deg);
      kind = answer.kind == TetherResponseKind::retract ? "retract" : "revolve";
      dp = answer.dp;
      if (product_ && answer.kind == TetherResponseKind::revolve) {
        const auto turned = revolution<double, 3>(frame, pull.c_revolve, pull.theta_revolve_deg);
        dp = reduced_mass<double>(m, m) * (frame.v_AB - pull.c_revolve * pull.theta_revolve_deg / 180 *
                                                            frame.v_AB.norm() * turned.u_hat_revolve);
      }
    }
    const auto after = apply_impulse<double, 3>(m, m, v_[a], v_[b], dp);
    std::erase_if(responded_, [&](const auto& r) {
      const auto meets = [&](int n) { return std::get<0>(r) == n || std::get<1>(r) == n; };
      return (after.v_A != v_[a] && meets(next.i)) || (after.v_B != v_[b] && meets(next.j));
    });
    v_[a] = after.v_A;
    v_[b] = after.v_B;
    responded_.insert({next.i, next.j, next.outer});
    return kind;
  }

  Scene scene_;
  bool product_;
  double t_;
  std::vector<Vec3> u_, v_;
  std::map<std::pair<int, int>, bool> tethered_;
  std::set<std::tuple<int, int, bool>> responded_;
};

/// A chain of beads far from the origin, with random velocities.
inline Scene random_chain(std::uint64_t seed, double c_revolve = 1) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Scene scene;
  scene.dimension = 3;
  scene.duration = 1e6;
  scene.start_time = std::floor(std::exp2(std::uniform_real_distribution<double>(0, 12)(random)));
  scene.species.resize(1);
  scene.species[0] = {"bead", 1.25, .5, {}};
  PairLaw& pair = scene.pairs.emplace_back();
  pair.blocking = BlockingLaw{1, 1};
  pair.tethering.emplace();
  pair.tethering->distance = 1.5;
  pair.tethering->c_revolve = c_revolve;
  pair.tethering->form.when = FormRule::When::never;
  const double away = 10 * normal(random);
  for (int n = 0; n < 12; ++n) {
    scene.particles.push_back(
        {n, 0, {away + 1.25 * n, away, 0}, {normal(random), normal(random), normal(random)}});
    if (n > 0) scene.tethers.push_back({n - 1, n});
  }
  return scene;
}

}  // namespace tps::mutation

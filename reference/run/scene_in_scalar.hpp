// Whether a scene, whose numbers are doubles, is the same scene in the scalar of a run: nothing of it may
// become infinite, vanish, or fall together.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "reference/engine/drag_clock.hpp"
#include "reference/engine/laws.hpp"
#include "reference/engine/periodic_box.hpp"
#include "reference/engine/range.hpp"
#include "reference/run/run.hpp"
#include "reference/scalars.hpp"
#include "reference/scene/surfaces.hpp"
#include "reference/text/input_error.hpp"
#include "reference/text/json_pointer.hpp"
#include "reference/text/number_text.hpp"

namespace tps {

/// Throws InputError for a start that the scalar cannot simulate.
template <typename Scalar>
[[noreturn]] void refuse_start(const std::string& what) {
  throw InputError({{"scene", 0, "",
                     what + " leaves the range of " + std::string(scalar_name<Scalar>) +
                         " before the first event; choose other units, or run with a wider --scalar"}});
}

/// Collects what is wrong with a scene in a scalar.
template <typename Scalar, int D>
class SceneInScalar {
 public:
  SceneInScalar(const Scene& scene, const RunOptions& options) : scene_(scene) {
    for (std::size_t n = 0; n < scene.species.size(); ++n) judge_mass(scene.species[n]);
    for (const Species& species : scene.species) judge_kicks(species);
    for (const PairLaw& law : scene.pairs) judge_law(law);
    for (std::size_t i = 0; i < scene.particles.size(); ++i) judge_particle(scene.particles[i]);
    if (scene.grouping) judge("/grouping/dt_restitute", scene.grouping->dt_restitute);
    if (scene.drag) judge("/drag/gamma", scene.drag->gamma);
    if (scene.gravity) {
      judge("/gravity/every", scene.gravity->every);
      judge_vector("/gravity/acceleration", scene.gravity->acceleration, "the acceleration");
    }
    for (const Surface& surface : surfaces(scene)) judge_surface(surface);
    if (scene.box) judge_box(options.until.value_or(scene.duration));
    for (std::size_t n = 0; n < scene.impulses.size(); ++n) {
      const std::string at = "/impulses/" + std::to_string(n);
      judge(at + "/at", scene.impulses[n].at);
      judge_vector(at + "/impulse", scene.impulses[n].impulse, "the impulse");
    }
    for (std::size_t n = 0; n < scene.phases.size(); ++n) {
      judge("/phases/" + std::to_string(n) + "/from", scene.phases[n].from);
      judge("/phases/" + std::to_string(n) + "/until", scene.phases[n].until);
      judge_breaking("/phases/" + std::to_string(n), scene.phases[n].breaks);
    }
    judge("/duration", options.until.value_or(scene.duration));
    if (scene.drag) judge_last_time(options.until.value_or(scene.duration));
    if (problems_.empty()) judge_places();
  }

  const std::vector<InputProblem>& problems() const { return problems_; }

 private:
  using Limits = std::numeric_limits<Scalar>;

  static std::string told(double x) { return write_shortest(x); }

  void add(const std::string& pointer, const std::string& message) {
    constexpr std::size_t kAtMost = 20;
    if (problems_.size() < kAtMost) problems_.push_back({"scene", 0, pointer, message});
  }
  static std::string remedy() {
    return " in " + std::string(scalar_name<Scalar>) + "; choose other units, or run with a wider --scalar";
  }

  /// A finite number stays finite, one that is not zero stays so.
  void judge(const std::string& pointer, double x) {
    const Scalar held = Scalar(x);
    if (is_finite(x) && !is_finite(held)) add(pointer, "is " + told(x) + ", which is infinite" + remedy());
    if (x != 0 && held == Scalar(0)) add(pointer, "is " + told(x) + ", which is zero" + remedy());
  }

  /// Components may vanish beside others, vectors may not.
  void judge_vector(const std::string& pointer, const Coordinates& x, const char* what) {
    bool was_zero = true;
    bool is_zero = true;
    for (std::size_t k = 0; k < D; ++k) {
      was_zero = was_zero && x[k] == 0;
      is_zero = is_zero && Scalar(x[k]) == Scalar(0);
      if (!is_finite(Scalar(x[k])))
        add(pointer + "/" + std::to_string(k), "is " + told(x[k]) + ", which is infinite" + remedy());
    }
    if (is_zero && !was_zero) add(pointer, std::string(what) + " is zero" + remedy());
  }

  /// Mass and inverse mass are normal numbers: eqs. (3) to (5) are made of 1/m.
  void judge_mass(const Species& species) {
    if (!is_finite(species.mass)) return;
    const Scalar mass = Scalar(species.mass);
    const Scalar least = (Limits::min)();
    if (is_finite(mass) && mass >= least && is_finite(Scalar(Scalar(1) / mass)) && Scalar(1) / mass >= least)
      return;
    add("/species/" + escape_pointer_key(species.name) + "/mass",
        "is " + told(species.mass) + "; the mass or its inverse is not a normal number" + remedy());
  }

  void judge_kicks(const Species& species) {
    const std::string at = "/species/" + escape_pointer_key(species.name);
    if (const auto& kicks = species.random_impulses) {
      judge(at + "/random_impulses/tau", kicks->tau);
      judge(at + "/random_impulses/mean", kicks->mean);
    }
    if (const auto& bath = species.thermostat) {
      judge(at + "/thermostat/tau", bath->tau);
      judge(at + "/thermostat/kT", bath->kT);
    }
  }

  void judge_breaking(const std::string& pointer, const std::optional<BreakRule>& rule) {
    if (rule && rule->when == BreakRule::When::impulse_above)
      judge(pointer + "/break/impulse_above", rule->threshold);
  }

  void judge_law(const PairLaw& law) {
    const std::string at = "/pairs/" + std::to_string(static_cast<std::size_t>(&law - scene_.pairs.data()));
    if (law.blocking) {
      judge(at + "/blocking/distance", law.blocking->distance);
      judge(at + "/blocking/c_rebound", law.blocking->c_rebound);
    }
    if (law.friction) {
      judge(at + "/friction/mu", law.friction->mu);
      judge(at + "/friction/beta0", law.friction->beta0);
    }
    if (!law.tethering) return;
    judge(at + "/tethering/distance", law.tethering->distance);
    judge(at + "/tethering/c_retract", law.tethering->c_retract);
    judge(at + "/tethering/c_revolve", law.tethering->c_revolve);
    judge_breaking(at + "/tethering", law.tethering->breaks);
    if (law.blocking && !(Scalar(law.tethering->distance) > Scalar(law.blocking->distance))) {
      add(at + "/tethering/distance", "is " + told(law.tethering->distance) +
                                          " and not above the blocking distance " +
                                          told(law.blocking->distance) + remedy());
    }
  }

  /// Times under drag are printed as doubles, in every scalar.
  void judge_last_time(double duration) {
    if (!is_finite(duration) || duration <= last_drag_time(scene_.start_time)) return;
    add("/duration", "is " + told(duration) + " after the start at " + told(scene_.start_time) +
                         "; under drag a time is printed as a double, and this sum is none; choose other "
                         "units, or another start_time");
  }

  /// Edges stay wider than two interaction distances, and an end is needed.
  void judge_box(double duration) {
    for (std::size_t k = 0; k < D; ++k) {
      const std::string at = "/box/periodic/" + std::to_string(k);
      const double edge = scene_.box->edges[k];
      judge(at, edge);
      if (!(Scalar(edge) / Scalar(2) > Scalar(longest_interaction(scene_))))
        add(at, "is " + told(edge) + ", which is not above two interaction distances" + remedy());
    }
    if (!is_finite(duration)) add("/duration", "is inf; in a periodic box a run needs an end");
  }

  void judge_surface(const Surface& surface) {
    const std::string at = "/walls/" + std::to_string(surface.wall);
    judge(at + "/c_rebound", surface.c_rebound);
    judge_vector(at + "/velocity", surface.velocity, "the velocity");
    for (std::size_t k = 0; k < D; ++k) {
      if (!is_finite(Scalar(surface.point[k])))
        add(at, "is at " + told(surface.point[k]) + ", which is infinite" + remedy());
    }
    for (std::size_t k = 0; surface.region && k < D; ++k) {
      if (!(Scalar(surface.region->low[k]) < Scalar(surface.region->high[k])))
        add(at, "has its ends along axis " + std::to_string(k) + " at one place" + remedy());
    }
    for (const Species& species : scene_.species) {
      const double L = touching_distance(surface, species.radius);
      if (is_finite(species.mass) && (Scalar(L) == Scalar(0) || !is_finite(Scalar(L))))
        add(at, "touches particles of " + species.name + " at " + told(L) + ", which is " +
                    (Scalar(L) == Scalar(0) ? "zero" : "infinite") + remedy());
    }
  }

  void judge_particle(const Particle& particle) {
    const auto n = static_cast<std::size_t>(&particle - scene_.particles.data());
    const std::string at = "/particles/" + std::to_string(n);
    for (std::size_t k = 0; k < D; ++k) {
      if (is_finite(Scalar(particle.position[k]))) continue;
      add(at + "/position/" + std::to_string(k),
          "is " + told(particle.position[k]) + ", which is infinite" + remedy());
    }
    judge_vector(at + "/velocity", particle.velocity, "the velocity");
    const Coordinates spin = spin_of(scene_, n);
    for (std::size_t k = 0; k < spin.size(); ++k) judge(at + "/spin/" + std::to_string(k), spin[k]);
  }

  /// Two particles with a law that fall together, or whose separation is mostly rounding: it moves by more
  /// than a quarter of its length.
  void judge_places() {
    if (Limits::digits >= std::numeric_limits<double>::digits) return;  // holds every double
    const Laws<Scalar> laws(scene_);
    for (std::size_t i = 0; i < scene_.particles.size(); ++i) {
      for (std::size_t j = i + 1; j < scene_.particles.size(); ++j) {
        const Particle &p = scene_.particles[i], &q = scene_.particles[j];
        const Law<Scalar>& law = laws.of(p.species, q.species);
        if (law.blocking || law.tethering) judge_separation(p, q);
      }
    }
  }

  void judge_separation(const Particle& p, const Particle& q) {
    long double moved = 0;
    long double length = 0;
    bool together = true;
    for (std::size_t k = 0; k < D; ++k) {
      const Scalar a = Scalar(p.position[k]);
      const Scalar b = Scalar(q.position[k]);
      together = together && a == b;
      const long double exact = static_cast<long double>(q.position[k]) - p.position[k];
      const long double held = static_cast<long double>(b) - static_cast<long double>(a);
      moved = std::max(moved, std::fabs(held - exact));
      length = std::max(length, std::fabs(exact));
    }
    if (!together && moved <= length / 4) return;
    const bool together_in_scene = length == 0;
    const bool fixed = !is_finite(scene_.species[static_cast<std::size_t>(p.species)].mass) &&
                       !is_finite(scene_.species[static_cast<std::size_t>(q.species)].mass);
    if (together_in_scene || fixed) return;  // they may part; two infinite masses never interact
    add("/particles", "particles " + std::to_string(p.id) + " and " + std::to_string(q.id) +
                          (together ? " are at one place" : " are not where they are in the scene") +
                          remedy() + " (coordinate " + told(p.position[0]) + " beside " +
                          told(q.position[0]) + ")");
  }

  const Scene& scene_;
  std::vector<InputProblem> problems_;
};

/// Throws InputError where the scene is not the same scene in the scalar.
template <typename Scalar, int D>
void require_scene_in_scalar(const Scene& scene, const RunOptions& options) {
  const SceneInScalar<Scalar, D> judged(scene, options);
  if (!judged.problems().empty()) throw InputError(judged.problems());
}

}  // namespace tps

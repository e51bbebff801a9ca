// The pair laws of a scene in the numbers of a trace.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "reference/scene/scene.hpp"
#include "verify/trace_check/number.hpp"

namespace tps::check {

/// The number that a run of the trace's scalar computes with where the scene has x: floats round it once.
///
/// Out of line: g++ 12.2 at -O2 inlines `is_float ? double(float(x)) : x` for several x at once and forgets
/// the rounding of some (its vectoriser; at -O1 it does not).
template <typename Number>
[[gnu::noinline]] Number stored(double x, const Precision<Number>& precision) {
  if (precision.is_float) return Number(static_cast<double>(static_cast<float>(x)));
  return Number(x);
}

/// The sum of two numbers of the scalar, rounded once as the scalar rounds.
template <typename Number>
Number sum_in_scalar(const Number& x, const Number& y, const Precision<Number>& precision) {
  if constexpr (std::is_same_v<Number, double>) return stored<double>(x + y, precision);
  return reading(Instant<Number>{Number(x + y), Number(0)}, precision);
}

/// The product of two numbers of the scalar, rounded once as the scalar rounds. REQUIRES of a wider scalar
/// that they are doubles, whose product a Wide holds exactly.
template <typename Number>
Number product_in_scalar(const Number& x, const Number& y, const Precision<Number>& precision) {
  if constexpr (std::is_same_v<Number, double>) return stored<double>(x * y, precision);
  return reading(Instant<Number>{Number(x * y), Number(0)}, precision);
}

template <typename Number>
struct PairRules {
  bool blocks = false;
  Number inner{0}, c_rebound{0};
  bool rubs = false;  ///< friction at the inner limit
  Number mu{0}, beta0{0};
  bool can_tether = false, permanent = false;
  Number outer{0}, c_retract{0}, c_revolve{0}, theta_deg{0};
  Work<Number> tan_theta{0};
  Work<Number> speed_ratio{0};        ///< c_revolve^(θ/π)
  Work<Number> exponent_of_ratio{0};  ///< |ln| of it: what its relative error is of that of the exponent
  FormRule form;
  BreakRule breaks;
};

template <typename Number>
class RuleTable {
 public:
  RuleTable(const Scene& scene, const Precision<Number>& precision)
      : species_(scene.species.size()), table_(species_ * species_) {
    for (const Particle& p : scene.particles) species_of_.push_back(static_cast<std::uint32_t>(p.species));
    for (const PairLaw& law : scene.pairs) {
      PairRules<Number> rules;
      if (law.blocking) {
        rules.blocks = true;
        rules.inner = stored<Number>(law.blocking->distance, precision);
        rules.c_rebound = stored<Number>(law.blocking->c_rebound, precision);
      }
      if (law.friction) {
        rules.rubs = true;
        rules.mu = stored<Number>(law.friction->mu, precision);
        rules.beta0 = stored<Number>(law.friction->beta0, precision);
      }
      if (law.tethering) add_tethering(rules, *law.tethering, precision);
      at(law.species_a, law.species_b) = rules;
      at(law.species_b, law.species_a) = rules;
    }
  }

  const PairRules<Number>& of(int i, int j) const { return table_[species(i) * species_ + species(j)]; }
  PairRules<Number>& at(int species_a, int species_b) {
    return table_[static_cast<std::size_t>(species_a) * species_ + static_cast<std::size_t>(species_b)];
  }

 private:
  static void add_tethering(PairRules<Number>& rules, const TetheringLaw& law,
                            const Precision<Number>& precision) {
    using std::log;
    using std::pow;
    using std::tan;
    using W = Work<Number>;
    rules.can_tether = true;
    rules.permanent = law.form.when == FormRule::When::permanent;
    rules.outer = stored<Number>(law.distance, precision);
    rules.c_retract = stored<Number>(law.c_retract, precision);
    rules.c_revolve = stored<Number>(law.c_revolve, precision);
    // Angles that float cannot tell from 0° or 90° (docs/decisions.md, N42).
    rules.theta_deg = stored<Number>(law.theta_revolve_deg, precision);
    if (precision.is_float)
      rules.theta_deg = std::clamp(rules.theta_deg, Number(0x1p-15), Number(std::nextafter(90.0F, 0.0F)));
    rules.form = law.form;
    rules.breaks = law.breaks;
    const W radian = W(atan_of_one()) / W(45);
    const W theta(rules.theta_deg);
    // Above 45° by the complement, which is exact in degrees.
    rules.tan_theta = theta > W(45) ? W(1) / W(tan(W(W(90) - theta) * radian)) : W(tan(W(theta * radian)));
    if (rules.c_revolve == Number(0)) return;
    rules.speed_ratio = W(pow(W(rules.c_revolve), W(theta / W(180))));
    rules.exponent_of_ratio = -W(log(W(rules.c_revolve))) * theta / W(180);
  }
  static Work<Number> atan_of_one() {
    using std::atan;
    return atan(Work<Number>(1));
  }

  std::size_t species(int n) const { return species_of_[static_cast<std::size_t>(n)]; }

  std::size_t species_;
  std::vector<std::uint32_t> species_of_;  ///< by particle
  std::vector<PairRules<Number>> table_;
};

}  // namespace tps::check

#include "verify/certified/next_event_input.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "reference/engine/effect_facts.hpp"

namespace tps::certified {
namespace {

std::vector<double> components(const Coordinates& x, int dimension) {
  return {x.begin(), x.begin() + dimension};
}

/// What a pair of species does, looked up once for all pairs of particles.
class LawTable {
 public:
  explicit LawTable(const Scene& scene)
      : species_(scene.species.size()), laws_(species_ * species_, nullptr) {
    for (const PairLaw& law : scene.pairs) {
      at(law.species_a, law.species_b) = &law;
      at(law.species_b, law.species_a) = &law;
    }
  }
  const PairLaw* between(const Particle& one, const Particle& other) const {
    return laws_[place(one.species, other.species)];
  }

 private:
  std::size_t place(int a, int b) const {
    return static_cast<std::size_t>(a) * species_ + static_cast<std::size_t>(b);
  }
  const PairLaw*& at(int a, int b) { return laws_[place(a, b)]; }

  std::size_t species_;
  std::vector<const PairLaw*> laws_;
};

class Limits {
 public:
  explicit Limits(const Scene& scene) : scene_(scene), table_(scene), tethers_of_(scene.particles.size(), 0) {
    for (const Tether& tether : scene.tethers) {
      tethered_.emplace(tether.i, tether.j);
      ++tethers_of_[static_cast<std::size_t>(tether.i)];
      ++tethers_of_[static_cast<std::size_t>(tether.j)];
    }
  }

  /// Of i < j.
  void add(std::size_t i, std::size_t j, std::vector<PairLimit>& limits) const {
    const PairLaw* law = table_.between(scene_.particles[i], scene_.particles[j]);
    if (law == nullptr) return;
    const bool listed = tethered_.contains({static_cast<int>(i), static_cast<int>(j)});
    if (law->blocking) {
      PairLimit limit{i, j, exact::Kind::block, law->blocking->distance, law->blocking->c_rebound};
      limit.forms = law->tethering && law->tethering->form.when == FormRule::When::always && !listed &&
                    has_room(i) && has_room(j);
      limits.push_back(limit);
    }
    if (!law->tethering) return;
    const TetheringLaw& tether = *law->tethering;
    if (!listed && tether.form.when != FormRule::When::permanent) return;
    PairLimit limit{i,
                    j,
                    exact::Kind::tether,
                    tether.distance,
                    tether.c_retract,
                    tether.c_revolve,
                    tether.theta_revolve_deg};
    limit.breaks = tether.breaks.when == BreakRule::When::always;
    if (tether.breaks.when == BreakRule::When::impulse_above) limit.breaks_above = tether.breaks.threshold;
    limits.push_back(limit);
  }

 private:
  bool has_room(std::size_t i) const {
    const auto& capacity = scene_.species[static_cast<std::size_t>(scene_.particles[i].species)].max_tethers;
    return !capacity || tethers_of_[i] < *capacity;
  }

  const Scene& scene_;
  LawTable table_;
  std::set<std::pair<int, int>> tethered_;
  std::vector<int> tethers_of_;
};

}  // namespace

std::optional<std::string> not_certified(const Scene& scene) {
  constexpr std::string_view of_the_paper[] = {"rebound", "tethering", "grouping"};
  for (const EffectFacts& effect : effect_facts(scene)) {
    if (effect.called &&
        std::find(std::begin(of_the_paper), std::end(of_the_paper), effect.name) == std::end(of_the_paper))
      return effect.name;
  }
  const bool draws = std::any_of(scene.pairs.begin(), scene.pairs.end(), [](const PairLaw& law) {
    return law.tethering && (law.tethering->form.when == FormRule::When::probability ||
                             law.tethering->breaks.when == BreakRule::When::probability);
  });
  if (draws) return "rule with a probability";
  return std::nullopt;
}

NextEventInput next_event_input(const Scene& scene) {
  NextEventInput input;
  input.grouped = scene.grouping.has_value();
  for (const Particle& particle : scene.particles) {
    input.bodies.push_back({scene.species[static_cast<std::size_t>(particle.species)].mass,
                            components(particle.position, scene.dimension),
                            components(particle.velocity, scene.dimension)});
  }
  const Limits limits(scene);
  for (std::size_t i = 0; i < input.bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < input.bodies.size(); ++j) {
      if (std::isinf(input.bodies[i].mass) && std::isinf(input.bodies[j].mass)) continue;
      limits.add(i, j, input.limits);
    }
  }
  return input;
}

}  // namespace tps::certified

// The pair laws of a scene in the engine's scalar, found by the species of the two particles.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "reference/equations/angle.hpp"
#include "reference/scene/scene.hpp"

namespace tps {

/// One pair of species, with the scene's doubles rounded once to the scalar.
template <typename Scalar>
struct Law {
  struct Blocking {
    Scalar distance, c_rebound;
  };
  struct Tethering {
    Scalar distance, c_retract, c_revolve, theta_revolve_deg;
    FormRule form;     ///< in force now: phases replace it
    BreakRule breaks;  ///< in force now: phases replace it
    bool permanent;
  };
  std::optional<Blocking> blocking;
  std::optional<Tethering> tethering;
};

/// Symmetric table of laws; a pair of species that the scene does not list has neither limit.
template <typename Scalar>
class Laws {
 public:
  explicit Laws(const Scene& scene) : species_(scene.species.size()), table_(species_ * species_) {
    for (const PairLaw& pair : scene.pairs) {
      Law<Scalar> law;
      if (pair.blocking) law.blocking = {Scalar(pair.blocking->distance), Scalar(pair.blocking->c_rebound)};
      if (pair.tethering) {
        const TetheringLaw& t = *pair.tethering;
        law.tethering = {Scalar(t.distance),
                         Scalar(t.c_retract),
                         Scalar(t.c_revolve),
                         angle_in_degrees<Scalar>(t.theta_revolve_deg),
                         t.form,
                         t.breaks,
                         t.form.when == FormRule::When::permanent};
      }
      of(pair.species_a, pair.species_b) = law;
      of(pair.species_b, pair.species_a) = law;
    }
  }

  const Law<Scalar>& of(int species_a, int species_b) const { return table_[index(species_a, species_b)]; }

  /// Replaces the rules of a tethering law, both ways round. REQUIRES the pair has one.
  void replace_rules(int species_a, int species_b, const FormRule& form, const BreakRule& breaks) {
    for (Law<Scalar>* law : {&of(species_a, species_b), &of(species_b, species_a)}) {
      law->tethering->form = form;
      law->tethering->breaks = breaks;
    }
  }

 private:
  std::size_t index(int a, int b) const {
    return static_cast<std::size_t>(a) * species_ + static_cast<std::size_t>(b);
  }
  Law<Scalar>& of(int species_a, int species_b) { return table_[index(species_a, species_b)]; }

  std::size_t species_;
  std::vector<Law<Scalar>> table_;
};

}  // namespace tps

#include "verify/scenes/terminal.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "verify/scenes/placement.hpp"
#include "verify/scenes/thermal.hpp"

namespace tps {
namespace {

enum SpeciesIndex { kMembrane, kVesicle, kSynapsin };

constexpr double kSynapsinRadius = 1;
// Below this filling random placement succeeds within a few tries a particle; the limit only bounds hopeless
// input.
constexpr int kTries = 20000;

/// Containment: an elastic wall. The small angle keeps reflections specular for all but grazing paths.
TetheringLaw inside_membrane(double distance) {
  return {.distance = distance,
          .c_retract = 1,
          .c_revolve = 1,
          .theta_revolve_deg = 1,
          .form = {.when = FormRule::When::permanent},
          .breaks = {.when = BreakRule::When::never}};
}

TetheringLaw bond(const TerminalParams& params, double distance, FormRule form, BreakRule breaks) {
  return {.distance = distance,
          .c_retract = params.c_retract,
          .c_revolve = params.c_revolve,
          .theta_revolve_deg = params.theta,
          .form = form,
          .breaks = breaks};
}

std::vector<PairLaw> laws(const TerminalParams& params) {
  const auto blocking = [&](double distance) {
    return BlockingLaw{.distance = distance, .c_rebound = params.c_rebound};
  };
  const double contact = params.vesicle_radius + kSynapsinRadius;
  const FormRule where_they_collide =
      params.form_probability == 1
          ? FormRule{.when = FormRule::When::always}
          : FormRule{.when = FormRule::When::probability, .probability = params.form_probability};
  const BreakRule where_they_pull =
      params.break_probability == 0
          ? BreakRule{.when = BreakRule::When::never}
          : BreakRule{.when = BreakRule::When::probability, .probability = params.break_probability};
  return {{.species_a = kMembrane,
           .species_b = kVesicle,
           .blocking = {},
           .tethering = inside_membrane(params.membrane_radius - params.vesicle_radius)},
          {.species_a = kMembrane,
           .species_b = kSynapsin,
           .blocking = {},
           .tethering = inside_membrane(params.membrane_radius - kSynapsinRadius)},
          {.species_a = kVesicle,
           .species_b = kVesicle,
           .blocking = blocking(2 * params.vesicle_radius),
           .tethering = {}},
          {.species_a = kVesicle,
           .species_b = kSynapsin,
           .blocking = blocking(contact),
           .tethering = bond(params, params.tether_ratio * contact, where_they_collide, where_they_pull)},
          {.species_a = kSynapsin,
           .species_b = kSynapsin,
           .blocking = blocking(2 * kSynapsinRadius),
           .tethering = bond(params, params.pair_tether, {.when = FormRule::When::never}, {})}};
}

/// Draws places until `place(stream)` finds free ones; `stream_id` makes the draws this thing's own.
template <typename Place>
auto placed(const TerminalParams& params, std::uint32_t stream_id, const char* what, Place place) {
  RandomStream stream{params.seed, Purpose::scene_position, stream_id, 0, 0};
  for (int attempt = 0; attempt < kTries; ++attempt) {
    if (auto found = place(stream)) return *found;
  }
  throw std::invalid_argument(fmt::format(
      "no room for {} {} in the membrane of radius {} after {} tries; take fewer particles or a larger "
      "--membrane-radius",
      what, stream_id, params.membrane_radius, kTries));
}

/// Vesicles first, since they need the larger holes, then pairs of synapsins.
std::vector<Placed> places(const TerminalParams& params) {
  std::vector<Placed> taken;
  std::uint32_t id = 1;
  for (int i = 0; i < params.vesicles; ++i) {
    taken.push_back(placed(params, id++, "vesicle", [&](RandomStream& stream) -> std::optional<Placed> {
      const Placed vesicle{random_point(stream, params.membrane_radius), params.vesicle_radius};
      if (is_free(vesicle, taken, params.membrane_radius)) return vesicle;
      return std::nullopt;
    }));
  }
  const double mates_apart = (2 * kSynapsinRadius + params.pair_tether) / 2;  // half-way between both limits
  for (int i = 0; i < params.pairs; ++i, id += 2) {
    using Mates = std::array<Placed, 2>;
    const Mates mates = placed(params, id, "synapsin", [&](RandomStream& stream) -> std::optional<Mates> {
      const Placed one{random_point(stream, params.membrane_radius), kSynapsinRadius};
      Placed other = one;
      const Coordinates direction = random_direction(stream);
      for (std::size_t k = 0; k < 3; ++k) other.center[k] += mates_apart * direction[k];
      if (is_free(one, taken, params.membrane_radius) && is_free(other, taken, params.membrane_radius)) {
        return Mates{one, other};
      }
      return std::nullopt;
    });
    taken.insert(taken.end(), mates.begin(), mates.end());
  }
  return taken;
}

void check(const TerminalParams& params) {
  if (params.pair_tether <= 2 * kSynapsinRadius) {
    throw std::invalid_argument(
        fmt::format("--pair-tether is {}; mates block at 2, so it must be above 2", params.pair_tether));
  }
  if (params.impacts > params.vesicles) {
    throw std::invalid_argument(fmt::format("--impacts is {}; allowed is an integer from 0 to --vesicles, {}",
                                            params.impacts, params.vesicles));
  }
  if (params.impacts > 0 && !(params.impact_at < params.duration)) {
    throw std::invalid_argument(
        fmt::format("--impact-at is {}; impacts begin before --duration, {}, or there are none: --impacts 0",
                    params.impact_at, params.duration));
  }
}

}  // namespace

Scene build_terminal(const TerminalParams& params) {
  check(params);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Scene scene;
  scene.title = "A presynaptic terminal: vesicles and synapsins in a spherical membrane";
  scene.duration = params.duration;
  scene.seed = params.seed;
  scene.species = {
      {.name = "membrane", .mass = kInfinity, .radius = params.membrane_radius, .max_tethers = {}},
      {.name = "vesicle", .mass = params.vesicle_mass, .radius = params.vesicle_radius, .max_tethers = {}},
      {.name = "synapsin", .mass = 1, .radius = kSynapsinRadius, .max_tethers = 2}};
  scene.pairs = laws(params);
  if (params.grouped > 0) scene.grouping = Grouping{params.grouped};
  scene.clusters = ClusterObservation{.species = kVesicle, .at_least = 3};

  scene.particles = {{.id = 0, .species = kMembrane, .position = {}, .velocity = {}}};
  for (const Placed& sphere : places(params)) {
    const auto id = static_cast<std::int32_t>(scene.particles.size());
    scene.particles.push_back({.id = id,
                               .species = id <= params.vesicles ? kVesicle : kSynapsin,
                               .position = sphere.center,
                               .velocity = {}});
  }
  for (int pair = 0; pair < params.pairs; ++pair) {
    const int first = 1 + params.vesicles + 2 * pair;
    scene.tethers.push_back({first, first + 1});
  }
  if (params.impacts > 0 && std::isinf(params.duration)) {
    throw std::invalid_argument(
        "--duration is \"inf\", and the impacts are spread over it; give a time that ends, or --impacts 0");
  }
  for (int i = 0; i < params.impacts; ++i) {
    const double every = (params.duration - params.impact_at) / params.impacts;
    scene.impulses.push_back(
        {.at = params.impact_at + i * every, .particle = 1 + i, .impulse = {params.impact, 0, 0}});
  }
  return with_thermal_velocities(scene, params.temperature);
}

SceneBuilder terminal_builder() {
  using P = TerminalParams;
  return make_builder<P>(
      "terminal", "the paper's Figure 1: vesicles and synapsins in a membrane form clusters and meet impacts",
      {{"vesicles", &P::vesicles, from_to(1, 10000), "vesicles"},
       {"pairs", &P::pairs, from_to(0, 1000000), "pairs of synapsins; clusters need about two a vesicle"},
       {"membrane-radius", &P::membrane_radius, above(0, 1e6),
        "in synapsin radii; shorter free paths, earlier clusters when smaller; placement fails above 30 % "
        "filling"},
       {"vesicle-radius", &P::vesicle_radius, from_to(1, 100), "in synapsin radii"},
       {"vesicle-mass", &P::vesicle_mass, above(0, 1e6), "in synapsin masses; light ones meet more often"},
       {"tether-ratio", &P::tether_ratio, from_to(1.0001, 3),
        "vesicle-synapsin tether over contact distance"},
       {"pair-tether", &P::pair_tether, above(2, 100),
        "tether of two mates, in synapsin radii (they block at 2); longer ones reach a second vesicle "
        "sooner"},
       {"temperature", &P::temperature, from_to(0, 1e6), "kT of the start velocities; a synapsin has mass 1"},
       {"c-rebound", &P::c_rebound, from_to(0, 1), "restitution of every blocking collision"},
       {"c-retract", &P::c_retract, from_to(0, 1), "restitution where a tether retracts"},
       {"c-revolve", &P::c_revolve, from_to(0, 1), "speed kept over a revolution"},
       {"theta", &P::theta, from_to(1e-6, 90 - 1e-6), "angle of revolution, in degrees"},
       {"form-probability", &P::form_probability, from_to(0, 1), "that a vesicle-synapsin collision tethers"},
       {"break-probability", &P::break_probability, from_to(0, 1),
        "that a pulled vesicle-synapsin tether breaks"},
       {"impact", &P::impact, from_to(0, 1e9), "impulse of each impact, along +x"},
       {"impact-at", &P::impact_at, from_to(0, 1e9), "time of the first impact, before --duration"},
       {"impacts", &P::impacts, from_to(0, 1000), "how many, on vesicles 1, 2, …, evenly until the end"},
       {"grouped", &P::grouped, from_to(0, 1e6),
        "dt_restitute of grouping; 0: no grouping; expected well below a mean free time of about 1"},
       {"duration", &P::duration, above(0), "time simulated"},
       {"seed", &P::seed, {}, "of places and start velocities"}},
      &build_terminal);
}

}  // namespace tps

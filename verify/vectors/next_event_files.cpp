// The strata of next_event: small scenes with blocking pairs, walls and tethers, and a certified answer.
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "verify/vectors/next_event_answer.hpp"
#include "verify/vectors/stratum.hpp"

namespace tps::vectors {
namespace {

Json species(Random& random, bool fixed) {
  const double significand = random.uniform(1, 2);
  const double mass = std::ldexp(significand, random.integer(-3, 3));
  return {{"mass", fixed ? Json("inf") : hex(mass)}, {"radius", hex(0.5)}};
}

Json pair_law(Random& random, const char* one, const char* other, bool tethers) {
  Json law{{"between", {one, other}},
           {"blocking", {{"distance", hex(1)}, {"c_rebound", hex(random.uniform(0, 1))}}}};
  if (!tethers) return law;
  law["tethering"] = {{"distance", hex(random.uniform(2, 3))},
                      {"c_retract", hex(random.uniform(0, 1))},
                      {"c_revolve", hex(random.uniform(0, 1))},
                      {"theta_revolve_deg", hex(random.uniform(1, 89))}};
  return law;
}

/// Particles on a grid of edge 1.5, moved by up to 0.2; every other one of species "b".
Json particles(Random& random, int dimension, int count, bool fixed) {
  Json list = Json::array();
  for (int n = 0; n < count; ++n) {
    std::vector<double> position, velocity;
    for (int k = 0; k < dimension; ++k) {
      const int cell = n >> k & 1;
      position.push_back(1.5 * cell + random.uniform(-0.2, 0.2));
      velocity.push_back(fixed && n % 2 != 0 ? 0 : random.uniform(-1, 1));
    }
    list.push_back({{"id", n},
                    {"species", n % 2 == 0 ? "a" : "b"},
                    {"position", hex(position)},
                    {"velocity", hex(velocity)}});
  }
  return list;
}

struct SceneKind {
  const char* name;
  const char* why;
  bool fixed, tethered;
};

constexpr SceneKind scene_kinds[] = {
    {"gas", "up to eight particles that rebound, in the plane and in space", false, false},
    {"walls", "every second particle of infinite mass", true, false},
    {"tethered", "neighbours tethered: rebounds, retractions and revolutions", false, true},
};

Json scene(Random& random, const SceneKind& kind, std::uint64_t number) {
  const int dimension = number % 2 == 0 ? 2 : 3;
  const int count = random.integer(2, 1 << dimension);
  Json made{{"tps", 1}, {"dimension", dimension}, {"duration", 1000}};
  made["species"]["a"] = species(random, false);
  made["species"]["b"] = species(random, kind.fixed);
  made["pairs"].push_back(pair_law(random, "a", "a", false));
  made["pairs"].push_back(pair_law(random, "a", "b", kind.tethered));
  made["particles"] = particles(random, dimension, count, kind.fixed);
  if (kind.tethered) {
    made["tethers"] = Json::array();
    for (int n = 0; n + 1 < count; n += 2) made["tethers"].push_back({n, n + 1});
  }
  return {{"scene", made}};
}

Problem problem_with_an_event(Random& random, const SceneKind& kind, std::uint64_t number) {
  for (int attempt = 0; attempt < 10000; ++attempt) {
    const Json in = scene(random, kind, number);
    if (next_event_answer(in)) return {in, {kind.name}};
  }
  throw std::logic_error("no scene with an event found; the strata of next_event have changed");
}

}  // namespace

void add_next_event_strata(std::vector<Stratum>& strata) {
  for (const SceneKind& kind : scene_kinds) {
    strata.push_back({Op::next_event, kind.name, kind.why, 40, [kind](Random& random, std::uint64_t number) {
                        return problem_with_an_event(random, kind, number);
                      }});
  }
}

}  // namespace tps::vectors

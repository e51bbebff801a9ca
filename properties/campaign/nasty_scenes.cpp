#include "properties/campaign/nasty_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include "properties/campaign/draw.hpp"
#include "properties/campaign/nasty_changes.hpp"
#include "properties/runs/scenes.hpp"
#include "reference/scene/check_starts.hpp"
#include "reference/scene/read_scene.hpp"
#include "reference/scene/write_scene.hpp"

namespace tps::properties::campaign {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

double coefficient(Draw& draw) {
  return draw.once_in(3) ? draw.unit() : draw.of({0.0, 0.0, 0.5, 1.0, 1.0});
}

TetheringLaw tethering(Draw& draw, double distance) {
  TetheringLaw law;
  law.distance = distance;
  law.c_retract = coefficient(draw);
  law.c_revolve = coefficient(draw);
  law.theta_revolve_deg = draw.of({45.0, 45.0, 30.0, 60.0, 1.0, 89.0, 22.0});
  law.form.when = draw.of({FormRule::When::never, FormRule::When::always, FormRule::When::probability});
  if (law.form.when == FormRule::When::probability) law.form.probability = draw.of({0.0, 0.25, 0.5, 1.0});
  law.breaks.when =
      draw.of({BreakRule::When::never, BreakRule::When::never, BreakRule::When::never,
               BreakRule::When::always, BreakRule::When::probability, BreakRule::When::impulse_above});
  if (law.breaks.when == BreakRule::When::probability) law.breaks.probability = draw.of({0.0, 0.25, 1.0});
  if (law.breaks.when == BreakRule::When::impulse_above) law.breaks.threshold = draw.of({0.0, 1.0, 2.0, 3.0});
  return law;
}

void place(Scene& scene, int species, const Coordinates& position, const Coordinates& velocity) {
  scene.particles.push_back({static_cast<std::int32_t>(scene.particles.size()), species, position, velocity});
}

bool is_free(const Scene& scene, const Coordinates& position, double distance) {
  return std::none_of(scene.particles.begin(), scene.particles.end(), [&](const Particle& p) {
    return start_verdict(p.position, position, distance) == StartVerdict::nearer;
  });
}

/// Small whole numbers everywhere: simultaneous, head-on, touching; walls of infinite mass in rows.
Scene whole_numbers(Draw& draw) {
  Scene scene;
  scene.dimension = draw.of({2, 2, 3});
  scene.duration = draw.of({4.0, 8.0, kInfinite});
  const int kinds = draw.whole(1, 2);
  for (int s = 0; s < kinds; ++s) {
    scene.species.push_back(
        {std::string(1, static_cast<char>('a' + s)), draw.of({1.0, 1.0, 2.0, 3.0}), 0.5, {}});
    if (draw.once_in(4)) scene.species.back().max_tethers = draw.whole(0, 2);
  }
  const bool walls = draw.once_in(2);
  if (walls) scene.species.push_back({"wall", kInfinite, 0.5, {}});
  const double inner = draw.of({1.0, 1.0, 2.0, 0.5, 1.5});
  const bool tethers = draw.once_in(2);
  for (int a = 0; a < kinds; ++a) {
    for (int b = a; b < static_cast<int>(scene.species.size()); ++b) {
      PairLaw law{a, b, BlockingLaw{inner, coefficient(draw)}, {}};
      if (tethers) law.tethering = tethering(draw, inner * draw.of({1.5, 2.0, 3.0}));
      scene.pairs.push_back(law);
    }
  }
  const auto whole = [&](int most) {
    Coordinates x{};
    for (int k = 0; k < scene.dimension; ++k) x[static_cast<std::size_t>(k)] = draw.whole(-most, most);
    if (draw.once_in(3)) x[1] = x[2] = 0;
    return x;
  };
  const Coordinates wind = draw.once_in(3) ? whole(1) : Coordinates{};
  const int wanted = draw.whole(2, 9);
  for (int tries = 0; tries < 60 && static_cast<int>(scene.particles.size()) < wanted; ++tries) {
    const Coordinates at = whole(4);
    if (!is_free(scene, at, inner)) continue;
    const bool wall = walls && draw.once_in(4);
    const Coordinates velocity = wall ? wind : whole(2);
    place(scene, wall ? kinds : draw.whole(0, kinds - 1), at, velocity);
  }
  return scene;
}

/// A ring or a chain whose tethers are taut or touching to the last bit that its circle allows.
Scene taut(Draw& draw) {
  Scene scene;
  scene.dimension = draw.of({2, 3});
  scene.duration = draw.of({3.0, 20.0});
  scene.species.push_back({"bead", draw.of({1.0, 1.0, 0.001}), 0.1, {}});
  const bool ring = draw.once_in(2);
  const int count = ring ? draw.whole(3, 9) : draw.whole(2, 7);
  const double radius = draw.of({1.0, 3.0, 0.1});
  const double apart = ring ? 2 * radius * std::sin(M_PI / count) : draw.of({1.0, 0.1, 1.0 / 3});
  const double outward = draw.of({0.0, 1.0, 0.25}), around = draw.of({0.0, 1.0, 1.0, 1e-8});
  for (int n = 0; n < count; ++n) {
    const double angle = 2 * M_PI * n / count;
    const Coordinates out = ring ? Coordinates{std::cos(angle), std::sin(angle), 0} : Coordinates{1, 0, 0};
    const double sign = ring || n % 2 == 0 ? 1 : -1;
    const Coordinates along{-out[1], out[0], 0};
    Coordinates at{}, v{};
    for (std::size_t k = 0; k < 2; ++k) {
      at[k] = ring ? radius * out[k] : apart * n * out[k];
      v[k] = outward * out[k] * (ring ? 1 : draw.whole(-1, 1)) + around * sign * along[k];
    }
    place(scene, 0, at, v);
    if (n > 0) scene.tethers.push_back({n - 1, n});
  }
  if (ring) scene.tethers.push_back({0, count - 1});
  PairLaw law{0, 0, {}, tethering(draw, apart)};
  law.tethering->breaks = {};
  if (draw.once_in(2)) {
    law.blocking = BlockingLaw{apart * draw.of({0.5, 1 - 0x1p-12, 1 - 0x1p-26}), coefficient(draw)};
  }
  scene.pairs.push_back(law);
  return scene;
}

/// A few spheres of very unequal masses in an enclosure, perhaps one that moves.
Scene enclosed(Draw& draw) {
  Scene scene;
  scene.dimension = draw.of({2, 3});
  scene.duration = 10;
  scene.species.push_back({"big", 1, 0.5, {}});
  scene.species.push_back({"small", std::ldexp(1.0, -draw.whole(0, 60)), draw.of({0.125, 0.01}), {}});
  scene.species.push_back({"around", kInfinite, 3, {}});
  const double c = coefficient(draw);
  scene.pairs.push_back({0, 0, BlockingLaw{1, c}, {}});
  scene.pairs.push_back({0, 1, BlockingLaw{0.5 + scene.species[1].radius, c}, {}});
  scene.pairs.push_back({1, 1, BlockingLaw{2 * scene.species[1].radius, c}, {}});
  for (int s = 0; s < 2; ++s) {
    PairLaw wall{s, 2, {}, tethering(draw, 3 - scene.species[static_cast<std::size_t>(s)].radius)};
    wall.tethering->form = {FormRule::When::permanent, 1};
    wall.tethering->breaks = {};
    scene.pairs.push_back(wall);
  }
  const auto anywhere = [&](double most) {
    Coordinates x{};
    for (int k = 0; k < scene.dimension; ++k) x[static_cast<std::size_t>(k)] = draw.between(-most, most);
    return x;
  };
  place(scene, 2, {}, draw.once_in(3) ? anywhere(1) : Coordinates{});
  const int wanted = draw.whole(3, 8);
  for (int tries = 0; tries < 60 && static_cast<int>(scene.particles.size()) < wanted; ++tries) {
    const Coordinates at = anywhere(1.3);
    const bool clear = std::none_of(
        scene.particles.begin() + 1, scene.particles.end(),
        [&](const Particle& p) { return start_verdict(p.position, at, 1) == StartVerdict::nearer; });
    if (clear) place(scene, draw.whole(0, 1), at, anywhere(2));
  }
  return scene;
}

NastyScene drawn(Draw& draw) {
  NastyScene made;
  switch (draw.whole(0, 4)) {
    case 0:
    case 1:
      made = {"whole_numbers", whole_numbers(draw)};
      break;
    case 2:
      made = {"taut", taut(draw)};
      break;
    case 3:
      made = {"enclosed", enclosed(draw)};
      break;
    default: {
      const rc::Random random(draw.bits());
      made = {"small", runs::small_scene()(random, 100).value().scene};
    }
  }
  change(draw, made);
  return made;
}

}  // namespace

NastyScene nasty_scene(std::uint64_t seed, std::uint64_t n) {
  Draw draw(seed * 0x9e3779b97f4a7c15U + n);
  while (true) {
    NastyScene made = drawn(draw);
    try {
      made.scene = read_scene_text(write_scene(made.scene), "drawn");
      return made;
    } catch (const std::exception&) {
      // A change went beyond what a scene may be: the next one.
    }
  }
}

bool is_resolved(const Scene& scene, const std::string& scalar, const std::string& timing) {
  double largest = 0, smallest = kInfinite;
  const double time = std::isinf(scene.duration) ? 10 : scene.duration;
  double farthest = 0;  // a particle gets, if nothing is in its way
  for (const Particle& p : scene.particles) {
    for (std::size_t k = 0; k < 3; ++k) {
      largest = std::max(largest, std::fabs(p.position[k]));
      farthest = std::max(farthest, std::fabs(p.position[k]) + std::fabs(p.velocity[k]) * time);
    }
  }
  for (const PairLaw& law : scene.pairs) {
    if (law.blocking) smallest = std::min(smallest, law.blocking->distance);
    if (law.tethering) smallest = std::min(smallest, law.tethering->distance);
  }
  // The printed formulas take fourth powers of lengths beside speeds of one.
  if (timing == "paper" && (largest > 0x1p+200 || smallest < 0x1p-200)) return false;
  if (scalar != "float") return true;
  const bool heavy = std::any_of(scene.species.begin(), scene.species.end(), [](const Species& s) {
    return !std::isinf(s.mass) && (s.mass > 0x1p+60 || s.mass < 0x1p-60);
  });
  return !heavy && largest < 0x1p+30 && smallest > 0x1p-30 && farthest < smallest * 4096;
}

}  // namespace tps::properties::campaign

#include "properties/campaign/nasty_changes.hpp"

#include <cmath>
#include <limits>

namespace tps::properties::campaign {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

void kill_coefficients(Draw&, Scene& scene) {
  for (PairLaw& law : scene.pairs) {
    if (law.blocking) law.blocking->c_rebound = 0;
    if (law.tethering) law.tethering->c_retract = law.tethering->c_revolve = 0;
  }
}

void angles_at_their_ends(Draw& draw, Scene& scene) {
  for (PairLaw& law : scene.pairs) {
    if (law.tethering) law.tethering->theta_revolve_deg = draw.of({1e-6, 1e-5, 89.999999, 89.9999, 1e-3});
  }
}

void unequal_masses(Draw& draw, Scene& scene) {
  const int most = draw.of({10, 50, 50, 200});
  for (Species& s : scene.species) {
    if (!std::isinf(s.mass)) s.mass = std::ldexp(s.mass, draw.whole(-most, most));
  }
}

void move_everything(Draw& draw, Scene& scene) {
  const double speed = draw.of({1.0, -3.0, 0.1, 1e6, 1e-9});
  for (Particle& p : scene.particles) {
    for (int k = 0; k < scene.dimension; ++k) p.velocity[static_cast<std::size_t>(k)] += speed;
  }
}

/// All infinite masses get one velocity.
void move_walls(Draw& draw, Scene& scene) {
  Coordinates v{};
  for (int k = 0; k < scene.dimension; ++k) {
    v[static_cast<std::size_t>(k)] = draw.of({0.0, 1.0, -1.0, 0.3, -1e-3});
  }
  for (Particle& p : scene.particles) {
    if (std::isinf(scene.species[static_cast<std::size_t>(p.species)].mass)) p.velocity = v;
  }
}

void far_away(Draw& draw, Scene& scene) {
  const double away = draw.of({0x1p+10, 0x1p+20, 0x1p+30, 1e6 / 3});
  for (Particle& p : scene.particles) {
    for (int k = 0; k < scene.dimension; ++k) {
      p.position[static_cast<std::size_t>(k)] += k == 1 ? -away : away;
    }
  }
}

void stretch(Coordinates& x, double factor) {
  for (double& component : x) component *= factor;
}

/// Lengths times a power of two: with the speeds, or with the times instead.
void rescale(Draw& draw, Scene& scene) {
  const double factor = std::ldexp(1.0, draw.of({300, -300, 250, -250, 150, -150, 30, -30}));
  const bool speeds = draw.once_in(2);
  for (Species& s : scene.species) s.radius *= factor;
  for (PairLaw& law : scene.pairs) {
    if (law.blocking) law.blocking->distance *= factor;
    if (law.tethering) {
      law.tethering->distance *= factor;
      if (speeds) law.tethering->breaks.threshold *= factor;
    }
  }
  for (Particle& p : scene.particles) {
    stretch(p.position, factor);
    if (speeds) stretch(p.velocity, factor);
  }
  for (Phase& phase : scene.phases) {
    if (!speeds) phase.from *= factor, phase.until *= factor;
    if (speeds && phase.breaks) phase.breaks->threshold *= factor;
  }
  for (ScheduledImpulse& impulse : scene.impulses) {
    if (speeds) stretch(impulse.impulse, factor);
    if (!speeds) impulse.at *= factor;
  }
  if (speeds) return;
  scene.duration *= factor;
  if (scene.grouping) scene.grouping->dt_restitute *= factor;
}

void group(Draw& draw, Scene& scene) {
  scene.grouping = Grouping{draw.of({1.0, 0.5, 0.25, 4.0, 0.01, 0.1, 0x1p-20, 0x1p-40, 1e-12, 100.0})};
}

void start_late(Draw& draw, Scene& scene) {
  scene.start_time = draw.of({0x1p+40, -5.0, 0.1, 1e15});
}

/// Impulses at whole and quarter times, some on one particle at one time.
void push(Draw& draw, Scene& scene) {
  const int count = draw.whole(1, 4);
  for (int n = 0; n < count; ++n) {
    const int i = draw.whole(0, static_cast<int>(scene.particles.size()) - 1);
    const double mass =
        scene.species[static_cast<std::size_t>(scene.particles[static_cast<std::size_t>(i)].species)].mass;
    if (std::isinf(mass)) continue;
    ScheduledImpulse impulse{draw.of({0.0, 0.25, 0.5, 1.0, 1.0, 2.0, 3.0}), i, {}};
    for (int k = 0; k < scene.dimension; ++k) {
      impulse.impulse[static_cast<std::size_t>(k)] = mass * draw.whole(-2, 2);
    }
    scene.impulses.push_back(impulse);
  }
}

/// Windows one behind the other, so that one closes where the next opens.
void change_rules(Draw& draw, Scene& scene) {
  for (const PairLaw& law : scene.pairs) {
    if (!law.tethering || law.tethering->form.when == FormRule::When::permanent || draw.once_in(3)) continue;
    double from = draw.whole(0, 2) / 2.0;
    for (int n = draw.whole(1, 3); n > 0; --n) {
      const double until = n == 1 && draw.once_in(2) ? kInfinite : from + draw.of({0.25, 0.5, 1.0});
      Phase phase{from, until, law.species_a, law.species_b, {}, {}};
      phase.form = FormRule{draw.of({FormRule::When::never, FormRule::When::always}), 1};
      if (draw.once_in(2)) {
        phase.breaks = BreakRule{draw.of({BreakRule::When::never, BreakRule::When::always}), 0, 0};
      }
      scene.phases.push_back(phase);
      from = until;
    }
  }
}

void name_otherwise(Draw& draw, Scene& scene) {
  const int step = draw.whole(2, 9), first = draw.whole(0, 5);
  for (Particle& p : scene.particles) p.id = first + step * p.id;
}

struct Change {
  const char* name;
  int once_in;
  void (*make)(Draw&, Scene&);
};

constexpr Change kChanges[] = {
    {"dead", 4, kill_coefficients},
    {"angles", 5, angles_at_their_ends},
    {"masses", 6, unequal_masses},
    {"wind", 8, move_everything},
    {"walls", 4, move_walls},
    {"far", 8, far_away},
    {"grouped", 3, group},
    {"late", 10, start_late},
    {"pushed", 4, push},
    {"phases", 3, change_rules},
    {"ids", 5, name_otherwise},
    {"scaled", 8, rescale},
};

}  // namespace

void change(Draw& draw, NastyScene& made) {
  for (const Change& one : kChanges) {
    if (!draw.once_in(one.once_in)) continue;
    one.make(draw, made.scene);
    made.kind += std::string("+") + one.name;
  }
}

}  // namespace tps::properties::campaign

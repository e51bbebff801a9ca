#include "properties/runs/scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ostream>

#include "properties/runs/choices.hpp"
#include "properties/runs/scene_rules.hpp"
#include "reference/scene/check_starts.hpp"
#include "reference/scene/write_scene.hpp"

namespace tps::properties::runs {
namespace {

using Site = std::array<int, 3>;
using Choice = Wanted::Choice;

double mass_of_species() {
  const int decades = pick({0, 0, 0, 3, 12});
  if (decades == 0) return *rc::gen::inRange(1, 4);
  const int digit = *rc::gen::inRange(1, 10);
  return digit * std::pow(10.0, around_zero(decades));
}

/// Distances in units of the lattice's spacing. Neighbours start 1 apart, give or take what `shift` allows.
struct Limits {
  double inner, outer;
  bool shifted;  ///< particles may be off their sites by 1/16 a coordinate
};

Limits limits(const Wanted& wanted) {
  if (!wanted.ties) return pick({Limits{0.75, 1.5, true}, Limits{0.25, 2, true}});
  const double tight = std::ldexp(1.0, -12);
  return pick({Limits{0.75, 1.5, true}, Limits{1, 1.5, false}, Limits{0.5, 1, false},
               Limits{1 - tight, 1 + tight, false}, Limits{0.25, 2, true}});
}

/// By an angle in the plane of x and y: what was exactly perpendicular then is so but for rounding.
Coordinates turned(const Coordinates& x, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]};
}

bool chosen(Choice choice, int once_in_so_many) {
  return choice == Choice::always || (choice == Choice::maybe && once_in(once_in_so_many));
}

/// Puts a scene together, one choice after the other.
class Assembly {
 public:
  explicit Assembly(const Wanted& wanted) : wanted_(wanted) {}

  Scene scene() {
    scene_.dimension = wanted_.dimension != 0 ? wanted_.dimension : pick({2, 3});
    scene_.duration = *rc::gen::inRange(1, 9);
    contacts_ = wanted_.ties && once_in(10);
    turned_ = contacts_ || (wanted_.ties && once_in(6));
    unit_ = pick({1.0, 0.1, 3.0, std::ldexp(1.0, -20)});
    const bool far = wanted_.ties && !turned_;
    const double away = far ? unit_ * pick({0, 0, 0, 1000, 1 << 20}) : 0;
    origin_ = {away, -away, scene_.dimension == 3 ? away : 0};
    limits_ = contacts_ ? pick({Limits{1, 1.5, false}, Limits{0.5, 1, false}}) : limits(wanted_);
    irregular_ = !wanted_.ties || *rc::gen::arbitrary<bool>();
    add_species();
    add_sites();
    if (wanted_.infinite_masses) add_infinite_masses();
    add_laws();
    add_tethers();
    if (turned_) turn();
    if (chosen(wanted_.grouping, 2)) {
      scene_.grouping = Grouping{pick({0.25, 1.0, 0.01, 4.0, std::ldexp(1.0, -10)})};
    }
    if (wanted_.outside) {
      if (wanted_.phases) add_phase();
      if (wanted_.impulses && once_in(8)) {
        strike_late();
      } else if (wanted_.impulses && once_in(4)) {
        add_impulses(0);
      }
    }
    if (wanted_.draws) scene_.seed = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1000));
    return scene_;
  }

 private:
  static std::size_t at(int n) { return static_cast<std::size_t>(n); }

  void add_species() {
    const int count = *rc::gen::inRange(1, 4);
    for (int n = 0; n < count; ++n) {
      Species s{std::string(1, static_cast<char>('a' + n)), mass_of_species(), unit_ * limits_.inner / 2, {}};
      if (wanted_.changing_tethers && once_in(4)) s.max_tethers = *rc::gen::inRange(1, 3);
      scene_.species.push_back(s);
    }
    finite_species_ = count;
  }

  /// Pair, row, sheet, ring of four, block.
  static std::array<int, 3> box(int dimension) {
    const std::array<int, 3> flat =
        pick({std::array{2, 1, 1}, std::array{3, 1, 1}, std::array{4, 1, 1}, std::array{2, 2, 1},
              std::array{6, 1, 1}, std::array{3, 2, 1}, std::array{4, 2, 1}, std::array{2, 2, 2}});
    return dimension == 2 && flat[2] > 1 ? std::array{3, 2, 1} : flat;
  }

  void add_sites() {
    box_ = contacts_ ? std::array{pick({2, 4, 6, 6, 6}), 1, 1} : box(scene_.dimension);
    const bool one_moves = once_in(5);
    for (int z = 0; z < box_[2]; ++z) {
      for (int y = 0; y < box_[1]; ++y) {
        for (int x = 0; x < box_[0]; ++x) {
          const bool rests = one_moves && !sites_.empty();
          const Coordinates v = rests ? Coordinates{} : velocity();
          add_particle(*rc::gen::inRange(0, finite_species_), {x, y, z}, limits_.shifted, v);
        }
      }
    }
  }

  Coordinates velocity() {
    Coordinates v{};
    for (int k = 0; k < scene_.dimension; ++k) {
      if (contacts_ && k == 0) continue;
      v[at(k)] = unit_ * (irregular_ ? around_zero(3000) / 997.0 : around_zero(3));
    }
    return v;
  }

  void add_particle(int species, const Site& site, bool shifted, const Coordinates& v) {
    Particle p{static_cast<std::int32_t>(scene_.particles.size()), species, origin_, v};
    for (int k = 0; k < scene_.dimension; ++k) {
      const double shift = shifted ? around_zero(irregular_ ? 16 : 1) / (irregular_ ? 263.0 : 16.0) : 0;
      p.position[at(k)] += unit_ * (site[at(k)] + shift);
    }
    scene_.particles.push_back(p);
    sites_.push_back(site);
  }

  /// Walls are neighbours of the lattice's first or last site; an enclosure has its centre amid it. All share
  /// one velocity.
  void add_infinite_masses() {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const bool wall = once_in(4);
    const bool enclosure = once_in(4) && wanted_.tethers;
    if (!wall && !enclosure) return;
    const Coordinates v = once_in(3) ? velocity() : Coordinates{};
    if (wall) {
      wall_ = static_cast<int>(scene_.species.size());
      scene_.species.push_back({"wall", infinite, unit_ * limits_.inner / 2, {}});
      add_particle(wall_, {-1, 0, 0}, false, v);
      if (once_in(2)) add_particle(wall_, {box_[0], 0, 0}, false, v);
    }
    if (enclosure) {
      enclosure_ = static_cast<int>(scene_.species.size());
      scene_.species.push_back({"enclosure", infinite, unit_ * 8, {}});
      add_particle(enclosure_, {box_[0] / 2, box_[1] / 2, box_[2] / 2}, false, v);
    }
  }

  /// Finite species among each other and with walls by the lattice's limits; an enclosure by a permanent
  /// tether.
  void add_laws() {
    tethering_ = !once_in(3) && wanted_.tethers;
    for (int a = 0; a < finite_species_; ++a) {
      for (int b = a; b < static_cast<int>(scene_.species.size()); ++b) {
        PairLaw law{a, b, {}, {}};
        if (b == enclosure_) {
          // From the centre to the farthest site is at most (3.1, 1.1, 1.1).
          law.tethering = tethering_law(wanted_, unit_ * pick({4.0, 3.5}), unit_);
          law.tethering->form = {FormRule::When::permanent, 1};
          law.tethering->breaks = {};
        } else {
          if (contacts_ || !once_in(8))
            law.blocking = BlockingLaw{unit_ * limits_.inner, coefficient_of(wanted_)};
          if (tethering_) law.tethering = tethering_law(wanted_, unit_ * limits_.outer, unit_);
        }
        if (law.blocking || law.tethering) scene_.pairs.push_back(law);
      }
    }
  }

  bool has_room(int i) const {
    const auto& capacity = scene_.species[at(scene_.particles[at(i)].species)].max_tethers;
    const auto holds = [i](const Tether& t) { return t.i == i || t.j == i; };
    return !capacity || std::count_if(scene_.tethers.begin(), scene_.tethers.end(), holds) < *capacity;
  }

  bool are_neighbours(int i, int j) const {
    int steps = 0;
    for (int k = 0; k < 3; ++k) steps += std::abs(sites_[at(i)][at(k)] - sites_[at(j)][at(k)]);
    return steps == 1;
  }

  void add_tethers() {
    if (!tethering_) return;
    const bool all = *rc::gen::arbitrary<bool>();
    const int count = static_cast<int>(scene_.particles.size());
    for (int i = 0; i < count; ++i) {
      for (int j = i + 1; j < count; ++j) {
        const int a = scene_.particles[at(i)].species, b = scene_.particles[at(j)].species;
        const bool possible = a < finite_species_ && b != enclosure_ && are_neighbours(i, j);
        if (!possible || !has_room(i) || !has_room(j)) continue;
        if (all || once_in(2)) scene_.tethers.push_back({i, j});
      }
    }
  }

  void add_impulses(double from) {
    const int count = *rc::gen::inRange(1, 3);
    const int finite = box_[0] * box_[1] * box_[2];
    for (int n = 0; n < count; ++n) {
      ScheduledImpulse impulse{from + *rc::gen::inRange(0, 33) / 4.0, *rc::gen::inRange(0, finite),
                               velocity()};
      for (double& J : impulse.impulse)
        J *= scene_.species[at(scene_.particles[at(impulse.particle)].species)].mass;
      scene_.impulses.push_back(impulse);
    }
  }

  /// Turns the lattice, unless rounding puts a start beyond the 4 ulp that a scene may have.
  void turn() {
    const double angle = *rc::gen::inRange(1, 100);
    std::vector<Particle> particles = scene_.particles;
    for (Particle& p : particles) {
      p.position = turned(p.position, angle);
      p.velocity = turned(p.velocity, angle);
    }
    for (std::size_t i = 0; i < particles.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Coordinates &a = particles[i].position, &b = particles[j].position;
        if (particles[i].species == enclosure_) continue;
        const bool neighbours = are_neighbours(static_cast<int>(i), static_cast<int>(j));
        if (start_verdict(a, b, unit_ * limits_.inner) == StartVerdict::nearer) return;
        if (neighbours && start_verdict(a, b, unit_ * limits_.outer) == StartVerdict::farther) return;
      }
    }
    scene_.particles = particles;
  }

  /// Nothing moves until impulses come when the clock's first number is as coarse as 2^-12.
  void strike_late() {
    for (Particle& p : scene_.particles) p.velocity = {};
    add_impulses(0x1p+40);
    scene_.duration += 0x1p+40;
  }

  void add_phase() {
    if (!wanted_.changing_tethers || !once_in(2)) return;
    std::vector<PairLaw> changing;
    for (const PairLaw& law : scene_.pairs) {
      if (law.tethering && law.tethering->form.when != FormRule::When::permanent) changing.push_back(law);
    }
    if (changing.empty()) return;
    const PairLaw& law = changing[*rc::gen::inRange<std::size_t>(0, changing.size())];
    const double from = *rc::gen::inRange(0, 4) / 4.0;
    const double until = from + pick({0.25, 1.0, std::numeric_limits<double>::infinity()});
    scene_.phases.push_back(
        {from, until, law.species_a, law.species_b, form_rule(wanted_), break_rule(wanted_, unit_)});
  }

  const Wanted wanted_;
  Scene scene_;
  std::vector<Site> sites_;
  std::array<int, 3> box_{};
  Coordinates origin_{};
  Limits limits_{};
  double unit_ = 1;
  int finite_species_ = 0, wall_ = -1, enclosure_ = -1;
  bool irregular_ = false, tethering_ = false, turned_ = false, contacts_ = false;
};

}  // namespace

std::ostream& operator<<(std::ostream& out, const SmallScene& small) {
  return out << write_scene(small.scene, SceneStyle::compact);
}

rc::Gen<SmallScene> small_scene(const Wanted& wanted) {
  return rc::gen::resize(rc::kNominalSize,
                         rc::gen::exec([wanted] { return SmallScene{Assembly(wanted).scene()}; }));
}

}  // namespace tps::properties::runs

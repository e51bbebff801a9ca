#include "verify/cost/enclosed_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/process/interrupt.hpp"
#include "reference/scene/pair_law.hpp"
#include "verify/cost/enclosed_pair.hpp"

namespace tps::cost {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostParticles = 300;  ///< every pair is looked at

/// What a pair may do next.
struct Ahead {
  enum class State { none, certain, open } state = State::none;
  double earliest = 0, latest = kInfinity;  ///< bounds of the event's time
};

class EnclosedScene {
 public:
  EnclosedScene(const Scene& scene, const EnclosedRunOptions& options)
      : scene_(&scene), options_(options), now_(0, options.bits) {
    for (const Particle& particle : scene.particles) add(particle);
    for (std::size_t j = 0; j < bodies_.size(); ++j) {
      for (std::size_t i = 0; i < j; ++i) add_limits(i, j);
    }
    ahead_.resize(limits_.size());
    look();
  }

  EnclosedRun run() {
    EnclosedRun result;
    if (!starts_within_limits()) return {{}, "start"};
    for (std::size_t k = 0; k < limits_.size(); ++k) ahead_[k] = predict(k, false);
    while (result.events.size() < options_.max_events) {
      interrupt::check();
      const Choice choice = next();
      if (!choice.stop.empty()) return {result.events, choice.stop};
      const std::string kind = respond(choice.limit);
      if (kind.empty()) return {result.events, "verdict"};
      const Limit& limit = limits_[choice.limit];
      result.events.push_back("\"kind\":\"" + kind + "\",\"i\":" + std::to_string(bodies_[limit.i].id) +
                              ",\"j\":" + std::to_string(bodies_[limit.j].id));
    }
    result.ends_by = "events";
    return result;
  }

 private:
  struct Choice {
    std::size_t limit = 0;
    std::string stop = {};  ///< as in EnclosedRun::ends_by; empty where there is an event
  };

  void add(const Particle& particle) {
    Body body{particle.id, scene_->species[static_cast<std::size_t>(particle.species)].mass, {}, {}};
    for (std::size_t k = 0; k < 3; ++k) {
      body.offset.push_back(start(particle.position[k]));
      body.velocity.push_back(start(particle.velocity[k]));
    }
    bodies_.push_back(std::move(body));
  }

  /// A number of the start: as it is stored, or all that lie within half an ulp.
  AffineForm start(double x) {
    AffineForm form(x, options_.bits);
    if (options_.starts == Starts::rounding && x != 0) {
      int exponent = 0;
      static_cast<void>(std::frexp(x, &exponent));
      form.widen(std::ldexp(1.0, exponent - 1 - std::numeric_limits<double>::digits), ++symbols_);
    }
    return form;
  }

  void add_limits(std::size_t i, std::size_t j) {
    const PairLaw* law = pair_law(scene_->pairs, scene_->particles[i].species, scene_->particles[j].species);
    if (law == nullptr) return;
    if (law->blocking) {
      limits_.push_back({i, j, true, law->blocking->distance, law->blocking->c_rebound, 0, 0});
    }
    if (!law->tethering) return;
    const bool listed = std::any_of(scene_->tethers.begin(), scene_->tethers.end(), [&](const Tether& t) {
      return static_cast<std::size_t>(t.i) == i && static_cast<std::size_t>(t.j) == j;
    });
    const TetheringLaw& t = *law->tethering;
    if (listed || t.form.when == FormRule::When::permanent) {
      limits_.push_back({i, j, false, t.distance, t.c_retract, t.c_revolve, t.theta_revolve_deg});
    }
  }

  /// A body at base_, in numbers that know nothing of each other.
  struct Glimpse {
    AffineVector place, velocity;
  };

  AffineVector place(const Body& body) const {
    return body.offset + AffineForm(base_, options_.bits) * body.velocity;
  }

  void look() {
    const auto alone = [](const AffineVector& x) {
      return AffineVector{x[0].alone(), x[1].alone(), x[2].alone()};
    };
    glimpses_.clear();
    for (const Body& body : bodies_) glimpses_.push_back({alone(place(body)), alone(body.velocity)});
  }

  /// `sharp`: with all by which the numbers of both hang together; else faster and wider.
  PairMotion motion(std::size_t k, bool sharp) const {
    const Limit& limit = limits_[k];
    const Body &A = bodies_[limit.i], &B = bodies_[limit.j];
    if (sharp) return {place(B) - place(A), B.velocity - A.velocity, limit.distance, options_.bits};
    const Glimpse &a = glimpses_[limit.i], &b = glimpses_[limit.j];
    return {b.place - a.place, b.velocity - a.velocity, limit.distance, options_.bits};
  }

  /// Beyond an inner limit and within an outer one: what real arithmetic keeps from then on.
  bool starts_within_limits() const {
    for (std::size_t k = 0; k < limits_.size(); ++k) {
      if (motion(k, true).c.sign() != (limits_[k].blocks ? CertainSign::positive : CertainSign::negative))
        return false;
    }
    return true;
  }

  /// The time of an event: base_ plus the root. REQUIRES that it is certain.
  AffineForm time_of(const Limit& limit, const PairMotion& m) const {
    return AffineForm(base_, options_.bits) + m.root(limit.blocks);
  }

  /// A pair that has just rebounded cannot meet before something else changes the velocity of one of the two.
  bool rests(const Limit& limit) const {
    return limit.blocks && limit.changes_i == bodies_[limit.i].changes &&
           limit.changes_j == bodies_[limit.j].changes;
  }

  Ahead predict(std::size_t k, bool sharp) const {
    const Limit& limit = limits_[k];
    const PairMotion m = motion(k, sharp);
    const Ahead open{Ahead::State::open, limit.blocks ? m.earliest_contact(base_) : base_};
    if (rests(limit) || m.a.sign() == CertainSign::zero) return {};
    if (m.a.sign() != CertainSign::positive) return open;
    if (limit.blocks) {
      if (m.D.sign() == CertainSign::negative) return {};
      if (m.h.sign() == CertainSign::positive && m.c.sign() == CertainSign::positive) return {};
    }
    if (m.D.sign() != CertainSign::positive) return open;
    const AffineForm t = time_of(limit, m);
    if (limit.blocks) {
      const CertainSign ahead = (t - now_).sign();
      if (ahead == CertainSign::negative) return {};
      if (ahead != CertainSign::positive) return open;
    }
    return {Ahead::State::certain, t.lower(), t.upper()};
  }

  /// The event that comes first for every start.
  Choice next() {
    std::size_t first = first_certain();
    for (std::size_t k = 0; k < limits_.size(); ++k) {
      const auto is_later = [&] {
        return first < limits_.size() && ahead_[k].earliest > ahead_[first].latest;
      };
      if (k == first || ahead_[k].state == Ahead::State::none || is_later()) continue;
      if (ahead_[k].state == Ahead::State::open) {
        ahead_[k] = predict(k, true);
        if (ahead_[k].state == Ahead::State::none || is_later()) continue;
        if (ahead_[k].state == Ahead::State::open) return {0, "verdict"};
      }
      const CertainSign order = first == limits_.size() ? CertainSign::negative : sharp_order(k, first);
      if (order == CertainSign::positive) continue;
      if (order != CertainSign::negative) return {0, "order"};
      first = k;
      k = static_cast<std::size_t>(-1);  // compared with all anew
    }
    if (first == limits_.size()) return {0, "end"};
    const CertainSign left =
        std::isinf(scene_->duration)
            ? CertainSign::positive
            : (AffineForm(scene_->duration, options_.bits) - time_of(limits_[first], motion(first, true)))
                  .sign();
    if (left == CertainSign::positive) return {first};
    return {0, left == CertainSign::negative ? "end" : "order"};
  }

  /// The number of limits where there is none.
  std::size_t first_certain() const {
    std::size_t first = limits_.size();
    for (std::size_t k = 0; k < limits_.size(); ++k) {
      if (ahead_[k].state != Ahead::State::certain) continue;
      if (first == limits_.size() || ahead_[k].latest < ahead_[first].latest) first = k;
    }
    return first;
  }

  /// The sign of the time of k minus that of `other`, with what hangs together.
  CertainSign sharp_order(std::size_t k, std::size_t other) const {
    return (time_of(limits_[k], motion(k, true)) - time_of(limits_[other], motion(other, true))).sign();
  }

  /// Eqs. (3) to (5) at the event. The kind of event; empty where it depends on the start.
  std::string respond(std::size_t k) {
    Limit& limit = limits_[k];
    const PairMotion m = motion(k, true);
    const Response response = response_of(limit, m, options_.bits);
    if (response.kind.empty()) return {};
    AffineForm t = time_of(limit, m);
    t.absorb(++symbols_);
    Body& A = bodies_[limit.i];
    Body& B = bodies_[limit.j];
    give(A, share(A, B), response.lost, t, false);
    give(B, share(B, A), response.lost, t, true);
    now_ = t;
    base_ = now_.lower();
    look();
    if (limit.blocks) {
      limit.changes_i = A.changes;
      limit.changes_j = B.changes;
    }
    for (std::size_t other = 0; other < limits_.size(); ++other) {
      const bool touched = [&](const Limit& l) {
        return l.i == limit.i || l.j == limit.i || l.i == limit.j || l.j == limit.j;
      }(limits_[other]);
      if (touched) ahead_[other] = predict(other, false);
    }
    return response.kind;
  }

  /// m_other / (m + m_other).
  AffineForm share(const Body& body, const Body& other) const {
    if (std::isinf(body.mass)) return {0, options_.bits};
    if (std::isinf(other.mass)) return {1, options_.bits};
    const AffineForm m(body.mass, options_.bits), n(other.mass, options_.bits);
    return n * inverse(m + n);
  }

  /// Changes a velocity by ± part · lost at time t, where the position stays what it is.
  void give(Body& body, const AffineForm& part, const AffineVector& lost, const AffineForm& t, bool minus) {
    if (std::isinf(body.mass)) return;
    for (std::size_t k = 0; k < 3; ++k) {
      const AffineForm change = part * lost[k];
      const AffineForm moved = change * t;
      body.velocity[k] = minus ? body.velocity[k] - change : body.velocity[k] + change;
      body.offset[k] = minus ? body.offset[k] + moved : body.offset[k] - moved;
      body.velocity[k].absorb(++symbols_);
      body.offset[k].absorb(++symbols_);
    }
    ++body.changes;
  }

  const Scene* scene_;
  EnclosedRunOptions options_;
  std::vector<Body> bodies_;
  std::vector<Glimpse> glimpses_;
  std::vector<Limit> limits_;
  std::vector<Ahead> ahead_;
  AffineForm now_;   ///< of the last event
  double base_ = 0;  ///< a double at or before now_, from which roots count
  std::uint32_t symbols_ = 0;
};

}  // namespace

std::string why_not_enclosed(const Scene& scene) {
  if (scene.particles.size() > kMostParticles) return "more than 300 particles";
  if (scene.grouping) return "grouping";
  if (scene.gravity || scene.drag || scene.box || !scene.walls.empty()) return "gravity, drag, box or walls";
  if (!scene.phases.empty() || !scene.impulses.empty()) return "phases or impulses";
  for (const Species& species : scene.species) {
    if (species.random_impulses || species.thermostat) return "random numbers";
  }
  for (const PairLaw& law : scene.pairs) {
    if (law.friction) return "friction";
    if (!law.tethering) continue;
    const bool forms = law.blocking && law.tethering->form.when != FormRule::When::never &&
                       law.tethering->form.when != FormRule::When::permanent;
    if (forms || law.tethering->breaks.when != BreakRule::When::never) return "tethers that form or break";
  }
  return {};
}

EnclosedRun enclosed_run(const Scene& scene, const EnclosedRunOptions& options) {
  return EnclosedScene(scene, options).run();
}

}  // namespace tps::cost

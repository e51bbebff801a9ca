// The detector for many particles: each is asked about its neighbours only, and looks for new ones when it
// leaves its region. docs/scale.md says why no event is missed.
#pragma once

#include <algorithm>
#include <vector>

#include "reference/engine/cells/fetch_ahead.hpp"
#include "reference/engine/cells/neighbourhood.hpp"
#include "reference/engine/cells/outlook.hpp"
#include "reference/engine/cells/pair_events.hpp"
#include "reference/engine/cells/particle_queue.hpp"
#include "reference/engine/cells/region_width.hpp"
#include "reference/engine/detector.hpp"
#include "reference/engine/pair_predictor.hpp"

namespace tps {

template <typename Scalar, int D>
class Cells final : public Detector<Scalar, D> {
 public:
  using Event = PendingEvent<Scalar>;

  /// From how many particles on cells are faster than all pairs (docs/performance.md).
  static constexpr int kWorthwhile = 16;

  /// Whether a scene's box, if it has one, is wide enough to go round it by cells.
  static bool fits(const Scene& scene, const TimingChoice& timing) {
    return !scene.box || RegionPlan::of<Scalar>(scene, timing).fits_into(*scene.box, D);
  }

  /// REQUIRES fits().
  Cells(const World<Scalar, D>& world, const TimingChoice& timing,
        const typename PairPredictor<Scalar, D>::Effects& effects)
      : predictor_(effects), neighbourhood_(world, timing) {}

  void predict_all(World<Scalar, D>& world) override { start(world, false); }

  void predict_touched(World<Scalar, D>& world, const std::vector<int>& touched) override {
    if (touched.empty()) return;
    if (everyone_knows_all_) settle(world);
    looks_since_event_ = 0;
    for (const int i : touched) {
      outlooks_[at(i)].clear();
      if (neighbourhood_.has_level(world, i)) stay_or_move(world, i);
    }
    // All are found before anyone is asked: by then their states are on their way from memory.
    neighbours_.clear();
    ends_.clear();
    for (const int i : touched) {
      const std::size_t before = neighbours_.size();
      neighbourhood_.around(world, i, {}, neighbours_);
      ends_.push_back(neighbours_.size());
      const int level = neighbourhood_.level_of(world, i);
      if (level != RegionPlan::kNone && widths_.touched(level, ends_.back() - before) &&
          neighbourhood_.narrow(level))
        return start(world, false);
    }
    std::size_t n = 0;
    for (std::size_t k = 0; k < touched.size(); ++k) {
      const Asker asker = predictor_.asker(world, touched[k], time_of_asking(world));
      const auto before = touched.begin() + static_cast<std::ptrdiff_t>(k);
      for (; n < ends_[k]; ++n) {
        const int j = neighbours_[n];
        if (!std::binary_search(touched.begin(), before, j)) foresee(asker, touched[k], j);
      }
    }
    take_up_foreseen(world);
    for (const int i : touched) schedule(i);
  }

  Time<Scalar> earliest(World<Scalar, D>& world, const Time<Scalar>& limit) override {
    if (outlooks_.empty()) return Time<Scalar>::never();
    for (;;) {
      const auto due = queue_.earliest(fetching(world));
      if (limit < due.time || is_ready(world, due.particle)) return due.time;
    }
  }

  void collect(World<Scalar, D>& world, const Time<Scalar>& latest, std::vector<Event>& events) override {
    if (outlooks_.empty()) return;
    do {
      due_.clear();
      queue_.due_until(latest, due_, fetching(world));
    } while (!are_ready(world, latest));
    const std::size_t first = events.size();
    for (const int i : due_) append_events(world, i, latest, events);
    keep_each_pair_once(events, first);
    fetch_around(world, neighbourhood_, events, first);
  }

 private:
  using Asker = typename PairPredictor<Scalar, D>::Asker;
  static std::size_t at(int n) { return static_cast<std::size_t>(n); }
  void schedule(int i) { queue_.schedule(i, outlooks_[at(i)].due()); }

  void start(World<Scalar, D>& world, bool everywhere) {
    neighbourhood_.place_all(world, everywhere);
    outlooks_.assign(world.particles.size(), {});
    queue_.reset(world.particles.size());
    widths_.reset(world.particles.size());
    everyone_knows_all_ = everywhere;
    looks_since_event_ = 0;
    asked_at_ = world.now;
    for (int i = 0; i < world.size(); ++i) {
      if (!everywhere && neighbourhood_.has_level(world, i)) set_look(world, i, world.now);
    }
    for (int i = 0; i < world.size(); ++i) {
      const Asker asker = predictor_.asker(world, i, time_of_asking(world));
      for (const int j : around(world, i, {})) {
        if (j > i) foresee(asker, i, j);
      }
      take_up_foreseen(world);
      schedule(i);
    }
  }

  /// Valid until the next call.
  const std::vector<int>& around(const World<Scalar, D>& world, int i, const std::optional<Region<D>>& left) {
    neighbours_.clear();
    neighbourhood_.around(world, i, left, neighbours_);
    return neighbours_;
  }

  /// What those need who are due soon is on its way from memory before they are.
  auto fetching(const World<Scalar, D>& world) const {
    return [&](const std::vector<int>& soon) { fetch_ahead(world, neighbourhood_, outlooks_, soon); };
  }

  /// After everyone was asked about everyone: regions again, and nothing to ask.
  void settle(const World<Scalar, D>& world) {
    everyone_knows_all_ = false;
    neighbourhood_.place_all(world, false);
    for (int i = 0; i < world.size(); ++i) {
      if (!neighbourhood_.has_level(world, i)) continue;
      set_look(world, i, world.now);
      schedule(i);
    }
  }

  /// Keeps a touched particle in its region if it is still there, else files it anew.
  void stay_or_move(const World<Scalar, D>& world, int i) {
    if (!neighbourhood_.roams(i)) {
      const auto leaves = neighbourhood_.leaves(world, i, world.now);
      if (leaves) {
        outlooks_[at(i)].look = *leaves;
        return;
      }
    }
    neighbourhood_.move(world, i, world.now);
    set_look(world, i, world.now);
  }

  /// REQUIRES that the particle is in its region at time t, or roams.
  void set_look(const World<Scalar, D>& world, int i, const Time<Scalar>& t) {
    Time<Scalar>& look = outlooks_[at(i)].look;
    look = Time<Scalar>::never();
    if (neighbourhood_.roams(i) && !world.box) return;
    const auto leaves = neighbourhood_.leaves(world, i, t);
    if (leaves) {
      look = *leaves;
    } else {
      neighbourhood_.set_free(world, i);
      if (world.box) look = *neighbourhood_.leaves(world, i, t);
    }
  }

  /// A particle leaves its region: it is filed anew, and asked about those whom it can meet from there only.
  void look(World<Scalar, D>& world, int i) {
    // As many looks in a row cost as much as asking all pairs: by then nobody may meet anyone any more, and
    // only that would tell.
    const auto n = static_cast<std::uint64_t>(world.size());
    if (++looks_since_event_ > 64 + n * n / 8 && !world.box) {
      start(world, true);
      return;
    }
    const Time<Scalar> t = outlooks_[at(i)].look;
    const std::optional<Region<D>> left = neighbourhood_.move(world, i, t);
    asked_at_ = t;
    set_look(world, i, t);
    const std::vector<int>& met = around(world, i, left);
    const int level = neighbourhood_.level_of(world, i);
    // With regions of another width all start anew, as a run does that is resumed.
    if (widths_.crossed(level, met.size()) && neighbourhood_.widen(world, level)) return start(world, false);
    const Asker asker = predictor_.asker(world, i, time_of_asking(world));
    for (const int j : met) foresee(asker, i, j);
    take_up_foreseen(world);
    schedule(i);
  }

  /// Asks for the next event of a pair. Until it is taken up, the partner's outlook comes from memory.
  void foresee(const Asker& asker, int i, int j) {
    const std::optional<Event> event = asker.foreseen(j);
    if (!event) return;
    outlooks_[at(j)].prefetch();
    foreseen_.push_back({i, j, *event});
  }

  /// Takes events of pairs into the outlooks of both. An infinite mass has none: it never changes, so that
  /// its partner's is enough.
  void take_up_foreseen(const World<Scalar, D>& world) {
    for (const Foreseen<Scalar>& f : foreseen_) {
      add(world, f.asking, f.asked, f.event);
      if (add(world, f.asked, f.asking, f.event)) schedule(f.asked);
    }
    foreseen_.clear();
  }

  /// Images are those of now, or of the last look where that was later: looks come in their order.
  Time<Scalar> time_of_asking(const World<Scalar, D>& world) const {
    return world.now < asked_at_ ? asked_at_ : world.now;
  }

  /// Asks for a meeting of which a particle knows only when it is not yet. @return whether it was one of
  /// those.
  bool ask_if_unasked(const World<Scalar, D>& world, int i, int n) {
    const Partner partner = outlooks_[at(i)].partner(n);
    if (partner.effect != PairPredictor<Scalar, D>::kUnasked) return false;
    const int j = partner.particle;
    const std::optional<Event> event =
        predictor_.earliest(world, std::min(i, j), std::max(i, j), time_of_asking(world));
    for (const auto& [own, other] : {std::pair(i, j), std::pair(j, i)}) {
      outlooks_[at(own)].forget(other);
      if (event) add(world, own, other, *event);
      schedule(own);
    }
    return true;
  }

  /// Asks for the events themselves of a particle, of those whom it can meet.
  template <typename Use>
  void for_each_event(const World<Scalar, D>& world, int i, Use use) {
    const Asker asker = predictor_.asker(world, i, time_of_asking(world));
    for (const int j : around(world, i, {})) {
      if (const std::optional<Event> event = asker.earliest(j)) use(j, *event);
    }
  }

  bool add(const World<Scalar, D>& world, int i, int partner, const Event& event) {
    if (world.fixed(i)) return false;
    outlooks_[at(i)].add(event.time, {partner, world.revision(partner), event.effect});
    return true;
  }

  static bool is_live(const World<Scalar, D>& world, const Partner& partner) {
    return world.revision(partner.particle) == partner.revision;
  }

  /// Drops meetings that a partner's change has voided from the front. @return whether there were any.
  bool drop_void(const World<Scalar, D>& world, int i) {
    const bool dropped = outlooks_[at(i)].drop([&](const Partner& p) { return !is_live(world, p); });
    if (dropped) schedule(i);
    return dropped;
  }

  /// Whether what a particle has due first is an event, or nothing. Else does what is due instead.
  bool is_ready(World<Scalar, D>& world, int i) {
    if (drop_void(world, i)) return false;
    Outlook<Scalar>& outlook = outlooks_[at(i)];
    if (outlook.looks_first()) {
      look(world, i);
      return false;
    }
    if (outlook.knows_first()) return !ask_if_unasked(world, i, 0);
    if (outlook.due() == Time<Scalar>::never()) return true;
    // Times themselves: times before which nothing happens, tied, could give way to each other for ever.
    outlook.clear();
    for_each_event(world, i, [&](int j, const Event& event) { add(world, i, j, event); });
    schedule(i);
    return false;
  }

  /// Whether none of the particles that are due has to look, or to ask, first. Else one of them has.
  bool are_ready(World<Scalar, D>& world, const Time<Scalar>& latest) {
    for (const int i : due_) {
      if (drop_void(world, i)) return false;
      if (outlooks_[at(i)].look <= latest && outlooks_[at(i)].look < Time<Scalar>::never()) {
        look(world, i);
        return false;
      }
      const Outlook<Scalar>& outlook = outlooks_[at(i)];
      for (int n = 0; n < outlook.count() && outlook.time(n) <= latest; ++n) {
        if (is_live(world, outlook.partner(n)) && ask_if_unasked(world, i, n)) return false;
      }
    }
    return true;
  }

  /// The live events of a particle up to `latest`; where its outlook ends before that, all are asked again.
  void append_events(const World<Scalar, D>& world, int i, const Time<Scalar>& latest,
                     std::vector<Event>& events) {
    const Outlook<Scalar>& outlook = outlooks_[at(i)];
    if (outlook.complete_until() <= latest) {
      for_each_event(world, i, [&](int, const Event& event) {
        if (event.time <= latest) events.push_back(event);
      });
      return;
    }
    for (int n = 0; n < outlook.count() && outlook.time(n) <= latest; ++n) {
      const Partner& partner = outlook.partner(n);
      if (!is_live(world, partner)) continue;
      const auto [first, second] = std::minmax(i, partner.particle);
      events.push_back(world.pending(outlook.time(n), Rank::collision, first, second, 0, partner.effect));
    }
  }

  PairPredictor<Scalar, D> predictor_;
  Neighbourhood<Scalar, D> neighbourhood_;
  RegionWidths widths_;
  ParticleQueue<Scalar> queue_;
  LargeVector<Outlook<Scalar>> outlooks_;
  std::vector<Foreseen<Scalar>> foreseen_;  ///< to be taken up
  std::vector<int> due_, neighbours_;
  std::vector<std::size_t> ends_;
  std::uint64_t looks_since_event_ = 0;
  Time<Scalar> asked_at_;  ///< of the last look
  bool everyone_knows_all_ = false;
};

}  // namespace tps
